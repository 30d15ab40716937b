"""A crossing of the real axis in balls: the only real root near a point (q̂, x̂), and the way in which it crosses.

The same for another edge, a straight line of frequencies such as a side of a region, with the roots on it and its
coordinate y in place of q̂.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from fractions import Fraction
from typing import Any

from mpsolve.characteristic.free_proved import FreeProved
from mpsolve.errors import PrecisionError
from mpsolve.numbers.balls import acb, acb_mat, arb, precision, rational_ball
from mpsolve.numbers.reduction import Reduction
from mpsolve.proof import newton, planar
from mpsolve.proof.ladder import climb


@dataclass(frozen=True)
class Edge:
    """The points q̂ = re + i·im + y, or − i·y where it goes down, with real y; the region lies where Im y < 0.

    mirrored: y and −y go together, as q and −q̄ are roots together (re = 0, not down).
    """

    re: Fraction = Fraction(0)
    im: Fraction = Fraction(0)
    down: bool = False

    @property
    def mirrored(self) -> bool:
        return not self.re and not self.down

    @property
    def origin(self) -> complex:
        """σ̂ = iq̂ at y = 0."""
        return complex(-float(self.im), float(self.re))

    @property
    def way(self) -> complex:
        """dσ̂/dy."""
        return 1.0 + 0j if self.down else 1j

    def sigma(self, y: Any) -> acb:
        """σ̂ at a ball y, at the precision that is set."""
        along = acb(arb(y), 0) if self.down else acb(0, y)
        return acb(-rational_ball(self.im), rational_ball(self.re)) + along


REAL_AXIS = Edge()


BASE_BITS = 80
_TRIED = 640
_AT_ZERO = 2.0**-20  # of the box: a crossing this close to q = 0 is first looked for there


@dataclass(frozen=True)
class Crossing:
    """Scaled: q̂ ≥ 0 (exactly 0 for a divergence), x̂; gained: by how much the number of unstable roots grows with x̂.

    q is the coordinate y of an edge. gained: of roots on the side Im y < 0; it counts q and −q̄ together: ±2, and ±1
    at q = 0; None where the root's direction is not proved.
    """

    q: Any
    x: arb
    gained: int | None


@dataclass(frozen=True)
class InPlane:
    """The scalar whose zeros are the roots on the edge, for the last parameter free, as a function of (y, x̂)."""

    proved: FreeProved
    reduction: Reduction
    edge: Edge = REAL_AXIS

    def value(self, y: Any, x: Any) -> acb:
        return self.reduction.scalar(self.proved.matrices(self.edge.sigma(y), [x], slopes=False)[0])

    def slopes(self, y: Any, x: arb) -> tuple[acb, acb]:
        A, (A_sigma, A_x) = self.proved.matrices(self.edge.sigma(y), [x])
        return acb(self.edge.way) * self.reduction.scalar_slope(A, A_sigma), self.reduction.scalar_slope(A, A_x)


@dataclass(frozen=True)
class _AtZero:
    """The same at y = 0, as an analytic function of x̂; real for real x̂ up to a constant factor."""

    proved: FreeProved
    reduction: Reduction
    edge: Edge

    def value(self, x: Any) -> acb:
        return self.reduction.scalar(self.proved.matrices(self.edge.sigma(0), [x], slopes=False)[0])

    def slope(self, x: acb) -> acb:
        return self.both(x)[1]

    def both(self, x: acb) -> tuple[acb, acb]:
        A, (_, A_x) = self.proved.matrices(self.edge.sigma(0), [x])
        return self.reduction.scalar(A), self.reduction.scalar_slope(A, A_x)


def enclose(
    proved: FreeProved,
    seed: tuple[float, float],
    size: tuple[float, float],
    digits: int,
    edge: Edge = REAL_AXIS,
    pains: bool = True,
) -> Crossing:
    """The crossing near `seed` (y, x̂), to so many digits; `PrecisionError` where none is proved. size: of its box.

    pains: whether it is tried again with more bits where it is not found; where there is none that takes long.
    """
    most = _TRIED if pains else BASE_BITS
    goal = math.ceil(digits * math.log2(10)) + 2
    if edge.mirrored and abs(seed[0]) <= _AT_ZERO * size[0]:
        return climb(lambda _: _at_zero(proved, seed[1], size[1], goal, edge), BASE_BITS, most)
    return climb(lambda _: _in_plane(proved, seed, size, goal, edge), BASE_BITS, most)


def _reduction(proved: FreeProved, y: Any, x: arb, edge: Edge) -> Reduction:
    A: acb_mat = proved.matrices(edge.sigma(y), [x], slopes=False)[0]
    return Reduction.of(A, near_root=True)


def _in_plane(
    proved: FreeProved, seed: tuple[float, float], size: tuple[float, float], goal: int, edge: Edge
) -> Crossing:
    at: planar.Point = (arb(seed[0]), arb(seed[1]))
    for _ in range(2):  # the reduction is best made at the zero itself
        f = InPlane(proved, _reduction(proved, at[0], at[1], edge), edge)
        at = planar.polished(f, (float(at[0]), float(at[1])))
    zero = planar.isolated(f, at, (arb(size[0]), arb(size[1])))
    q, x = planar.sharpened(f, zero, goal + 8)
    if edge.mirrored and q < 0:
        q = -q
    if edge.mirrored and not q > 0:
        raise PrecisionError("a crossing lies at q = 0 to within the precision, and is not proved there")
    f_q, f_x = f.slopes(q, x)
    drift = (-f_x / f_q).imag
    gained = -2 if drift > 0 else 2 if drift < 0 else None
    return Crossing(q, x, gained)


def _at_zero(proved: FreeProved, seed: float, size: float, goal: int, edge: Edge) -> Crossing:
    f = _AtZero(proved, _reduction(proved, arb(0), arb(seed), edge), edge)
    middle = newton.polished(f, arb(seed))
    found = newton.isolated(f, acb(middle.real.mid()), arb(size) * 2**8)
    x = newton.sharpened(f, found.image, goal + 8, newton.real_part).real
    with precision(BASE_BITS):
        A, (A_sigma, A_x) = proved.matrices(edge.sigma(0), [x])
        f_sigma, f_x = (f.reduction.scalar_slope(A, slope) for slope in (A_sigma, A_x))
        drift = (-f_x / f_sigma).real  # of σ̂, which grows where it is positive
    gained = 1 if drift > 0 else -1 if drift < 0 else None
    return Crossing(arb(0), x, gained)
