"""Enclosures: a root of Δ̂ in a ball of any number of digits, proved to be the only one near it.

Near a root the determinant is reduced to the scalar s of `numbers.reduction`, whose zeros are those of Δ̂; interval
Newton isolates the zero and sharpens it. A box that is symmetric to the imaginary q-axis (σ real) and holds one root
holds one on that axis, as roots come in pairs q, −q̄; without any damping one that is symmetric to the real q-axis
does so too.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass
from fractions import Fraction
from functools import cached_property
from typing import Any

from mpsolve.characteristic.proved import Proved
from mpsolve.errors import PrecisionError
from mpsolve.numbers.balls import acb, arb, precision, rational_ball
from mpsolve.numbers.reduction import Reduction
from mpsolve.numbers.rootball import RootBall, Symmetry, on_grid
from mpsolve.proof.ladder import climb
from mpsolve.proof.newton import Isolated, isolated, polished, sharpened

BASE_BITS = 80
_GUARD = 24
_TRIED = 640
"""Bits at which a root that no box isolates is left to the search for clusters."""
_NEAR_AXIS = 2.0**-30
_APPROACH, _CLOSE = 3, 2.0**-16


_ONTO: dict[Symmetry, Callable[[Any], Any] | None] = {
    Symmetry.NONE: None,
    Symmetry.IMAGINARY: lambda sigma: acb(sigma.real),
    Symmetry.REAL: lambda sigma: acb(0, sigma.imag),
}
"""Onto the line on which a root lies by its symmetry."""


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
    if proved.lossless and abs(float(start.real.mid())) < _NEAR_AXIS * float(size):
        try:
            found = isolated(function, acb(0, start.imag.mid()), size)
            return Box(function, Isolated(found.box, acb(0, found.image.imag)), Symmetry.REAL)
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
    image = sharpened(box.function, box.sigma.image, goal + _GUARD, _ONTO[box.symmetry])
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


__all__ = ["Box", "RootBall", "Scalar", "Symmetry", "enclose", "in_units", "isolate", "refine"]
