"""The values of a parameter at which a root of a beam's whole sheet reaches a cut, and goes to another sheet."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from time import process_time
from typing import Any

from mpsolve.certificate.solve import checked_digits
from mpsolve.cuts.answer import CutPoint, CutPoints
from mpsolve.cuts.balls import InPlane
from mpsolve.cuts.far import far_reach, wavenumber_of
from mpsolve.cuts.search import Found, Search
from mpsolve.errors import InputError, PrecisionError
from mpsolve.numbers.balls import acb, precision, rational_ball
from mpsolve.numbers.reduction import Reduction
from mpsolve.outcome import Reason, Status
from mpsolve.parallel.threads import one_thread
from mpsolve.problem.cases import Given, as_problem
from mpsolve.problem.family import Family, family_of
from mpsolve.problem.line import line_height
from mpsolve.problem.problem import Problem
from mpsolve.progress import Progress, silent
from mpsolve.proof.effort import Effort
from mpsolve.ranges.answer import Interval, Spent, within
from mpsolve.ranges.scope import LEAST, checked_over, one_path
from mpsolve.tracks.euler_bernoulli import EulerBernoulli

_BOXES = 400_000  # that an answer may take unless effort says otherwise
_NEAR = 6.0  # W of what is looked at where no theorem tells of what is far


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
    `Status.UNDECIDED` with a reason, and the points found, each of them proved. There are no certificates. Raises
    InputError for other tracks, for a path that there is not and for ranges that cannot be.

    >>> from mpsolve import Case
    >>> case = Case(alpha="0.5", eta_b=0, eta_m=(40, 40), positions=(0, "0.5"))
    >>> found = cut_points(case, over={"v": ("0.5", "0.9")})
    >>> [(point.value.str(12, radius=False), point.side, point.appears) for point in found.points]
    [('0.740466753424', 'gap', False)]
    """
    given = as_problem(problem)
    ranges = checked_over(given, over)
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
    budget = effort.anew() if effort is not None else Effort(evaluations=_BOXES)
    over = _from_above_rest(problem, over)
    family = family_of(problem, over)
    far = far_reach(family)
    P, reach = wavenumber_of(family, far or _NEAR)
    points: list[CutPoint] = []
    searches = [Search(family, side, P, digits) for side in (-1, 1)]
    reasons = [_low(search, budget, progress) for search in searches]
    if not any(reasons):
        reasons = [search.high_wavenumbers(budget, progress) for search in searches]
    reason = reasons[0] or reasons[1]
    for search in searches:
        for zero in search.found:
            try:
                point = _described(search, zero, family)
            except PrecisionError as error:
                reason = reason or Reason("direction", str(error), {}, "ask for more digits")
                continue
            inside = None if point is None else within(point.value, next(iter(over.values())))
            if inside:
                points += [point] if point and not (point.side == "gap" and search.balls.side > 0) else []
            elif point is not None and inside is None:
                reason = reason or Reason("end", "a cut point lies at an end of the range", {}, "give other ends")
    points.sort(key=lambda point: float(point.value.mid()))
    if reason is None and far is None:
        message = "no theorem tells of roots on the cut at higher frequencies for this vehicle"
        reason = Reason("far", message, {}, "take the points as those below the answer's reach")
    told = None if far else reach * float(family.frequency_unit)
    return CutPoints(
        problem, over, Status.UNDECIDED if reason else Status.UNVERIFIED, reason, {"points": len(points)},
        cost=Spent(process_time() - started, 0.0, budget.spent), digits=digits, points=tuple(points), reach=told,
        note="" if reason else "no certificate states a list of cut points",
    )  # fmt: skip


def _from_above_rest(problem: Problem, over: Mapping[str, Interval]) -> Mapping[str, Interval]:
    """Without tension all four p-roots meet where the cut begins at rest: nothing is claimed next to that."""
    ((path, (low, high)),) = over.items()
    slack = isinstance(problem.track, EulerBernoulli) and problem.track.N - problem.track.kp >= 0
    return {path: (high * LEAST, high)} if path in ("v", "alpha") and not low and slack else over


def _low(search: Search, budget: Effort, progress: Progress) -> Reason | None:
    """Of one side, with no more than its share of the effort, so that the other one has its turn."""
    most = None if budget.evaluations is None else max((budget.evaluations - budget.spent) // 2, 1)
    share = Effort(None if budget.seconds is None else budget.seconds / 2, most)
    reason = search.low_wavenumbers(share, progress)
    budget.spent += share.spent
    return reason


def _described(search: Search, zero: Found, family: Family) -> CutPoint | None:
    """The point in the problem's units; None where it is one of the other side, or a mirror image."""
    balls, side = search.balls, search.balls.side
    with precision(max(int(zero.x.mid().bits()), 53) + 64):
        at = balls.edge(zero.p, zero.x)
        z, lean = at.z.value.real, at.lean.value.real
        if side * lean < 0 or z < 0:
            return None
        if not z > 0:
            raise PrecisionError("a root reaches the cut at Re q = 0, as far as can be told")
        gap = not side * lean > 0
        if gap and not _at_end(search, zero, family):
            raise PrecisionError("which side of the cut a root reaches cannot be told")
        f = InPlane(balls, Reduction.of(balls.matrices(zero.p, zero.x)[0], near_root=True))
        f_p, f_x = f.slopes(zero.p, zero.x)
        drift = (-f_x / f_p).imag  # of p, an upper root: on the sheet its Im p > 0
        if not (drift > 0 or drift < 0):
            raise PrecisionError("whether a root appears at the cut, or goes, cannot be told")
        unit = rational_ball(family.frequency_unit)
        q = acb(z, -at.sigma.value.real) * acb(unit)
        value = zero.x * rational_ball(family.units[0])
        return CutPoint(value, q, "gap" if gap else "below" if side < 0 else "above", bool(drift > 0))


def _at_end(search: Search, zero: Found, family: Family) -> bool:
    """Whether the zero is proved to lie where the cut begins.

    Without losses complex conjugation exchanges p and the p-root b that it meets, so that b is a zero, too: if it
    lies in the box of p, it is p.
    """
    lossless = all(j % 2 == 0 for _, j in family.D_rest) and not any(map(any, family.S[1]))
    partner = search.balls.partner(zero.p, zero.x)
    return lossless and bool(zero.box[0].contains_interior(partner.real))


__all__ = ["CutPoint", "CutPoints", "cut_points"]
