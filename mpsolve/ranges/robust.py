"""Stable for all parameters of a box: a proof, a certified counterexample in it, or what stays open."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace
from fractions import Fraction
from time import process_time
from typing import TYPE_CHECKING, Any

import numpy as np

from mpsolve.errors import EffortError, InputError, PrecisionError
from mpsolve.numbers.arrays import Reals
from mpsolve.outcome import Status
from mpsolve.parallel.pool import checked_workers
from mpsolve.parallel.threads import one_thread
from mpsolve.problem.cases import Given, as_problem
from mpsolve.problem.problem import Problem
from mpsolve.progress import Progress, silent
from mpsolve.proof.effort import Effort, begun
from mpsolve.proof.stopping import stoppable
from mpsolve.proof.subdivide import Covered, subdivide
from mpsolve.ranges import undamped
from mpsolve.ranges.answer import Interval, Proof, Spent
from mpsolve.ranges.base import base_at, uncounted
from mpsolve.ranges.certified import Base, stable_certificate, verified
from mpsolve.ranges.in_processes import InProcesses
from mpsolve.ranges.never import never_unstable
from mpsolve.ranges.robust_answer import Robust
from mpsolve.ranges.scope import OpenError, Scope, checked_over, from_above_rest, scope_of
from mpsolve.ranges.seen import corners_and_more, count_seen

if TYPE_CHECKING:
    from mpsolve.spectrum.spectrum import Spectrum

_BOXES = 1_000_000
_TRIED = 12  # open boxes at which a root that grows is looked for
_SHOWN = 1000  # open sub-boxes at most


@stoppable
def prove_box(
    problem: Given,
    *,
    over: Mapping[str, Any],
    effort: Effort | None = None,
    progress: Progress | None = None,
    workers: int | None = 1,
    check: bool = True,
) -> Robust:
    """`prove_stable` at once, without a store."""
    given = as_problem(problem)
    ranges = checked_over(problem, over)
    with one_thread():
        found = _robust(given, ranges, effort, progress or silent, check, checked_workers(workers))
    return replace(found, problem=problem)


def at_first_sight(problem: Problem, over: dict[str, Interval], effort: Effort | None, check: bool) -> Robust | None:
    """The answer where no cover is needed: by a theorem, or by a point at which a root grows; else None."""
    with one_thread():
        question = _asked(problem, over, effort, check)
        try:
            return _by_theorem(problem, over, effort, check) or question.counterexample()
        except (EffortError, OpenError):  # parts may tell
            return None


def _by_theorem(problem: Problem, over: dict[str, Interval], effort: Effort | None, check: bool) -> Robust | None:
    why = never_unstable(problem, over)
    if why is not None:
        return Robust(problem, over, Status.UNVERIFIED, stable=True, note=why)
    return _refuted_undamped(problem, over, effort, check) if undamped.no_damping(problem, over) else None


def _refuted_undamped(problem: Problem, over: dict[str, Interval], effort: Effort | None, check: bool) -> Robust:
    """A root that grows where the velocity is greatest, or what is known."""
    started = process_time()
    point = {path: high if path in undamped.SPEEDS else low for path, (low, high) in over.items()}
    found = base_at(undamped.at_corner(problem, point), effort, check)
    cost = Spent.since(started, found)
    if found.stable is False:
        return Robust(problem, over, found.status, cost=cost, stable=False, counterexample=point, spectrum=found)
    return Robust(problem, over, Status.UNDECIDED, *undamped.left_open(problem, over), cost=cost)


def _asked(problem: Problem, over: dict[str, Interval], effort: Effort | None, check: bool) -> _Question:
    started = process_time()
    budget = begun(effort, _BOXES)
    over = from_above_rest(problem, over)
    return _Question(problem, over, scope_of(problem, over), budget, check, started)


@dataclass
class _Question:
    """A box under proof."""

    problem: Problem
    over: dict[str, Interval]
    scope: Scope
    budget: Effort
    check: bool
    started: float

    def cost(self, spectrum: Any = None) -> Spent:
        return Spent.since(self.started, spectrum, boxes=self.budget.spent)

    def certified(self, x: Reals) -> tuple[Mapping[str, Fraction], Spectrum]:
        """The certified spectrum at a float point of x̂, and the point in the problem's units."""
        family = self.scope.family
        exact = [min(max(Fraction(float(t)), a), b) for t, (a, b) in zip(x, family.box, strict=True)]
        point = {path: t * unit for path, t, unit in zip(family.paths, exact, family.units, strict=True)}
        return point, base_at(family.at(exact), self.budget.rest(), self.check)

    def refuted(self, x: Reals) -> Robust | None:
        """The answer where a root grows at this point."""
        point, found = self.certified(x)
        if found.stable is not False:
            return None
        return Robust(
            self.problem,
            self.over,
            found.status,
            cost=self.cost(found),
            stable=False,
            counterexample=point,
            spectrum=found,
        )

    def counterexample(self) -> Robust | None:
        """A corner of the box, or one of some other points, at which a root grows."""
        bad = self.seen(corners_and_more((self.scope.low, self.scope.high)))
        return self.refuted(bad) if bad is not None else None

    def seen(self, points: list[Reals]) -> Reals | None:
        """The first of these points at which floats count a root that grows; None where there is none."""
        family = self.scope.family
        for x in points:
            exact = [min(max(Fraction(float(t)), a), b) for t, (a, b) in zip(x, family.box, strict=True)]
            self.budget.spend(1)
            try:
                count = count_seen(family.reduced(exact), self.scope.X)
            except (InputError, PrecisionError):
                continue
            if count:
                return x
        return None


def _robust(
    problem: Problem, over: dict[str, Interval], effort: Effort | None, progress: Progress, check: bool, workers: int
) -> Robust:
    known = _by_theorem(problem, over, effort, check)
    if known is not None:
        return known
    question = _asked(problem, over, effort, check)
    try:
        return _answer(question, progress, workers)
    except (EffortError, OpenError) as error:
        return Robust(problem, question.over, Status.UNDECIDED, error.reason, cost=question.cost())


def _answer(question: _Question, progress: Progress, workers: int) -> Robust:
    scope = question.scope
    X = scope.X
    progress("counterexample", 0.0)
    found = question.counterexample()
    if found is not None:
        return found
    cover = _cover(question, progress, workers)
    if len(cover.tree.open):
        found = _beside_open(question, cover)
        if found is not None:
            return found
    point, base = question.certified((scope.low + scope.high) / 2)
    if base.stable is False:
        found = question.refuted((scope.low + scope.high) / 2)
        if found is not None:
            return found
    family = scope.family
    proofs = (Proof(question.over, family.units, family.frequency_unit, X, cover, base=base),)
    reason = cover.reason
    if reason is None and base.stable is None:
        reason = uncounted(base, "in the middle of the box")
    common: dict[str, Any] = {"proofs": proofs, "cost": question.cost(base)}
    if reason is not None:
        return Robust(question.problem, question.over, Status.UNDECIDED, reason, open=_open(scope, cover), **common)
    at = Base(tuple(point.values()), base)
    progress("verifying", 0.9)
    made = verified(
        lambda: stable_certificate(scope, cover.tree, at),
        cover.tree.nodes,
        question.budget if question.check else None,
    )
    common |= {"certificate": made.certificate, "note": made.note, "cost": common["cost"].with_check(made.seconds)}
    return Robust(question.problem, question.over, made.status, stable=True, **common)


def _cover(question: _Question, progress: Progress, workers: int) -> Covered:
    scope, budget = question.scope, question.budget
    if workers > 1:
        work = InProcesses.of(scope, question.problem, question.over)
        found = work.cover(budget, workers, progress)
        question.started -= work.seconds  # which other processes took
        return found
    low, high = scope.corners
    return subdivide(low, high, scope.judge(), budget, tell=lambda share: progress("boxes", 0.9 * share))


def _beside_open(question: _Question, cover: Covered) -> Robust | None:
    """A counterexample in one of some open boxes, the smallest first."""
    low, high = cover.tree.boxes(cover.tree.open)
    order = np.argsort((high - low).max(0))
    chosen = order[:: max(1, len(order) // _TRIED)][:_TRIED]
    points = [(low[1:, n] + high[1:, n]) / 2 for n in chosen]
    try:
        bad = question.seen(points)
    except EffortError:
        return None
    return question.refuted(bad) if bad is not None else None


def _open(scope: Scope, cover: Covered) -> tuple[Mapping[str, Interval], ...]:
    """The parameters of open boxes, each once."""
    low, high = cover.tree.boxes(cover.tree.open)
    each = np.unique(np.concatenate([low[1:], high[1:]]).T, axis=0)[:_SHOWN]
    family, k = scope.family, len(scope.low)
    out = []
    for row in each:
        ends = zip(family.paths, family.units, family.box, row[:k], row[k:], strict=True)
        out.append({path: (max(Fraction(float(a)), x) * unit, min(Fraction(float(b)), y) * unit)
                    for path, unit, (x, y), a, b in ends})  # fmt: skip
    return tuple(out)
