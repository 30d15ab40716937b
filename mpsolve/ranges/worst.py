"""Where in a range of one parameter the least stable root lies lowest: the global minimum of Im q, proved.

A line Im q = h a little above the minimum is crossed downwards and upwards by one root (and its mirror −q̄) alone, as
the proved list of its crossings and the certified roots at one point say; so below the line there is no other root,
anywhere in the range. Over a box of (q, parameter) that holds this root between its crossings it is proved that Im q
bends upwards, or at an end of the range rises from there: so it is lowest where its slope changes its sign, or at the
end.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, replace
from fractions import Fraction
from itertools import pairwise
from math import ceil, inf, log2, nextafter
from time import process_time
from typing import Any

import numpy as np

from mpsolve.certificate.solve import certify_problem, checked_digits
from mpsolve.errors import EffortError, PrecisionError
from mpsolve.numbers.balls import acb, arb, precision, rational_ball
from mpsolve.outcome import Reason, Status
from mpsolve.parallel.threads import one_thread
from mpsolve.problem.cases import Given, as_problem
from mpsolve.problem.problem import Problem
from mpsolve.progress import Progress, silent
from mpsolve.proof.effort import Effort
from mpsolve.ranges.answer import Answer, Interval, Proof, Spent, outward
from mpsolve.ranges.bend import is_convex
from mpsolve.ranges.branch import Tube, tube
from mpsolve.ranges.critical import Candidate, Lowest, at_end, lowest_near, sharpened
from mpsolve.ranges.least_seen import least_seen
from mpsolve.ranges.line import Line, cross_line
from mpsolve.ranges.scope import OpenError, Scope, checked_over, from_above_rest, one_path, scope_of
from mpsolve.spectrum.candidates import Area
from mpsolve.spectrum.regions import Below, HalfPlane
from mpsolve.tracks.at_rest import lowest_cut

_BOXES = 400_000
_SHARES = (2.0**-4, 2.0**-6, 2.0**-9, 2.0**-12)
"""Of the range: how far off, about, the lowest root crosses the line; less where another one is nearly as low."""
_SIDES = {"inside": np.array([-1.0, 1.0]), "start": np.array([1.0]), "end": np.array([-1.0])}
_TUBES = (1, 4, 16, 64, 256)
"""Numbers of boxes in which a root is followed."""
_REACH = 2.0  # scaled: how far roots are looked for in floats
_BELOW = 0.98  # of the height of the cuts
_SEEDS = 4  # times that a lower root elsewhere is taken up
_NEXT = "give a shorter range round the lowest point"


@dataclass(frozen=True)
class Worst(Answer):
    """The lowest root in a range of one parameter: the one that grows fastest, or decays most slowly.

    value, q, growth: balls in the problem's units, growth = −Im q in 1/s; None where undecided. where: "inside" (a
    stationary point), "start" or "end" of the range, "" where undecided. lower, upper: floats that hold `value`.

    Where some root of the range grows, that is the minimum over all roots. Where none does, it is the minimum over
    those below the lowest cut with |Re q| < reach, and no other root has Im q < 0.
    """

    digits: int = 15
    value: Any | None = None
    q: Any | None = None
    where: str = ""
    reach: Fraction | None = None

    @property
    def growth(self) -> Any | None:
        """−Im q, the rate at which it grows: e^{growth t}."""
        return None if self.q is None else -self.q.imag

    @property
    def lower(self) -> float | None:
        """A float at or below `value`."""
        return None if self.value is None else outward(self.value, up=False)

    @property
    def upper(self) -> float | None:
        """A float at or above `value`."""
        return None if self.value is None else outward(self.value, up=True)

    def to_dict(self) -> dict[str, Any]:
        """Plain data for JSON: exact numbers as texts, with decimals beside them."""
        from mpsolve.ranges.answer import plain

        return super().to_dict() | {"growth": plain(self.growth)}

    def rows(self) -> list[Mapping[str, Any]]:
        """The answer as a table, numbers as floats: one mapping."""
        if self.value is None or self.q is None:
            return []
        near = {"value": self.value, "re q": self.q.real, "im q": self.q.imag}
        return [{name: float(ball.mid()) for name, ball in near.items()} | {"where": self.where}]


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
    ranges = checked_over(given, over)
    one_path(ranges)
    with one_thread():
        found = _worst(given, ranges, checked_digits(digits), effort, progress or silent, check)
    return replace(found, problem=problem)


def _worst(
    problem: Problem, over: dict[str, Interval], digits: int, effort: Effort | None, progress: Progress, check: bool
) -> Worst:
    started = process_time()
    budget = effort.anew() if effort is not None else Effort(evaluations=_BOXES)
    over = from_above_rest(problem, over)
    question = _Question(problem, over, scope_of(problem, over), digits, budget, progress, check)
    try:
        answer = question.answer()
    except (OpenError, EffortError) as error:
        answer = question.open(error.reason)
    except PrecisionError as error:
        answer = question.open(Reason("lowest", str(error), {}, _NEXT))
    checked = question.base.cost.verification if question.base is not None else 0.0
    return replace(answer, cost=Spent(process_time() - started - checked, checked, budget.spent))


@dataclass
class _Question:
    """A range under proof."""

    problem: Problem
    over: dict[str, Interval]
    scope: Scope
    digits: int
    budget: Effort
    progress: Progress
    check: bool
    base: Any = None

    def open(self, reason: Reason) -> Worst:
        return Worst(self.problem, self.over, Status.UNDECIDED, reason, digits=self.digits)

    @property
    def _ends(self) -> tuple[Any, Any]:
        return rational_ball(self.scope.family.box[0][0]), rational_ball(self.scope.family.box[0][1])

    def answer(self) -> Worst:
        """Attempts from the lowest root that floats see, and from others where it turns out not to be the lowest."""
        low, high = float(self.scope.low[0]), float(self.scope.high[0])
        reason = Reason("lowest", "two roots are lowest to within what can be told apart", {}, _NEXT)
        for _ in range(_SEEDS):
            found = self._seen(low, high)
            if found is None:
                return self.open(Reason("lowest", "no root is seen below the cuts", {}, "give another range"))
            answer, beside = self._attempts(found)
            if answer is not None:
                return answer
            if beside is None:
                break
            low, high = beside
        return self.open(reason)

    def _seen(self, low: float, high: float) -> Candidate | None:
        self.progress("search", 0.0)
        family = self.scope.family
        area = Area(0.0, _REACH, -1.0, self._top * _BELOW)
        seen = least_seen(family, low, high, area)
        if seen is None:
            return None
        with precision(80):
            return lowest_near(self.scope.proved, seen.q, seen.x, self._ends, seen.step)

    @property
    def _top(self) -> float:
        """About the height of the lowest cut, scaled."""
        base = self.scope.family.base
        return float(lowest_cut(base.problem.track)[0] / base.frequency_unit)

    def _attempts(self, found: Candidate) -> tuple[Worst | None, tuple[float, float] | None]:
        """(the answer, or where else to look for a lower root)."""
        beside = None
        for share in _SHARES:
            width, height = _above(found, share, self.scope, self._top)
            number, reach = self._below(height, found)
            near = [found.beside(step) for step in _SIDES[found.where] * width]
            points = [(abs(q.real), x) for x, q in near]
            line = cross_line(self.scope.family, height, reach, points, self.budget, self.progress)
            if line.reason is not None:
                raise OpenError(line.reason)
            cover = _tube(line, found)
            if cover is not None and number is not None:
                answer = self._proved(line, cover, found, number)
                if answer is not None:
                    return answer, None
            beside = _elsewhere(line, found)
        return None, beside

    def _below(self, height: Fraction, found: Candidate) -> tuple[int | None, float | None]:
        """(the certified number of roots below the line where the lowest one was found, as far as which)."""
        family = self.scope.family
        at = self._at(found)
        h = height * family.frequency_unit
        region = Below(h) if height > 0 else HalfPlane()
        if self.base is None or self.base.problem != family.at([at]) or height > 0:
            self.progress("base", 0.9)
            self.base = certify_problem(family.at([at]), region=region, digits=15, check=self.check)
        if not self.base.proved:
            raise OpenError(self.base.reason or Reason("base", "the roots at one point are not counted", {}, ""))
        counted = self.base.region
        if height > 0 and (not isinstance(counted, Below) or counted.reach is None or counted.radius is not None):
            raise OpenError(Reason("reach", "no frequency bounds the roots at one point", {}, _NEXT))
        reach = _down(counted.reach / family.frequency_unit) if isinstance(counted, Below) and counted.reach else None
        if reach is not None and reach < self.scope.X:
            raise OpenError(Reason("reach", "the contacts are passive from too high a frequency on", {}, _NEXT))
        level, total = rational_ball(h), 0
        for root in self.base.roots:
            if root.q.imag < level:
                total += root.multiplicity
            elif not root.q.imag > level:
                return None, reach
        return total, reach

    def _at(self, found: Candidate) -> Fraction:
        """An exact point next to where the root was found."""
        low, high = self.scope.family.box[0]
        return min(max(Fraction(float(found.x)), low), high)

    def _proved(self, line: Line, cover: Tube, found: Candidate, below: int) -> Worst | None:
        """The answer where it is proved that the root of the tube alone comes below the line."""
        changes = [one.gained for one in line.crossings]
        number = 1 if line.crossings[0].q == 0 else 2
        expected = {"inside": [number, -number], "start": [-number], "end": [number]}[found.where]
        if changes != expected or below != number or not _beyond(line, self._at(found), found.where):
            return None
        goal = ceil(self.digits * log2(10)) + 24
        raised = replace(found, q=found.q - acb(0, rational_ball(line.height)))
        lowest = self._sharp(line, raised, goal)
        if not all(cover.holds(q, x) for x, q in lowest.beside):
            return None
        return self._in_units(line, lowest, found.where)

    def _sharp(self, line: Line, found: Candidate, goal: int) -> Lowest:
        if found.where == "inside":
            return sharpened(line.scope.proved, found, goal)
        end = self.scope.family.box[0][found.where == "end"]
        return at_end(line.scope.proved, found, lambda: rational_ball(end), goal)

    def _in_units(self, line: Line, lowest: Lowest, where: str) -> Worst:
        family = self.scope.family
        with precision(max(int(lowest.q.real.mid().bits()), int(lowest.x.mid().bits()), 53) + 64):
            unit = rational_ball(family.frequency_unit)
            q = (lowest.q + acb(0, rational_ball(line.height))) * unit
            value = lowest.x * rational_ball(family.units[0])
        reach = None if line.reach is None else Fraction(line.reach) * family.frequency_unit
        proof = Proof(
            self.over, family.units, family.frequency_unit, line.scope.X, line.covers[0], line.known, self.base
        )
        return Worst(
            self.problem,
            self.over,
            Status.UNVERIFIED,
            proofs=(proof,),
            digits=self.digits,
            value=value,
            q=q,
            where=where,
            reach=reach,
        )


def _above(found: Candidate, share: float, scope: Scope, top: float) -> tuple[float, Fraction]:
    """(width, a height above the lowest point, a short float): the root crosses it so far beside the point, about."""
    width = share * float(scope.high[0] - scope.low[0])
    least, slope = float(found.q.imag.mid()), 0.0 if found.where == "inside" else abs(found.slope)
    lift = slope * width + max(found.bend, 0.0) * width**2 / 2
    most = -least / 2 if least < 0 else (top - least) / 2
    if lift > most > 0:
        lift = most
        width = min(width, lift / slope if slope else (2 * lift / found.bend) ** 0.5)
    return width, Fraction(float(np.float32(least + lift)))


def _tube(line: Line, found: Candidate) -> Tube | None:
    """The root, followed from one crossing to the other or to the end of the range: lowest at one point, proved."""
    if not 1 <= len(line.crossings) <= 2:
        return None
    ends = [one.x for one in line.crossings]
    if len(ends) == 1:
        exact = rational_ball(line.scope.family.box[0][found.where == "end"])
        ends = [exact, ends[0]] if found.where == "start" else [ends[0], exact]
    path = _path(line, found)
    for number in _TUBES:
        with precision(80):
            middles = [ends[0] + (ends[1] - ends[0]) * k / number for k in range(1, number)]
            edges = [ends[0], *(arb(x.mid()) for x in middles), ends[1]]
        x = np.interp(np.arange(2 * number + 1) / 2, np.arange(number + 1), [float(edge) for edge in edges])
        got = tube(line.scope.matrix, path(x), edges)
        if got is None or not all(got.holds(one.q, one.x) for one in line.crossings):
            continue
        if _is_lowest(got, line, found, path, number == _TUBES[-1]):
            return got
    return None


def _is_lowest(followed: Tube, line: Line, found: Candidate, path: Callable[[Any], Any], last: bool) -> bool:
    """Whether the root is lowest at the end, or falls, is convex, and rises. last: take pains."""
    if found.where != "inside":
        return followed.rises if found.where == "start" else followed.falls
    valley = followed.valley
    if valley is None:
        return False
    if followed.bends_up(*valley):
        return True
    low, high = followed.parts[valley[0]].ends[0], followed.parts[valley[1] - 1].ends[1]
    if not last or not (low < arb(found.x) and arb(found.x) < high):
        return False
    ends = (nextafter(float(low.lower()), -inf), nextafter(float(high.upper()), inf))
    return is_convex(line.scope.matrix, line.scope.proved, path, *ends, found.first)


def _path(line: Line, found: Candidate) -> Callable[[Any], Any]:
    """About the root (seen from the line) at floats x̂: its Taylor polynomial, made to meet the crossings."""
    here, height = float(found.x), float(line.height)
    powers, lacks = [], []
    for one in line.crossings:
        step = float(one.x.mid()) - here
        powers.append([step**k for k in range(3, 3 + len(line.crossings))])
        lacks.append(float(one.q.mid()) + 1j * height - found.beside(step)[1])
    more = np.linalg.lstsq(np.array(powers), np.array(lacks), rcond=None)[0]

    def path(x: Any) -> Any:
        step = x - here
        higher = sum(c * step**k for k, c in enumerate(more, 3))
        return found.beside(step)[1] + higher - 1j * height

    return path


def _beyond(line: Line, x: Fraction, where: str) -> bool:
    """Whether x̂ lies between the crossings, or on the side of the one at which the end is."""
    at = rational_ball(x)
    first, last = line.crossings[0].x, line.crossings[-1].x
    return (where == "start" or bool(at > first)) and (where == "end" or bool(at < last))


def _elsewhere(line: Line, found: Candidate) -> tuple[float, float] | None:
    """The widest part between crossings that does not hold the point that was found."""
    x, best, widest = float(found.x), None, 0.0
    low, high = (float(a) for a in line.scope.family.box[0])
    for a, b in pairwise([low, *(float(one.x.mid()) for one in line.crossings), high]):
        if not a <= x <= b and b - a > widest:
            best, widest = (a, b), b - a
    return best


def _down(x: Fraction) -> float:
    """A float at or below an exact number."""
    value = float(x)
    return value if Fraction(value) <= x else nextafter(value, -inf)
