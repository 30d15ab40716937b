"""Enclosures: a root of Δ̂ in a ball of any number of digits, proved to be the only one near it.

Near a root the determinant is reduced to the scalar s of `numbers.reduction`, whose zeros are those of Δ̂; interval
Newton isolates the zero and sharpens it. A box that is symmetric to the imaginary q-axis (σ real) and holds one root
holds one on that axis, as roots come in pairs q, −q̄.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from enum import Enum
from fractions import Fraction
from functools import cached_property
from typing import Any

from mpsolve.characteristic.proved import Proved
from mpsolve.errors import PrecisionError
from mpsolve.numbers.balls import acb, arb, precision, rational_ball
from mpsolve.numbers.packed import Portable
from mpsolve.numbers.reduction import Reduction
from mpsolve.proof.ladder import climb
from mpsolve.proof.newton import Isolated, isolated, polished, sharpened

BASE_BITS = 80
_GUARD = 24
_TRIED = 640
"""Bits at which a root that no box isolates is left to the search for clusters."""
_NEAR_AXIS = 2.0**-30
_APPROACH, _CLOSE = 3, 2.0**-16


class Symmetry(Enum):
    """Where a root lies as a consequence of its box being symmetric and holding one root."""

    NONE = "none"
    IMAGINARY = "imaginary"  # Re q = 0, from the symmetry q → −q̄
    REAL = "real"  # Im q = 0, from the symmetry q → q̄ of the undamped gap


@dataclass(frozen=True)
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
    def mirrored(self) -> RootBall:
        """The ball of −q̄, exactly."""
        with precision(2 * self.q.bits() + 64):
            return RootBall(-self.q.conjugate(), self.exponent, self.multiplicity, self.symmetry)


RADIUS = (29, -6)  # 29/64 as mantissa and exponent
CLUSTER = 10  # the grid of a cluster is finer by this many bits than its radius


def radius_of(exponent: int, multiplicity: int) -> Any:
    """The radius of each coordinate of a root ball, exact."""
    return arb((RADIUS[0], RADIUS[1] + exponent + (CLUSTER if multiplicity > 1 else 0)))


_INNER = 0.4  # how far from its grid point, in units, a coordinate of the root may lie


@dataclass(frozen=True)
class Scalar:
    """The scalar to which the determinant is reduced near one root, as a function of σ."""

    proved: Proved
    reduction: Reduction

    def value(self, sigma: Any) -> Any:
        return self.reduction.scalar(self.proved.matrices(sigma, slope=False)[0])

    def slope(self, sigma: Any) -> Any:
        return self.reduction.scalar_slope(*self.proved.matrices(sigma, mean=False))

    def both(self, sigma: Any) -> tuple[Any, Any]:
        A, A_sigma = self.proved.matrices(sigma, mean=False)
        return self.reduction.scalar(A), self.reduction.scalar_slope(A, A_sigma)


@dataclass(frozen=True)
class Box:
    """A box of σ̂ that is proved to hold one root, with its sharper image, and the function that it is a root of."""

    function: Scalar
    sigma: Isolated
    symmetry: Symmetry

    @cached_property
    def unit(self) -> Fraction:
        """q = q̂ · unit, a power of two."""
        return self.function.proved.reduced.frequency_unit


def isolate(proved: Proved, seed: complex, bits: int = BASE_BITS) -> Box:
    """A box round the root that Newton's method reaches from `seed`, a σ̂; `PrecisionError` if none is proved."""
    return climb(lambda _: _isolate(proved, seed), bits, max(bits, _TRIED))


def _isolate(proved: Proved, seed: Any) -> Box:
    function, start = _function(proved, acb(seed))
    start = polished(function, start)
    size = start.abs_upper()
    if abs(float(start.imag.mid())) < _NEAR_AXIS * float(size):
        try:
            found = isolated(function, acb(start.real.mid()), size)
            return Box(function, Isolated(found.box, acb(found.image.real)), Symmetry.IMAGINARY)
        except PrecisionError:
            pass
    return Box(function, isolated(function, start, size), Symmetry.NONE)


def _function(proved: Proved, start: Any) -> tuple[Scalar, Any]:
    """The scalar made next to the root, and a point to which Newton's method has led."""
    for _ in range(_APPROACH):
        middle = start.mid()
        A, A_sigma = proved.matrices(middle)
        reduction = Reduction.of(A, near_root=True)
        step = reduction.scalar(A).mid() / reduction.scalar_slope(A, A_sigma).mid()
        if not step.is_finite():
            raise PrecisionError("Newton's method met a stationary point: roots may be too close for this precision")
        start = (middle - step).mid()
        if step.abs_upper() < arb(_CLOSE) * start.abs_upper():
            break
    return Scalar(proved, reduction), start


def refine(box: Box, digits: int) -> RootBall:
    """The root of `box` in a ball of relative radius below 10^−digits in the problem's own units."""
    goal = math.ceil(digits * math.log2(10)) + 1
    real = box.symmetry is Symmetry.IMAGINARY
    image = sharpened(box.function, box.sigma.image, goal + _GUARD, real)
    with precision(goal + 3 * _GUARD):
        ball = on_grid(in_units(image, box.unit), goal, 1, box.symmetry)
        if not (in_units(box.sigma.box, box.unit).contains(ball.q) and ball.q.contains(in_units(image, box.unit))):
            raise PrecisionError(f"the root near {image.str(6)} could not be sharpened to {digits} digits")
    return ball


def enclose(proved: Proved, seed: complex, digits: int) -> RootBall:
    """The simple root near `seed` (σ̂, scaled) in its ball; `PrecisionError` where there is none, or several meet."""
    return refine(isolate(proved, seed), digits)


def in_units(sigma: Any, unit: Fraction) -> Any:
    """q = −iσ in the problem's units: both steps are exact."""
    scale = rational_ball(unit)
    return acb(sigma.imag * scale, -sigma.real * scale)


def onto_axis(q: Any, symmetry: Symmetry) -> Any:
    """q with the coordinate that the symmetry proves to vanish set to 0."""
    if symmetry is Symmetry.REAL:
        return acb(q.real, 0)
    if symmetry is Symmetry.IMAGINARY:
        return acb(0, q.imag)
    return q


def on_grid(image: Any, goal: int, multiplicity: int, symmetry: Symmetry) -> RootBall:
    """A ball of relative radius below 2^−goal, with a short midpoint, around the much smaller image."""
    size = float(image.abs_lower())
    first = (math.frexp(size)[1] if size > 0 else _exponent(image)) - 1 - goal
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


def _exponent(image: Any) -> int:
    """The binary exponent of |image| where float64 underflows."""
    mantissa, exponent = image.abs_lower().man_exp()
    return int(exponent) + int(mantissa).bit_length()
