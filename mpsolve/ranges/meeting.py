"""Points of a chart that are more than its curves: where two of these cross, and where one of pairs begins at q = 0.

At a crossing two roots are real, q₁ and q₂ at one (x, y): two complex equations in four real unknowns, whose zero is
isolated by interval Newton. If q₂ is 0, on a line of divergences, it is looked for in −b ≤ q₂ ≤ b: zeros come in
pairs ±q₂ there, so the only one has q₂ = 0.

Where a curve of pairs comes to q = 0 both Re s and Im s/q vanish at one (x, y) (see `mirrored`): the end of a chain.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from itertools import combinations_with_replacement
from typing import Any

import numpy as np

from mpsolve.characteristic.free_proved import FreeProved
from mpsolve.errors import PrecisionError
from mpsolve.numbers.arrays import Reals
from mpsolve.numbers.balls import acb, arb, precision, rational_ball
from mpsolve.numbers.packed import Portable
from mpsolve.numbers.reduction import Reduction
from mpsolve.proof import planar
from mpsolve.ranges.boundary import Boundary, Curves
from mpsolve.ranges.scope import Scope

_BITS = 80
_GOAL = 56  # bits of each number
_MOST = 60
_SAME = 1e-7  # of the whole: crossings that are no closer are two
_ASIDE = 2.0**-4  # of the whole: the largest box that is tried


@dataclass(frozen=True)
class Meeting(Portable):
    """A point at which two roots are real, or one pair of them comes to q = 0, proved to be there.

    x, y: balls, in the problem's units; q: the roots, 0 where a root is 0, once where a pair comes to 0.
    """

    x: arb
    y: Any
    q: tuple[Any, ...]

    @property
    def kind(self) -> str:
        """ "two pairs", "pair and divergence" or "pair from q = 0"."""
        if len(self.q) == 1:
            return "pair from q = 0"
        return "pair and divergence" if any(q == 0 for q in self.q) else "two pairs"


def meetings(scope: Scope, curves: Sequence[Boundary]) -> tuple[Meeting, ...]:
    """Those that are found between the curves and proved; the number of such points is not."""
    whole = scope.corners[1] - scope.corners[0]
    units = np.array([float(scope.family.frequency_unit), *map(float, scope.family.units)])
    out = _from_zero(Curves(scope.matrix, False, whole), curves, units)
    seen: list[Any] = []
    size, units = whole[[0, 0, 1, 2]], units[[0, 0, 1, 2]]
    for point in _seeds(curves):
        at = np.array(point) / units
        if len(out) >= _MOST or any((np.abs(at - other) < _SAME * size).all() for other in seen):
            continue
        seen.append(at)
        try:
            with precision(_BITS):
                out.append(_crossing(scope, at, size * _ASIDE))
        except PrecisionError:
            continue
    return tuple(out)


def _from_zero(about: Curves, curves: Sequence[Boundary], units: Reals) -> list[Meeting]:
    """The ends of curves of pairs at q = 0."""
    ends = [(one.x[k], one.y[k]) for one in curves if not one.divergence for k in (0, -1) if one.q[k] == 0]
    if not ends:
        return []
    points = np.array([(0.0, *end) for end in ends]).T / units[:, None]
    middle, radius = ((part * units[:, None])[1:] for part in (points, about.enclosed(points)))
    balls = [
        [arb(m, r) for m, r in zip(*each, strict=True)]
        for each in zip(middle.T.tolist(), radius.T.tolist(), strict=True)
    ]
    return [Meeting(x, y, (arb(0),)) for x, y in balls if x.is_finite() and y.is_finite()]


def _crossing(scope: Scope, at: Reals, size: Any) -> Meeting:
    f = Both.near(scope.proved, at)
    middle = planar.polished(f, at.tolist())
    if at[1] == 0:
        middle = (middle[0], arb(0), *middle[2:])
    zero = planar.isolated(f, middle, tuple(map(arb, size)))
    one, other, x, y = planar.sharpened(f, zero, _GOAL) if at[1] else planar.settled(f, zero)
    other = other if at[1] else arb(0)
    if not (one > 0 and (one - other != 0)):
        raise PrecisionError("two roots of a crossing are not told apart")
    box = zip((x, y), scope.family.box, strict=True)
    if not all(v > rational_ball(a) and v < rational_ball(b) for v, (a, b) in box):
        raise PrecisionError("a crossing is not proved to lie in the range")
    unit = rational_ball(scope.family.frequency_unit)
    x, y = (v * rational_ball(u) for v, u in zip((x, y), scope.family.units, strict=True))
    return Meeting(x, y, (one * unit, other * unit))


@dataclass(frozen=True)
class Both:
    """The scalars of two roots as functions of (q̂₁, q̂₂, x̂, ŷ)."""

    proved: FreeProved
    reductions: tuple[Reduction, Reduction]

    @classmethod
    def near(cls, proved: FreeProved, at: Reals) -> Both:
        x = [arb(v) for v in at[2:].tolist()]
        one, other = (proved.matrices(acb(0, q), x, slopes=False)[0] for q in at[:2].tolist())
        return cls(proved, (Reduction.of(one, near_root=True), Reduction.of(other, near_root=True)))

    def value(self, one: Any, other: arb, x: Any, y: Any) -> tuple[acb, ...]:
        each = zip(self.reductions, (one, other), strict=True)
        return tuple(r.scalar(self.proved.matrices(acb(0, q), [x, y], slopes=False)[0]) for r, q in each)

    def slopes(self, one: Any, other: arb, x: arb, y: Any) -> tuple[tuple[acb, acb, acb, acb], ...]:
        rows = []
        for k, (reduction, q) in enumerate(zip(self.reductions, (one, other), strict=True)):
            A, each = self.proved.matrices(acb(0, q), [x, y])
            by_q, by_x, by_y = (reduction.scalar_slope(A, slope) for slope in each)
            by_q *= acb(0, 1)
            rows.append((by_q, acb(0), by_x, by_y) if k == 0 else (acb(0), by_q, by_x, by_y))
        return tuple(rows)


def _seeds(curves: Sequence[Boundary]) -> Iterator[tuple[float, float, float, float]]:
    """(q₁, q₂, x, y) where polygons through the points of curves cross, in floats; q₂ is 0 if either is."""
    for one, other in combinations_with_replacement(curves, 2):
        if one.divergence and other.divergence:
            continue
        if one.divergence:
            one, other = other, one
        for i, j, t, u in _crossed(one, other):
            if one is other and min(abs(i - j), len(one.x) - 1 - abs(i - j)) < 2:
                continue
            if not one.q[i] or not one.q[i + 1]:
                continue
            q = [float(c.q[k] + s * (c.q[k + 1] - c.q[k])) for c, k, s in ((one, i, t), (other, j, u))]
            x, y = (float(v[i] + t * (v[i + 1] - v[i])) for v in (one.x, one.y))
            yield q[0], q[1], x, y


def _crossed(one: Boundary, other: Boundary) -> Iterator[tuple[int, int, float, float]]:
    """Which steps cross, and after which shares of each."""
    a, b = (np.stack([c.x, c.y]) for c in (one, other))
    r, s = np.diff(a)[:, :, None], np.diff(b)[:, None, :]
    apart = b[:, None, :-1] - a[:, :-1, None]
    with np.errstate(all="ignore"):
        turn = r[0] * s[1] - r[1] * s[0]
        t = (apart[0] * s[1] - apart[1] * s[0]) / turn
        u = (apart[0] * r[1] - apart[1] * r[0]) / turn
    inside = (t >= 0) & (t <= 1) & (u >= 0) & (u <= 1)
    if one is other:
        inside = np.triu(inside)
    for i, j in np.argwhere(inside).tolist():
        yield i, j, float(t[i, j]), float(u[i, j])
