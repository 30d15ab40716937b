"""All counted zeros in their balls: candidates by AAA, halves of the region counted by themselves where some lack."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field
from fractions import Fraction
from itertools import product

import numpy as np
from flint import acb

from mpsolve.errors import EffortError, InputError, PrecisionError
from mpsolve.numbers.arrays import Complexes
from mpsolve.numbers.balls import exact_ball, precision
from mpsolve.numbers.packed import exact_ends
from mpsolve.numbers.rootball import RootBall
from mpsolve.parallel.threads import one_thread
from mpsolve.progress import Progress
from mpsolve.proof.effort import Effort
from mpsolve.zeros.analytic import Box, cells
from mpsolve.zeros.candidates import poles_by_aaa
from mpsolve.zeros.count import BITS, Count, count_zeros
from mpsolve.zeros.enclose import enclose
from mpsolve.zeros.function import Function
from mpsolve.zeros.geometry import Point, Vertices, box_of, place_of_box

_MANY = 30  # zeros that are looked for at once
_FEW_POINTS = 6  # samples for a zero, at least
_DEEPEST = 40
_DIVISIONS = (Fraction(509, 1000), Fraction(467, 1000), Fraction(547, 1000))
_GRID = 12
_MORE_TERMS = 20  # of the rational function, than zeros
_STEPS, _STILL = 30, 1e-4


@dataclass
class Found:
    """The disjoint balls that are found so far in a polygon."""

    f: Function
    vertices: Vertices
    size: float
    digits: int
    effort: Effort
    power: int = 1
    balls: list[RootBall] = field(default_factory=list)

    def add(self, seed: complex) -> None:
        """What is proved near the seed, where it lies in the polygon and holds more zeros than the balls it meets."""
        z = self._settled(seed)
        if z is None or any(_close(ball, z) for ball in self.balls):
            return
        for ball in enclose(self.f, z, self.size, self.digits, self.power):
            met = [other for other in self.balls if ball.q.overlaps(other.q)]
            if place_of_box(self.vertices, *corners_of(ball)) and ball.multiplicity > sum(
                o.multiplicity for o in met
            ):
                self.balls = [other for other in self.balls if other not in met] + [ball]

    def _settled(self, seed: complex) -> complex | None:
        """Where Newton's method leads in a few steps, if it comes to rest in the polygon, or slowly nears a place."""
        left, right, low, high = map(float, box_of(self.vertices))
        with precision(BITS):
            z = acb(seed)
            for _ in range(_STEPS):
                self.effort.spend(1)
                try:
                    value, slope = self.f.both(z)
                except PrecisionError:
                    return None
                step = value.mid() / slope.mid()
                if not step.is_finite():
                    return seed  # a multiple zero itself, for one
                z = (z - step).mid()
                near, moved = complex(z), abs(complex(step))
                if not (
                    2 * left - right < near.real < 2 * right - left and 2 * low - high < near.imag < 2 * high - low
                ):
                    return None
                if moved < 1e-15 * abs(near):
                    break
        return near if moved < _STILL * self.size else None

    def number(self, vertices: Vertices) -> int:
        """How many zeros the balls hold inside these corners."""
        return sum(ball.multiplicity for ball in self.balls if place_of_box(vertices, *corners_of(ball)))


def _close(ball: RootBall, seed: complex) -> bool:
    """Whether the seed is a zero that is known."""
    middle = complex(ball.q)
    return abs(middle - seed) <= 1e-13 * abs(middle)


def corners_of(ball: RootBall) -> tuple[Point, Point]:
    """The lower left and upper right corner of a ball, exactly."""
    (a, b), (c, d) = exact_ends(ball.q.real), exact_ends(ball.q.imag)
    return (a, c), (b, d)


def find_zeros(f: Function, count: Count, digits: int, effort: Effort, tell: Progress) -> list[RootBall]:
    """Disjoint balls of the counted zeros: all of them, or as many as can be proved. Each part of f has its own."""
    with one_thread():
        return _found(f, count, digits, effort, tell)


def _found(f: Function, count: Count, digits: int, effort: Effort, tell: Progress) -> list[RootBall]:
    size = float(max(map(abs, box_of(count.vertices))))
    balls: list[RootBall] = []
    for k, (part, power) in enumerate(f.parts):
        found = Found(part, count.vertices, size, digits, effort, power)
        if count.totals[k]:
            _search(found, count.of_part(k), count.totals[k] * power, tell)
        balls += found.balls
    return _apart(f, balls, size, digits)


def _apart(f: Function, balls: list[RootBall], size: float, digits: int) -> list[RootBall]:
    """Zeros of different parts that meet, as clusters of f."""
    out: list[RootBall] = []
    for ball in balls:
        met = [other for other in out if ball.q.overlaps(other.q)]
        if met:
            out = [other for other in out if other not in met]
            total = ball.multiplicity + sum(other.multiplicity for other in met)
            joined = enclose(f, complex(ball.q), size, digits)
            out += joined if sum(one.multiplicity for one in joined) == total else [ball, *met]
        else:
            out.append(ball)
    return out


def _search(found: Found, count: Count, total: int, tell: Progress) -> None:
    _by_aaa(found, count)
    if found.number(count.vertices) >= total:
        return
    whole = len(count.vertices) == 4 and not count.cuts and _is_box(count.vertices)
    boxes = [box_of(count.vertices)] if whole else cells(count.vertices, count.cuts)
    stack: list[tuple[Box, int]] = [(box, 0) for box in boxes]
    if whole:
        stack = [(half, 1) for half in _divided(found, boxes[0], count, _DIVISIONS)]
    while stack and found.number(count.vertices) < total:
        box, depth = stack.pop()
        tell("zeros", found.number(count.vertices) / total)
        if place_of_box(found.vertices, (box[0], box[2]), (box[1], box[3])) is False or depth > _DEEPEST:
            continue
        part = _counted(found, box, count)
        if part is not None and part.total:
            _by_aaa(found, part)
        if part is None or found.number(part.vertices) < part.total * found.power:
            if part is not None and depth > _DEEPEST // 2:
                _by_grid(found, box)
                continue
            stack += [(half, depth + 1) for half in _divided(found, box, count, _DIVISIONS)]
        if part is None and depth > 8:
            _by_grid(found, box)
            stack = [one for one in stack if one[1] <= 8]
    if found.number(count.vertices) < total:
        _by_grid(found, box_of(count.vertices))


def _is_box(vertices: Vertices) -> bool:
    return len({p[0] for p in vertices}) == 2 and len({p[1] for p in vertices}) == 2


def _counted(found: Found, box: Box, count: Count) -> Count | None:
    try:
        return count_zeros(found.f, _corners(box), count.cuts, found.effort, BITS, known=True)
    except EffortError:
        raise
    except (PrecisionError, InputError):
        return None


def _corners(box: Box) -> Vertices:
    a, b, c, d = box
    return (a, c), (b, c), (b, d), (a, d)


def _divided(found: Found, box: Box, count: Count, divisions: Sequence[Fraction]) -> list[Box]:
    """Two parts along the longer side, at a place where the count passes if there is one."""
    a, b, c, d = box
    options = []
    for part in divisions:
        if b - a >= d - c:
            m = a + (b - a) * part
            options.append([(a, m, c, d), (m, b, c, d)])
        else:
            m = c + (d - c) * part
            options.append([(a, b, c, m), (a, b, m, d)])
    for option in options:
        if _counted(found, option[0], count) is not None:
            return option
    return options[0]


def _by_aaa(found: Found, count: Count) -> None:
    """Zeros at the poles of f′/f, as far as the path's points tell them."""
    if count.total > _MANY:
        return
    points, slopes = count.points, (count.slopes / count.values)[:, 0]
    if len(points) < _FEW_POINTS * count.total + 20:
        points, slopes = _denser(found.f, points, slopes)
    left, right, low, high = map(float, box_of(count.vertices))
    slack = 0.05 * max(right - left, high - low)
    for z in poles_by_aaa(points, slopes, count.total + _MORE_TERMS).tolist():
        if left - slack < z.real < right + slack and low - slack < z.imag < high + slack:
            found.add(z)


def _denser(f: Function, points: Complexes, slopes: Complexes) -> tuple[Complexes, Complexes]:
    """With three more samples between neighbours."""
    more, rates = [], []
    for p, q in zip(points, np.roll(points, -1), strict=True):
        for part in (0.25, 0.5, 0.75):
            z = complex(p + part * (q - p))
            try:
                value, slope = (complex(x) for x in f.series(exact_ball(z), 2))
            except (PrecisionError, OverflowError):
                continue
            if value and np.isfinite(slope / value):
                more.append(z)
                rates.append(slope / value)
    return np.concatenate([points, more]), np.concatenate([slopes, rates])


def _by_grid(found: Found, box: Box) -> None:
    """Newton's method from a grid."""
    a, b, c, d = map(float, box)
    places = [(k + 0.5) / _GRID for k in range(_GRID)]
    for s, t in product(places, places):
        found.add(complex(a + (b - a) * s, c + (d - c) * t))
