"""A box of parameters round a problem's own values, all over which it is proved stable, as wide as can be had."""

from __future__ import annotations

from collections.abc import Mapping
from fractions import Fraction
from time import process_time

from mpsolve.errors import MpsolveError
from mpsolve.problem.cases import Given, as_problem
from mpsolve.proof.effort import Effort
from mpsolve.ranges.answer import Interval
from mpsolve.ranges.robust import prove_box

_SMALLER = (Fraction(1), Fraction(2, 5), Fraction(1, 10), Fraction(1, 50))


def stable_region(problem: Given, shares: Mapping[str, Fraction], seconds: float) -> dict[str, Interval] | None:
    """The first box that is proved, of ever smaller ones; None where none is, or time is up.

    No certificate is asked for: the verifier would take as long again.
    shares: by path the part of its own value by which a parameter may change in the widest box, below 1.
    """
    own, start = as_problem(problem).parameters, process_time()
    if any(not own.get(path) for path in shares):
        return None
    for smaller in _SMALLER:
        left = seconds - (process_time() - start)
        if left <= 0:
            return None
        over = {
            path: (own[path] * (1 - smaller * share), own[path] * (1 + smaller * share))
            for path, share in shares.items()
        }
        try:
            if prove_box(problem, over=over, effort=Effort(seconds=left), check=False).stable:
                return over
        except MpsolveError:  # the widest box may reach what cannot be, such as a wave speed
            continue
    return None
