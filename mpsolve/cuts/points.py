"""The values of a parameter at which a root of a beam's whole sheet reaches a cut, and goes to another sheet."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from time import process_time
from typing import Any

from mpsolve.certificate.solve import checked_digits
from mpsolve.cuts.answer import CutPoint, CutPoints
from mpsolve.cuts.reached import Reached, all_reached
from mpsolve.errors import InputError
from mpsolve.numbers.balls import acb, precision, rational_ball
from mpsolve.outcome import Reason, Status
from mpsolve.parallel.threads import one_thread
from mpsolve.problem.cases import Given, as_problem
from mpsolve.problem.family import Family, family_of
from mpsolve.problem.line import line_height
from mpsolve.problem.problem import Problem
from mpsolve.progress import Progress, silent
from mpsolve.proof.effort import Effort, begun
from mpsolve.ranges.answer import Interval, Spent, within
from mpsolve.ranges.scope import LEAST, checked_over, one_path
from mpsolve.tracks.euler_bernoulli import EulerBernoulli

_BOXES = 400_000  # that an answer may take unless effort says otherwise


def cut_points(
    problem: Given,
    *,
    over: Mapping[str, Any],
    digits: int = 15,
    effort: Effort | None = None,
    progress: Progress | None = None,
) -> CutPoints:
    """Every value of one parameter in a closed range at which a root of the whole sheet reaches a cut.

    The track is a beam whose cuts lie on the line Im q = c/2m (the paper's, with damping below critical damping).
    over: {path: (low, high)}, in the problem's units; on beams without tension velocities from 0 begin a little above
    it, as `.over` says. digits: of each value. The answer is proved where the list is complete; else
    `Status.UNDECIDED` with a reason, and the points found, each of them proved: so for one mass next to the velocity
    at which the cuts join, and without damping at it. There are no certificates. Raises
    InputError for other tracks, for a path that there is not and for ranges that cannot be.

    >>> from mpsolve import Case
    >>> case = Case(alpha="0.5", eta_b=0, eta_m=(40, 40), positions=(0, "0.5"))
    >>> found = cut_points(case, over={"v": ("0.5", "0.9")})
    >>> [(point.value.str(12, radius=False), point.side, point.appears) for point in found.points]
    [('0.740466753424', 'gap', False)]
    """
    given = as_problem(problem)
    ranges = checked_over(problem, over)
    one_path(ranges)
    if line_height(given.track) is None:
        stated = "has cuts that do not lie on one line, or no damping below the critical one holds them there"
        raise InputError("track", f"{stated}: cut points are those of an Euler–Bernoulli beam with c² < 4 k m")
    with one_thread():
        found = _find(given, ranges, checked_digits(digits), effort, progress or silent)
    return replace(found, problem=problem)


def _find(
    problem: Problem, over: Mapping[str, Interval], digits: int, effort: Effort | None, progress: Progress
) -> CutPoints:
    started = process_time()
    budget = begun(effort, _BOXES)
    over = from_above_rest(problem, over)
    family = family_of(problem, over)
    found = all_reached(family, digits, budget, progress)
    points, reason = [], found.reason
    for one in found.points:
        point = _in_units(one, family)
        inside = within(point.value, next(iter(over.values())))
        if inside:
            points.append(point)
        elif inside is None:
            reason = reason or Reason("end", "a cut point lies at an end of the range", {}, "give other ends")
    if reason is None and found.reach is not None:
        message = "no theorem tells of roots on the cut at higher frequencies for this vehicle"
        reason = Reason("far", message, {}, "take the points as those below the answer's reach")
    told = None if found.reach is None else found.reach * float(family.frequency_unit)
    return CutPoints(
        problem, over, Status.UNDECIDED if reason else Status.UNVERIFIED, reason, {"points": len(points)},
        cost=Spent.since(started, boxes=budget.spent), digits=digits, points=tuple(points), reach=told,
        note="" if reason else "no certificate states a list of cut points",
    )  # fmt: skip


def from_above_rest(problem: Problem, over: Mapping[str, Interval]) -> Mapping[str, Interval]:
    """Without tension all four p-roots meet where the cut begins at rest: nothing is claimed next to that."""
    ((path, (low, high)),) = over.items()
    slack = isinstance(problem.track, EulerBernoulli) and problem.track.N - problem.track.kp >= 0
    return {path: (high * LEAST, high)} if path in ("v", "alpha") and not low and slack else over


def _in_units(one: Reached, family: Family) -> CutPoint:
    with precision(max(int(one.x.mid().bits()), 53) + 64):
        q = one.q * acb(rational_ball(family.frequency_unit))
        return CutPoint(one.x * rational_ball(family.units[0]), q, one.side, one.appears)


__all__ = ["CutPoint", "CutPoints", "cut_points"]
