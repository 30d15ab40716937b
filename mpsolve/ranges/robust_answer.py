"""Whether all parameters of a box are stable: the answer as a value."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from fractions import Fraction
from typing import Any

from mpsolve.numbers.model import shown
from mpsolve.ranges.answer import Answer, Interval


@dataclass(frozen=True)
class Robust(Answer):
    """stable: True for all parameters of the box, False with a certified `counterexample` in it, None where open.

    counterexample: the exact parameters by path, and `spectrum`, the certified answer there. open: sub-boxes of
    parameters (exact intervals by path) in which some root may be real.
    """

    stable: bool | None = None
    counterexample: Mapping[str, Fraction] | None = None
    spectrum: Any = None
    open: tuple[Mapping[str, Interval], ...] = ()

    @property
    def trust(self) -> str:
        """How far it is proved; what grows at the counterexample rests on the certified spectrum there."""
        if self.counterexample is None:
            return super().trust
        where = ", ".join(f"{path} = {shown(value)}" for path, value in self.counterexample.items())
        return f"not stable, roots grow at {where}: {self.spectrum.trust}"

    def rows(self) -> list[Mapping[str, float]]:
        """The answer as a table, numbers as floats: one mapping for each row."""
        out: list[Mapping[str, Any]] = []
        for box in self.open:
            ends = [
                (f"{path} {end}", float(x)) for path, (a, b) in box.items() for end, x in (("low", a), ("high", b))
            ]
            out.append(dict(ends))
        return out
