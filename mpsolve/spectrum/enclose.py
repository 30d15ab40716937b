"""Enclosures: a root of Δ̂ in a ball of any number of digits, proved to be the only one near it.

Near a root the determinant is reduced to the scalar s of `numbers.reduction`, whose zeros are those of Δ̂; interval
Newton isolates the zero and sharpens it. A box that is symmetric to the imaginary q-axis (σ real) and holds one root
holds one on that axis, as roots come in pairs q, −q̄; without any damping one that is symmetric to the real q-axis
does so too.
"""

from __future__ import annotations

from fractions import Fraction
from functools import cached_property
from typing import Any

from mpsolve.characteristic.proved import Proved
from mpsolve.errors import PrecisionError
from mpsolve.frozen import frozen
from mpsolve.numbers.balls import acb, arb, rational_ball
from mpsolve.numbers.reduction import Reduction
from mpsolve.numbers.rootball import RootBall, Symmetry
from mpsolve.proof.enclosing import Enclosed, Line, enclosed, root_ball
from mpsolve.proof.ladder import climb
from mpsolve.proof.newton import polished

BASE_BITS = 80
_TRIED = 640
"""Bits at which a root that no box isolates is left to the search for clusters."""
_APPROACH, _CLOSE = 3, 2.0**-16


_IMAGINARY = Line(Symmetry.IMAGINARY, lambda sigma: acb(sigma.real))
"""Re q = 0, of all problems: their coefficients are real."""
_REAL = Line(Symmetry.REAL, lambda sigma: acb(0, sigma.imag))
"""Im q = 0, where nothing damps."""


@frozen
class Scalar:
    """The scalar to which the determinant is reduced near one root, as a function of σ."""

    proved: Proved
    reduction: Reduction

    def value(self, sigma: Any) -> acb:
        return self.reduction.scalar(self.proved.matrices(sigma, slope=False)[0])

    def slope(self, sigma: Any) -> Any:
        return self.reduction.scalar_slope(*self.proved.matrices(sigma, mean=False))

    def both(self, sigma: Any) -> tuple[acb, acb]:
        A, A_sigma = self.proved.matrices(sigma, mean=False)
        return self.reduction.scalar(A), self.reduction.scalar_slope(A, A_sigma)


@frozen
class Box:
    """A root that is proved to be alone in its box of σ̂, and the function that it is a root of."""

    function: Scalar
    root: Enclosed

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
    return Box(function, enclosed(function, start, start.abs_upper(), _lines(proved)))


def _lines(proved: Proved) -> tuple[Line, ...]:
    return (_IMAGINARY, _REAL) if proved.lossless else (_IMAGINARY,)


def line_near(proved: Proved, sigma: acb) -> Line | None:
    """The line of symmetry to which the exact σ is so near that roots about it are likely to be mirror images."""
    return next((line for line in _lines(proved) if line.is_near(sigma, sigma.abs_upper())), None)


def _function(proved: Proved, start: Any) -> tuple[Scalar, acb]:
    """The scalar made next to the root, and a point to which Newton's method has led."""
    for _ in range(_APPROACH):
        middle = start.mid()
        A, A_sigma = proved.matrices(middle)
        reduction = Reduction.of(A, near_root=True, moves=A_sigma * middle)
        step = reduction.scalar(A).mid() / reduction.scalar_slope(A, A_sigma).mid()
        if not step.is_finite():
            raise PrecisionError("Newton's method met a stationary point: roots may be too close for this precision")
        start = (middle - step).mid()
        if step.abs_upper() < arb(_CLOSE) * start.abs_upper():
            break
    return Scalar(proved, reduction), start


def refine(box: Box, digits: int) -> RootBall:
    """The root of `box` in a ball of relative radius below 10^−digits in the problem's own units."""
    return root_ball(box.function, box.root, digits, lambda sigma: in_units(sigma, box.unit))


def enclose(proved: Proved, seed: complex, digits: int) -> RootBall:
    """The simple root near `seed` (σ̂, scaled) in its ball; `PrecisionError` where there is none, or several meet."""
    return refine(isolate(proved, seed), digits)


def in_units(sigma: Any, unit: Fraction) -> acb:
    """q = −iσ in the problem's units: both steps are exact."""
    scale = rational_ball(unit)
    return acb(sigma.imag * scale, -sigma.real * scale)


__all__ = ["Box", "RootBall", "Scalar", "Symmetry", "enclose", "in_units", "isolate", "line_near", "refine"]
