"""The onset in one parameter at the worst value of a second one: below it all is stable, whatever the second is.

Crossings of the real axis are the zeros of f(q, x, y) with q real. Let X be a little above x*. No crossing with x ≤ X
lies anywhere in the ranges but in a hole, a box of (q, x, y): a tree of boxes says so. In the hole there is one
crossing at most for each y, and it is followed for all its y: x falls, is convex, and rises along it (or at an end of
the range of y rises from there). So the least x at which any crossing is found, for any y, is x*, where its slope
changes sign or at the end; and below it the number of unstable roots is that at one point, which is certified.
"""

from __future__ import annotations

from contextlib import suppress
from dataclasses import dataclass
from fractions import Fraction
from itertools import product
from math import ceil, log2
from typing import Any

import numpy as np

from mpsolve.errors import EffortError, PrecisionError
from mpsolve.numbers.arrays import Reals
from mpsolve.numbers.balls import arb, precision, rational_ball
from mpsolve.outcome import Reason
from mpsolve.proof.subdivide import Covered, subdivide
from mpsolve.ranges.answer import Proof
from mpsolve.ranges.base import Question, base_at, uncounted
from mpsolve.ranges.curves import CrossingCurve
from mpsolve.ranges.ridge import HALF, Ridge, alone, ridge
from mpsolve.ranges.scope import OpenError
from mpsolve.ranges.seen import count_seen, each_seen
from mpsolve.ranges.stationary import Candidate, Lowest, lowest_near, proved_lowest

_COLUMNS = 6  # values of the second parameter at which crossings are looked for
_CLOSER = 4  # times, each between the neighbours of the lowest column
_WIDTHS = np.append(1.01, 2.0 ** -np.arange(1.0, 12.0))
"""Of the range of the second parameter: half of the holes that are tried."""
_LEAST = 2.0 ** -np.arange(4.0, 10.0, 2.0)  # scaled: half of them along the others, and as shares of the first half
_STARTS = 8  # parts of the range of the second parameter, at whose ends roots that grow are looked for
_PARTS = (8, 32, 128, 512)
_LIFT = 0.4  # of how far the crossing rises to the rim of the hole: the ceiling of the tree
_SPREAD = 1.5
_ALONG, _SLACK = (0.03, 0.3), 1.6  # boxes of parts: of their length along the second, at least, along the others
NEXT = "give shorter ranges"


def _as_low(found: Candidate, least: float) -> bool:
    """Whether Newton's method came to a crossing that is no higher than where it began: it may jump to another."""
    q, x = (complex(value).real for value in found.state)
    return q >= 0 and x <= least * (1 + 2.0**-20)


@dataclass(frozen=True)
class Least:
    """What is proved: value, worst, q: balls in the problem's units; where the worst value lies; None without one.

    A worst value without an onset: there roots grow from the start of the range on.
    """

    value: arb | None
    q: Any | None
    worst: arb | None
    where: str
    proofs: tuple[Proof, ...]


@dataclass
class LeastOnset(Question):
    """Two ranges under proof; the family has the first parameter first."""

    below: Fraction = Fraction(0)  # the value at which its roots were counted

    def answer(self) -> Least:
        """`OpenError` where it stays open; value None where no root grows anywhere, or some from the start on."""
        try:
            return self._least()
        except (OpenError, PrecisionError, EffortError):
            grows = self._from_start()
            if grows is None:
                raise
            return grows

    def _from_start(self) -> Least | None:
        """A value of the second parameter at which certified roots grow at the start of the range of the first."""
        (start, _), (low, high) = self.scope.family.box
        for y in (low + (high - low) * k / _STARTS for k in range(_STARTS + 1)):
            if count_seen(self.scope.family.reduced([start, y]), self.scope.X) == 0:
                continue
            base = base_at(self.scope.family.at([start, y]), self.budget.rest(), self.check)
            if base.unstable:
                where = "start" if y == low else "end" if y == high else "inside"
                return Least(None, None, rational_ball(y * self.scope.family.units[1]), where, ())
        return None

    def _least(self) -> Least:
        self.progress("search", 0.0)
        found = self._found()
        if found is None:
            return self._none()
        hole, curve = self._hole(found)
        ceiling = self._ceiling(found, curve, hole)
        self._require_stable(found)
        low, high = self.scope.corners
        high = high.copy()
        high[1] = ceiling
        judge = self.scope.judge()
        judge.known.append(hole)
        cover = subdivide(low, high, judge, self.budget, tell=lambda share: self.progress("boxes", 0.9 * share))
        if cover.reason is not None:
            raise OpenError(cover.reason)
        goal = ceil(self.digits * log2(10)) + 16
        lowest = proved_lowest(CrossingCurve(self.scope.proved), found, self.scope.family.box[1], goal)
        x = lowest.state[1]
        if not all(curve.holds(state, y) for y, state in lowest.beside) or not x < arb(float(ceiling)):
            raise OpenError(Reason("worst", "the least onset is not proved to lie where it was found", {}, NEXT))
        if not x > rational_ball(self.scope.family.box[0][0]):
            stated = (
                "the least crossing that was found lies before the range, so that roots may grow from its start on"
            )
            raise OpenError(Reason("unstable", stated, {}, "give a range that begins lower"))
        if not x > rational_ball(self.below):
            stated = "the least onset is not proved to lie above the point at which roots were counted"
            raise OpenError(Reason("worst", stated, {}, NEXT))
        return self._in_units(lowest, found.where, self._proof(cover, (hole,)))

    def _found(self) -> Candidate | None:
        """The least crossing that floats lead to, with its place; None where none is seen."""
        (low, high), ends = self.scope.family.box[1], tuple(map(rational_ball, self.scope.family.box[1]))
        curve, columns = CrossingCurve(self.scope.proved), np.linspace(float(low), float(high), _COLUMNS)
        for closer in reversed(range(_CLOSER)):
            seen = each_seen(self.scope.family, columns)
            if not np.isfinite(seen).any():
                return None
            n, step = int(np.nanargmin(seen[1])), float(columns[1] - columns[0])
            q, least, y = float(seen[0, n]), float(seen[1, n]), float(columns[n])
            with suppress(*[PrecisionError] * bool(closer)), precision(80):
                found = lowest_near(curve, (arb(q), arb(least)), y, (ends[0], ends[1]), step)
                if not closer or _as_low(found, least):
                    return found
            columns = np.linspace(max(float(low), y - step), min(float(high), y + step), _COLUMNS)
        return None

    def _hole(self, found: Candidate) -> tuple[tuple[Reals, Reals], Ridge]:
        """(the corners of a box in which one crossing at most is proved for each ŷ, the crossings in it)."""
        y, whole = float(found.x), float(self.scope.high[1] - self.scope.low[1])
        m = np.array([float(found.state[0]), float(found.state[1]), y])
        sizes = []
        for half in (_WIDTHS * whole).tolist():
            at = [[abs(s - c) for s, c in zip(found.beside(sign * half), m, strict=False)] for sign in (-1, 1)]
            for least in [*_LEAST.tolist(), *(_LEAST * half).tolist()]:
                spread = np.maximum(_SPREAD * np.array(at).max(0), least)
                sizes.append(np.array([*spread, half]) / HALF)
        good = alone(self.scope.matrix, np.repeat(m[:, None], len(sizes), 1), np.array(sizes).T)
        ridges: dict[float, Ridge | None] = {}
        for n in np.flatnonzero(good):
            half = sizes[n] * HALF * (1 - 2.0**-20)
            long = float(half[2])
            curve = ridges[long] = ridges[long] if long in ridges else self._ridge(found, long)
            if curve is not None and curve.within(m, sizes[n]):
                return (m - half, m + half), curve
        raise OpenError(Reason("worst", "the least onset is not proved to be alone near where it lies", {}, NEXT))

    def _ridge(self, found: Candidate, half: float) -> Ridge | None:
        """The crossings over all ŷ of the hole within the range, where they are proved to be lowest at one point."""
        y = float(found.x)
        ends = [rational_ball(a) for a in self.scope.family.box[1]]
        low = arb(y - half) if arb(y - half) > ends[0] else ends[0]
        high = arb(y + half) if arb(y + half) < ends[1] else ends[1]

        def path(at: Reals) -> list[Reals]:
            return [np.real(s) for s in found.beside(at - y)]

        for parts, along in product(_PARTS, _ALONG):
            inner = [arb(t) for t in np.linspace(float(low), float(high), parts + 1)[1:-1].tolist()]
            got = ridge(self.scope.matrix, path, [low, *inner, high], _SLACK, along)
            if got is None:
                continue
            if {"inside": got.is_valley, "start": got.rises, "end": got.falls}[found.where]:
                return got
        return None

    def _ceiling(self, found: Candidate, curve: Ridge, hole: tuple[Reals, Reals]) -> float:
        """A float x̂ above the least crossing, which the crossings reach within the hole, about."""
        y, least = float(found.x), float(found.state[1])
        ends = [rational_ball(a) for a in self.scope.family.box[1]]
        rises = [float(hole[1][1]) - least]
        for edge, end in zip((curve.edges[0], curve.edges[-1]), ends, strict=True):
            if not edge.overlaps(end):  # else there is nothing behind it
                step = float(edge) - y
                rises.append(abs(found.slope * step) + found.bend * step**2 / 2)
        return min(least + _LIFT * max(min(rises), 0.0), float(self.scope.high[0]))

    def _require_stable(self, found: Candidate | None) -> None:
        """`OpenError` unless the certified number of unstable roots at a point below is 0."""
        family = self.scope.family
        (x0, x1), (y0, y1) = family.box
        top = x1 if found is None else Fraction(float(found.state[1]))
        point = [x0 + (top - x0) / 2, (y0 + y1) / 2]
        short = [Fraction(np.float32(float(t)).item()) for t in point]
        point = [s if a < s < b else t for s, t, a, b in zip(short, point, (x0, y0), (top, y1), strict=True)]
        self.below = point[0]
        self.base = base_at(family.at(point), self.budget.rest(), self.check)
        if self.base.stable is None:
            raise OpenError(uncounted(self.base, "at one point"))
        if self.base.unstable:
            stated = "roots grow below the least crossing that was found"
            raise OpenError(Reason("unstable", stated, {}, "give a range that begins where all is stable"))

    def _none(self) -> Least:
        """That nothing grows in the ranges."""
        self._require_stable(None)
        low, high = self.scope.corners
        cover = subdivide(low, high, self.scope.judge(), self.budget)
        if cover.reason is not None:
            raise OpenError(cover.reason)
        return Least(None, None, None, "", self._proof(cover, ()))

    def _proof(self, cover: Covered, known: tuple[Any, ...]) -> tuple[Proof, ...]:
        family = self.scope.family
        return (Proof(self.over, family.units, family.frequency_unit, self.scope.X, cover, known, self.base),)

    def _in_units(self, lowest: Lowest, where: str, proofs: tuple[Proof, ...]) -> Least:
        family = self.scope.family
        with precision(ceil(self.digits * log2(10)) + 128):
            first, second = map(rational_ball, family.units)
            q, x = lowest.state
            return Least(x * first, q * rational_ball(family.frequency_unit), lowest.x * second, where, proofs)
