"""The lowest root over a range of one parameter, proved from the crossings of a line a little above it.

The line Im q = h is crossed downwards and upwards by one root (and its mirror −q̄) alone, as the proved list of its
crossings and the certified roots at one point say; so below the line there is no other root, anywhere in the range.
Between its crossings this root is followed: it falls, is convex, and rises, or at an end of the range rises from
there. So it is lowest where its slope changes its sign, or at the end.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from fractions import Fraction
from itertools import pairwise
from math import ceil, log2
from typing import Any

import numpy as np
from flint import arb

from mpsolve.numbers.balls import acb, precision, rational_ball
from mpsolve.numbers.plain import float_beside
from mpsolve.outcome import Reason
from mpsolve.ranges.answer import Proof
from mpsolve.ranges.base import Question, base_at, uncounted
from mpsolve.ranges.curves import RootCurve
from mpsolve.ranges.line import Line, cross_line, follow, stretch
from mpsolve.ranges.scope import OpenError, Scope
from mpsolve.ranges.seen import least_seen
from mpsolve.ranges.stationary import Candidate, Lowest, lowest_near, proved_lowest
from mpsolve.spectrum.candidates import Area
from mpsolve.spectrum.regions import Below, HalfPlane
from mpsolve.tracks.at_rest import lowest_cut

_SHARES = (2.0**-4, 2.0**-6, 2.0**-9, 2.0**-12)
"""Of the range: how far off, about, the lowest root crosses the line; less where another one is nearly as low."""
_CUT = 2.0**-4  # of it: the least that is left of the width where an end of the range is near
_SIDES = {"inside": np.array([-1.0, 1.0]), "start": np.array([1.0]), "end": np.array([-1.0])}
_REACH = 2.0  # scaled: how far roots are looked for in floats
_BELOW = 0.98  # of the height of the cuts
_SEEN = 1e-6  # relative: what floats see is as low as what is certified
_SEEDS = 4  # times that a lower root elsewhere is taken up
NEXT = "give a shorter range round the lowest point"


@dataclass(frozen=True)
class Found:
    """What is proved: see `worst.Worst`."""

    value: arb
    q: Any
    where: str
    reach: Fraction | None
    proofs: tuple[Proof, ...]


class LowestRoot(Question):
    """A range of one parameter under proof."""

    @property
    def _ends(self) -> tuple[arb, arb]:
        return rational_ball(self.scope.family.box[0][0]), rational_ball(self.scope.family.box[0][1])

    def answer(self) -> Found:
        """Attempts from the lowest root that floats see, and from others where it turns out not to be the lowest."""
        low, high = float(self.scope.low[0]), float(self.scope.high[0])
        reason = Reason("lowest", "two roots are lowest to within what can be told apart", {}, NEXT)
        for _ in range(_SEEDS):
            found = self._seen(low, high)
            if found is None:
                raise OpenError(Reason("lowest", "no root is seen below the cuts", {}, "give another range"))
            answer, beside = self._attempts(found)
            if answer is not None:
                return answer
            if beside is None:
                break
            low, high = beside
        raise OpenError(reason)

    def _seen(self, low: float, high: float) -> Candidate | None:
        self.progress("search", 0.0)
        family = self.scope.family
        area = Area(0.0, _REACH, -1.0, self._top * _BELOW)
        seen = least_seen(family, low, high, area)
        if seen is None:
            return None
        with precision(80):
            return lowest_near(RootCurve(self.scope.proved), (acb(seen.q),), seen.x, self._ends, seen.step)

    @property
    def _top(self) -> float:
        """About the height of the lowest cut, scaled."""
        base = self.scope.family.base
        return float(lowest_cut(base.problem.track)[0] / base.frequency_unit)

    def _attempts(self, found: Candidate) -> tuple[Found | None, tuple[float, float] | None]:
        """(the answer, or where else to look for a lower root)."""
        beside = None
        for share in _SHARES:
            width, height = _above(found, share, self.scope, self._top)
            number, reach = self._below(height, found)
            lower = self._lower(found)
            if lower is not None:
                return self._attempts(lower)
            steps = (_SIDES[found.where] * width).tolist()
            points = [(abs(found.beside(step)[0].real), float(found.x) + step) for step in steps]
            line = cross_line(self.scope.family, height, reach, points, self.budget, self.progress)
            if line.reason is not None:
                raise OpenError(line.reason)
            answer = self._proved(line, found, number) if number else None
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
            self.base = base_at(family.at([at]), self.budget.rest(), self.check, region)
        if not self.base.proved:
            raise OpenError(uncounted(self.base, "at one point"))
        counted = self.base.region
        if getattr(counted, "radius", None) is not None or (height > 0 and getattr(counted, "reach", None) is None):
            raise OpenError(Reason("reach", "no frequency bounds the roots at one point", {}, NEXT))
        scaled = counted.reach / family.frequency_unit if isinstance(counted, Below) and counted.reach else None
        reach = None if scaled is None else float_beside(scaled, up=False)
        level, total = rational_ball(h), 0
        for root in self.base.roots:
            if root.q.imag < level:
                total += root.multiplicity
            elif not root.q.imag > level:
                return None, reach
        return total, reach

    def _lower(self, found: Candidate) -> Candidate | None:
        """Where a certified root lies below the one that floats saw, the lowest point near it."""
        unit = rational_ball(self.scope.family.frequency_unit)
        seen = (root.q for root in self.base.roots if not root.q.real < 0)
        q = min(seen, key=lambda q: float(q.imag.mid()), default=None)
        below = found.state[0].imag.mid()
        if q is None or not (q.imag / unit).upper() < below - _SEEN * abs(below):
            return None
        curve, step = RootCurve(self.scope.proved), float(self.scope.high[0] - self.scope.low[0]) * _CUT
        with precision(80):
            return lowest_near(curve, (acb((q / unit).mid()),), float(found.x), self._ends, step)

    def _at(self, found: Candidate) -> Fraction:
        """An exact point next to where the root was found."""
        low, high = self.scope.family.box[0]
        return min(max(Fraction(float(found.x)), low), high)

    def _proved(self, line: Line, found: Candidate, number: int) -> Found | None:
        """The answer where one root alone, with its mirror, comes below the line, and is proved lowest somewhere."""
        ends = stretch(line, number)
        if ends is None or number > 2 or not _in_stretch(line, self._at(found)):
            return None
        cover = follow(line, found, ends)
        if cover is None:
            return None
        goal = ceil(self.digits * log2(10)) + 24
        raised = replace(found, state=(found.state[0] - acb(0, rational_ball(line.height)),))
        lowest = proved_lowest(RootCurve(line.scope.proved), raised, self.scope.family.box[0], goal)
        (q,) = lowest.state
        if not all(cover.holds(root, x) for x, (root,) in lowest.beside) or not q.imag < 0:
            return None
        if number == 2 and not q.real > 0:  # else its mirror may be itself, and the second root another one
            return None
        return self._in_units(line, lowest, found.where)

    def _in_units(self, line: Line, lowest: Lowest, where: str) -> Found:
        family = self.scope.family
        with precision(max(int(lowest.state[0].real.mid().bits()), int(lowest.x.mid().bits()), 53) + 64):
            unit = rational_ball(family.frequency_unit)
            q = (lowest.state[0] + acb(0, rational_ball(line.height))) * unit
            value = lowest.x * rational_ball(family.units[0])
        units = (family.units, family.frequency_unit)
        reach = None if line.reach is None else Fraction(line.reach) * family.frequency_unit
        proofs = tuple(Proof(self.over, *units, line.scope.X, cover, line.known, self.base) for cover in line.covers)
        return Found(value, q, where, reach, proofs)


def _above(found: Candidate, share: float, scope: Scope, top: float) -> tuple[float, Fraction]:
    """(width, a height above the lowest point, a short float): the root crosses it so far beside the point, about."""
    width = share * float(scope.high[0] - scope.low[0])
    aside = min(float(found.x) - scope.low[0], scope.high[0] - float(found.x)) / 2
    if found.where == "inside" and width * _CUT < aside < width:  # crossings on both sides tell the root's path
        width = float(aside)
    least, slope = float(found.state[0].imag.mid()), 0.0 if found.where == "inside" else abs(found.slope)
    lift = slope * width + max(found.bend, 0.0) * width**2 / 2
    most = -least / 2 if least < 0 else (top - least) / 2
    if lift > most > 0:
        lift = most
        width = min(width, lift / slope if slope else (2 * lift / found.bend) ** 0.5)
    return width, Fraction(float(np.float32(least + lift)))


def _in_stretch(line: Line, x: Fraction) -> bool:
    """Whether an exact x̂ lies behind a crossing downwards, and before one upwards."""
    at = rational_ball(x)
    return all(bool(at > one.x) if (one.gained or 0) > 0 else bool(at < one.x) for one in line.crossings)


def _elsewhere(line: Line, found: Candidate) -> tuple[float, float] | None:
    """The widest part between crossings that does not hold the point that was found."""
    x, best, widest = float(found.x), None, 0.0
    low, high = (float(a) for a in line.scope.family.box[0])
    for a, b in pairwise([low, *(float(one.x.mid()) for one in line.crossings), high]):
        if not a <= x <= b and b - a > widest:
            best, widest = (a, b), b - a
    return best
