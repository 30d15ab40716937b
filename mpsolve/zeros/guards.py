"""Which steps of a program need a proof that they are analytic."""

from __future__ import annotations

from collections.abc import Sequence

from mpsolve.zeros.program import CUT, Step, taken


def guards(steps: Sequence[Step]) -> list[int]:
    """The steps that are not analytic everywhere."""
    depends: list[bool] = []
    out = []
    for k, step in enumerate(steps):
        depends.append(step[0] == "z" or any(depends[j] for j in taken(step)))
        if depends[k] and (step[0] in (*CUT, "atan") or (step[0] == "div" and depends[step[2]])):
            out.append(k)
    return out
