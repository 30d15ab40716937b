"""A root's ball as it is handed out and written down: a short midpoint on a grid, a fixed radius, a symmetry."""

from __future__ import annotations

import math
from enum import Enum
from fractions import Fraction
from typing import Any

from mpsolve.errors import PrecisionError
from mpsolve.frozen import frozen
from mpsolve.numbers.balls import acb, arb, precision
from mpsolve.numbers.packed import Portable, dyadic, exponent_of


class Symmetry(Enum):
    """Where a root lies as a consequence of its box being symmetric and holding one root."""

    NONE = "none"
    IMAGINARY = "imaginary"  # Re q = 0, from the symmetry q → −q̄
    REAL = "real"  # Im q = 0, from the symmetry q → q̄ of the undamped gap


@frozen
class RootBall(Portable):
    """A ball that is proved to hold exactly `multiplicity` roots of Δ, counted with multiplicity.

    A single root is isolated by interval Newton, a cluster (multiplicity > 1) by Pellet's test. The midpoint
    is a pair of integers times 2^exponent, and the radius of each coordinate RADIUS·2^exponent (0 for one that
    vanishes by symmetry), so that a changed digit is a ball without the root. A cluster's radius is larger by
    2^CLUSTER.
    """

    q: Any
    exponent: int
    multiplicity: int = 1
    symmetry: Symmetry = Symmetry.NONE

    @property
    def in_units(self) -> tuple[int, int, Fraction]:
        """The midpoint in units of 2^exponent, and the larger radius of its coordinates, all exact."""
        unit, parts = Fraction(2) ** self.exponent, (self.q.real, self.q.imag)
        re, im = (int(dyadic(x.mid()) / unit) for x in parts)
        return re, im, max(dyadic(x.rad()) for x in parts)

    @property
    def mirrored(self) -> RootBall:
        """The ball of −q̄, exactly."""
        with precision(2 * self.q.bits() + 64):
            return RootBall(-self.q.conjugate(), self.exponent, self.multiplicity, self.symmetry)

    @property
    def conjugated(self) -> RootBall:
        """The ball of q̄, exactly."""
        with precision(2 * self.q.bits() + 64):
            return RootBall(self.q.conjugate(), self.exponent, self.multiplicity, self.symmetry)


RADIUS = (29, -6)  # 29/64 as mantissa and exponent
CLUSTER = 10  # the grid of a cluster is finer by this many bits than its radius


def radius_of(exponent: int, multiplicity: int) -> arb:
    """The radius of each coordinate of a root ball, exact."""
    return arb((RADIUS[0], RADIUS[1] + exponent + (CLUSTER if multiplicity > 1 else 0)))


_INNER = 0.4  # how far from its grid point, in units, a coordinate of the root may lie


def on_grid(image: acb, goal: int, multiplicity: int, symmetry: Symmetry, least: float = 0.0) -> RootBall:
    """A ball of relative radius below 2^−goal, with a short midpoint, around the much smaller image.

    least: a size below which a root counts as one of this size.
    """
    if not image.is_finite():
        raise PrecisionError("a root was lost while it was sharpened: raise the precision")
    size = max(float(image.abs_lower()), least)
    first = (math.frexp(size)[1] if size > 0 else exponent_of(image.abs_lower())) - 1 - goal
    first -= CLUSTER if multiplicity > 1 else 0
    for exponent in range(first, first - 22, -1):  # two coordinates near grid points: 64 % of all tries
        grid = [x * arb((1, -exponent)) for x in (image.real, image.imag)]
        near = [(x.mid() + arb(0.5)).floor() for x in grid]
        if all(abs(x - n) < _INNER for x, n in zip(grid, near, strict=True)):
            radius = arb(0, radius_of(exponent, multiplicity))
            real, imag = (n * arb((1, exponent)) for n in near)
            if symmetry is not Symmetry.IMAGINARY:
                real += radius
            if symmetry is not Symmetry.REAL:
                imag += radius
            return RootBall(acb(real, imag), exponent, multiplicity, symmetry)
    raise PrecisionError(f"the ball near {image.str(6)} is too wide for its grid: raise the precision")
