"""Where in a range of one parameter the least stable root lies lowest: the global minimum of Im q, proved."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace
from fractions import Fraction
from time import process_time
from typing import Any

from flint import arb

from mpsolve.certificate.solve import checked_digits
from mpsolve.numbers.plain import plain
from mpsolve.outcome import Status
from mpsolve.parallel.threads import one_thread
from mpsolve.problem.cases import Given, as_problem
from mpsolve.problem.problem import Problem
from mpsolve.progress import Progress, silent
from mpsolve.proof.effort import Effort, begun
from mpsolve.proof.stopping import stoppable
from mpsolve.ranges import undamped
from mpsolve.ranges.answer import Answer, Interval, Valued
from mpsolve.ranges.lowest import NEXT, LowestRoot
from mpsolve.ranges.scope import checked_over, from_above_rest, one_path, scope_of

_BOXES = 400_000
NOTE = "no certificate states where something is lowest yet"


@dataclass(frozen=True)
class Worst(Valued, Answer):
    """The lowest root in a range of one parameter: the one that grows fastest, or decays most slowly.

    value, q, growth: balls in the problem's units, growth = −Im q in 1/s; None where undecided, and where nothing
    grows on a beam without damping, as roots may then be real all over the range. where: "inside" (a stationary
    point), "start" or "end" of the range, "" without a value. lower, upper: floats that hold `value`.

    Where some root of the range grows, that is the minimum over all roots. Where none does, it is the minimum over
    those below the lowest cut with |Re q| < reach, and no other root has Im q < 0.
    """

    digits: int = 15
    value: arb | None = None
    q: Any | None = None
    where: str = ""
    reach: Fraction | None = None

    @property
    def growth(self) -> arb | None:
        """−Im q, the rate at which it grows: e^{growth t}."""
        return None if self.q is None else -self.q.imag

    def to_dict(self) -> dict[str, Any]:
        """Plain data for JSON: exact numbers as texts, with decimals beside them."""
        return super().to_dict() | {"growth": plain(self.growth)}

    def rows(self) -> list[Mapping[str, Any]]:
        """The answer as a table, numbers as floats: one mapping."""
        if self.value is None or self.q is None:
            return []
        near = {"value": self.value, "re q": self.q.real, "im q": self.q.imag}
        return [{name: float(ball.mid()) for name, ball in near.items()} | {"where": self.where}]


@stoppable
def worst(
    problem: Given,
    *,
    over: Mapping[str, Any],
    digits: int = 15,
    effort: Effort | None = None,
    progress: Progress | None = None,
    check: bool = True,
) -> Worst:
    """The value of one parameter in a closed range at which the least Im q over all roots is smallest: proved.

    over: {path: (low, high)}, in the problem's units. check: have the standalone verifier pass the spectrum from
    which the roots are counted. Raises InputError for a path that there is not and for ranges that cannot be.
    """
    given = as_problem(problem)
    ranges = checked_over(problem, over)
    one_path(ranges)
    with one_thread():
        found = _worst(given, ranges, checked_digits(digits), effort, progress or silent, check)
    return replace(found, problem=problem)


def _worst(
    problem: Problem, over: dict[str, Interval], digits: int, effort: Effort | None, progress: Progress, check: bool
) -> Worst:
    if undamped.never_unstable(problem, over):
        return Worst(problem, over, Status.UNVERIFIED, note=undamped.NOTE, digits=digits)
    if undamped.no_damping(problem, over):
        return Worst(problem, over, Status.UNDECIDED, *undamped.left_open(problem, over), digits=digits)
    started = process_time()
    budget = begun(effort, _BOXES)
    over = from_above_rest(problem, over)
    question = LowestRoot(problem, over, scope_of(problem, over), digits, budget, progress, check)
    found, reason, cost = question.told(started, "lowest", NEXT)
    known = vars(found) if found else {}
    status = Status.UNVERIFIED if reason is None else Status.UNDECIDED
    note = NOTE if reason is None else ""
    return Worst(problem, over, status, reason, cost=cost, note=note, digits=digits, **known)
