"""The cover of a scope by several processes: open boxes are shared out in rounds, and their trees joined."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from time import process_time
from typing import TYPE_CHECKING, Any

from mpsolve.outcome import Reason
from mpsolve.parallel.pool import run
from mpsolve.parallel.threads import one_thread
from mpsolve.problem.family import Interval
from mpsolve.problem.problem import Problem
from mpsolve.progress import Progress
from mpsolve.proof.effort import MORE_EFFORT, Effort
from mpsolve.proof.subdivide import Covered, grafted, halved, subdivide
from mpsolve.ranges.scope import Scope, scope_of

if TYPE_CHECKING:
    from mpsolve.numbers.arrays import Reals

_FIRST = 6  # halvings before the first round
_ROUND, _LEAST = 20_000, 200  # boxes of one piece of work in a round, at most and at least
_QUICK = 0.05  # seconds that a piece may take in any case


@dataclass
class InProcesses:
    """A cover under way, which can be pickled and goes on with another budget.

    tree: what is done so far; spent, seconds: boxes and processor seconds that it took.
    """

    problem: Problem
    over: Mapping[str, Interval]
    X: float
    corners: tuple[Reals, Reals]
    tree: Any = None
    spent: int = 0
    seconds: float = 0.0

    @staticmethod
    def of(scope: Scope, problem: Problem, over: Mapping[str, Interval]) -> InProcesses:
        return InProcesses(problem, dict(over), scope.X, scope.corners)

    def cover(self, budget: Effort, workers: int | None, progress: Progress) -> Covered:
        """All boxes, or those that the budget allows."""
        if self.tree is None:
            self.tree = halved(*self.corners, _FIRST)
        before = self.seconds
        leaves = self.tree.open
        while len(leaves):
            left = None if budget.evaluations is None else budget.evaluations - budget.spent
            time = None if budget.seconds is None else budget.seconds - (self.seconds - before)
            if (left is not None and left < _LEAST * len(leaves)) or (time is not None and time <= 0):
                message = "the effort is spent before all boxes are decided"
                return Covered(self.tree, Reason("effort", message, {"open": str(len(leaves))}, MORE_EFFORT))
            each = _ROUND if left is None else min(_ROUND, left // len(leaves))
            effort = Effort(None if time is None else max(time / len(leaves), _QUICK), each)
            low, high = self.tree.boxes(leaves)
            jobs = [(self.problem, self.over, self.X, low[:, n], high[:, n], effort) for n in range(len(leaves))]
            found = run(_piece, jobs, workers, progress, "boxes")
            self.tree = grafted(self.tree, leaves, [cover.tree for cover, _, _ in found])
            spent = sum(number for _, number, _ in found)
            self.spent += spent
            self.seconds += sum(seconds for _, _, seconds in found)
            budget.spent += spent
            reasons = [cover.reason for cover, _, _ in found if cover.reason is not None]
            other = next((reason for reason in reasons if reason.code != "effort"), None)
            if other is not None:
                return Covered(self.tree, other)
            leaves = self.tree.open
        return Covered(self.tree)


def _piece(job: tuple[Any, ...]) -> tuple[Covered, int, float]:
    started = process_time()
    problem, over, X, low, high, effort = job
    with one_thread():
        scope = scope_of(problem, over)
        vars(scope)["X"] = X  # it was proved for all of the scope
        effort = effort.anew()
        found = subdivide(low, high, scope.judge(), effort)
    return found, effort.spent, process_time() - started
