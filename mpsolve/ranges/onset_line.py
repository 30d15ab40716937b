"""Onsets in one parameter x for many values y_1, y_2, … of a second one, by one tree of boxes in (q, x, y).

Each crossing x_j is enclosed by itself, with a room round it in which no other lies at y_j. The tree says that at y_j
no root is real for any x of the range up to x_j but in that room (see `asked`). A second tree says that at some x
below all x_j no root is real for any y from the first value to the last. So no root grows there for any y if none
does for one, which is certified; and from there on x_j is the least x at which one can begin.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction
from typing import Any, cast

import numpy as np

from mpsolve.characteristic.boxes import Boxes
from mpsolve.characteristic.free_proved import FreeProved
from mpsolve.errors import InputError, PrecisionError
from mpsolve.numbers.arrays import Reals
from mpsolve.numbers.balls import arb, precision, rational_ball
from mpsolve.numbers.decimals import working_bits
from mpsolve.numbers.jets import UP
from mpsolve.numbers.plain import float_beside
from mpsolve.numbers.realroots import short_between
from mpsolve.parallel.threads import one_thread
from mpsolve.problem.family import family_of
from mpsolve.problem.problem import Problem
from mpsolve.proof.effort import Effort, begun
from mpsolve.proof.subdivide import subdivide
from mpsolve.proof.vanishing import in_plane, one_at_most, scalar
from mpsolve.ranges.answer import Interval
from mpsolve.ranges.asked import Asked, AskedJudge
from mpsolve.ranges.base import base_at
from mpsolve.ranges.curves import Fixed
from mpsolve.ranges.enclosed import Crossing, enclose
from mpsolve.ranges.scope import Scope, from_above_rest, scope_of
from mpsolve.ranges.seen import each_seen

_MORE = 64  # a part of what lies between the start and the last crossing: so much more is in the family
_BOXES = 2_000  # for each value
_SHARES = 2.0 ** -np.arange(0.0, 15.0, 1.5)  # of the size of a room that are tried
_SIZE, _SMALL = 2.0**-3, 2.0**-12  # of half of the range: the largest room; the box in which a crossing is enclosed
_ROOM_BITS = 768  # for the values themselves: more than an enclosure tries


@dataclass(frozen=True)
class OnsetBall:
    """A proved onset and its frequency: balls in the problem's units."""

    value: arb
    q: Any


@dataclass(frozen=True)
class _Met:
    """What is enclosed at the value of number `at`: the crossing, scaled, and the corners of its room in (q̂, x̂)."""

    at: int
    crossing: Crossing
    low: Reals
    high: Reals


def onsets_along(
    problem: Problem,
    over: Mapping[str, Interval],
    along: str,
    values: Sequence[Fraction],
    digits: int,
    effort: Effort | None = None,
) -> list[OnsetBall | None]:
    """For each value of the parameter `along` the onset in the range, None where it is not told.

    A range without onset is not told of.
    """
    none: list[OnsetBall | None] = [None] * len(values)
    if len(values) < 2:
        return none
    order = sorted(range(len(values)), key=lambda k: values[k])
    budget = begun(effort, _BOXES * len(values))
    try:
        with one_thread():
            found = _Line(problem, over, along, [values[k] for k in order], digits, budget).answer()
    except (InputError, PrecisionError):
        return none
    for k, one in zip(order, found, strict=True):
        none[k] = one
    return none


@dataclass
class _Line:
    """A line of questions; values ascending."""

    problem: Problem
    over: Mapping[str, Interval]
    along: str
    values: list[Fraction]
    digits: int
    budget: Effort

    def answer(self) -> list[OnsetBall | None]:
        ((path, (low, high)),) = from_above_rest(self.problem, self.over).items()
        span = (self.values[0], self.values[-1])
        family = family_of(self.problem, {path: (low, high), self.along: span})
        seen = each_seen(family, self._scaled(family.units[1]))
        out: list[OnsetBall | None] = [None] * len(self.values)
        each = np.flatnonzero(np.isfinite(seen[0]))
        if not len(each):
            return out
        first, last = (Fraction(float(f(seen[1][each]))) * family.units[0] for f in (np.min, np.max))
        top = min(high, last + (last - low) / _MORE)
        if not low < first <= last < top:
            return out
        stable = short_between(low, low + (first - low) / 2)
        self._require_stable(path, stable)
        scope = scope_of(self.problem, {path: (low, short_between(last, top)), self.along: span})
        change = float(family.units[0] / scope.family.units[0])
        scale = float(family.frequency_unit / scope.family.frequency_unit)
        crossings = [(n, self._enclosed(scope, n, (seen[0][n] * scale, seen[1][n] * change))) for n in each.tolist()]
        known = self._with_rooms(scope, [(n, one) for n, one in crossings if one is not None])
        for one in self._proved(scope, known):
            out[one.at] = self._in_units(scope, one.crossing, stable)
        return out

    def _scaled(self, unit: Fraction) -> Reals:
        return np.array([float(value / unit) for value in self.values])

    def _require_stable(self, path: str, x: Fraction) -> None:
        """PrecisionError unless no root grows at x for any value between the first and the last."""
        # the family at x alone: a factor is applied after what it scales, which `changed` would do in another order
        scope = scope_of(self.problem, {path: (x, x), self.along: (self.values[0], self.values[-1])})
        cover = subdivide(*scope.corners, scope.judge(), self.budget)
        if cover.reason is not None:
            raise PrecisionError(str(cover.reason))
        (at, _), (a, b) = scope.family.box
        point = [at, short_between(a, b)]
        base = base_at(scope.family.at(point), self.budget.rest(), False)
        if not base.stable or base.unstable:
            raise PrecisionError("roots grow before the first crossing, or are not counted there")

    def _enclosed(self, scope: Scope, n: int, seed: tuple[float, float]) -> Crossing | None:
        with precision(working_bits(self.digits) + _ROOM_BITS):
            y = rational_ball(self.values[n] / scope.family.units[1])
        half = (scope.corners[1] - scope.corners[0])[:2] / 2
        size = np.minimum(1.0, seed[0] / half[0]) * half * _SMALL
        try:
            with precision(80):
                found = enclose(cast(FreeProved, Fixed(scope.proved, y)), seed, tuple(size), self.digits)
        except PrecisionError:
            return None
        # Newton's method may have led to a crossing beyond the family's range, of which the tree says nothing
        with precision(working_bits(self.digits) + 64):
            inside = bool(found.x < rational_ball(scope.family.box[0][1]))
        return found if inside and found.gained is not None and found.gained > 0 else None

    def _with_rooms(self, scope: Scope, found: list[tuple[int, Crossing]]) -> list[_Met]:
        """Those with a room, a box of (q̂, x̂) round the crossing in which one zero at most is proved at its value."""
        if not found:
            return []
        low, high = self._bounds(scope)
        half = (scope.corners[1] - scope.corners[0])[:2, None] / 2
        at = np.array([[float(one.q.mid()), float(one.x.mid())] for _, one in found]).T
        n = np.array([k for k, _ in found])
        size = np.minimum(1.0, at[0] / half[0]) * half * _SIZE
        m = np.vstack([at, (low[n] + high[n]) / 2])
        r = np.vstack([size, np.maximum(high[n] - m[2], m[2] - low[n]) * UP])
        tried = np.vstack([np.repeat(_SHARES, len(n))] * 2 + [np.ones(len(n) * len(_SHARES))])
        boxes = Boxes(np.tile(m, len(_SHARES)), np.tile(r, len(_SHARES)) * tried)
        A, G = scope.matrix(boxes)
        s = scalar(A, G.good)
        good = (s.good & one_at_most(in_plane(s.s))).reshape(len(_SHARES), -1)
        out = []
        for k, (number, one) in enumerate(found):
            if good[:, k].any():
                inner = r[:2, k] * _SHARES[good[:, k].argmax()] * 0.49
                met = _Met(number, one, at[:, k] - inner, at[:, k] + inner)
                if _inside(one, met):
                    out.append(met)
        return out

    def _bounds(self, scope: Scope) -> tuple[Reals, Reals]:
        """Floats at or below, and at or above, each value, scaled."""
        exact = [value / scope.family.units[1] for value in self.values]
        low, high = (np.array([float_beside(x, up) for x in exact]) for up in (False, True))
        return low, high

    def _proved(self, scope: Scope, known: list[_Met]) -> list[_Met]:
        """Those before which nothing else crosses."""
        if not known:
            return []
        ends = [np.nextafter(float(one.crossing.x.upper()), np.inf) for one in known]
        at = [one.at for one in known]
        low, high = (a[at] for a in self._bounds(scope))
        rooms = [np.array([getattr(one, side) for one in known]).T for side in ("low", "high")]
        asked = Asked(low, high, np.array(ends), rooms[0], rooms[1])
        judge = AskedJudge(scope.judge(), asked)
        cover = subdivide(*scope.corners, judge, self.budget)
        open_ = cover.tree.boxes(cover.tree.open)
        missed = asked.needed(*open_).any(0) if len(open_[0][0]) else np.zeros(len(known), bool)
        return [one for one, lost in zip(known, missed, strict=True) if not lost]

    def _in_units(self, scope: Scope, one: Crossing, stable: Fraction) -> OnsetBall | None:
        """None unless the crossing lies above the value at which nothing grows."""
        with precision(working_bits(self.digits) + 64):
            x, q = one.x * rational_ball(scope.family.units[0]), one.q * rational_ball(scope.family.frequency_unit)
            return OnsetBall(x, q) if x > rational_ball(stable) else None


def _inside(one: Crossing, met: _Met) -> bool:
    """Whether the enclosed zero lies in the room."""
    return all(
        bool(ball > arb(float(low))) and bool(ball < arb(float(high)))
        for ball, low, high in zip((one.q, one.x), met.low, met.high, strict=True)
    )
