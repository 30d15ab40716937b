"""Curves over one parameter whose lowest point is sought (`stationary.Curve`).

A root over a parameter has the states (q̂,) and the imaginary part of q̂ as its height. Crossings of the real axis over
a second parameter have the states (q̂, x̂), x̂ the first one and their height: along the zeros of f(q̂, x̂, ŷ) with q̂
real, q̂′f_q + x̂′f_x + f_y = 0 is two real equations for the two rates.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any, cast

from flint import acb_mat

from mpsolve.characteristic.free_proved import FreeProved
from mpsolve.errors import PrecisionError
from mpsolve.numbers.balls import acb, arb
from mpsolve.numbers.reduction import Reduction
from mpsolve.proof import newton, planar
from mpsolve.ranges.enclosed import InPlane


@dataclass(frozen=True)
class AtPoint:
    """The determinant at one x̂ (a ball) as an analytic function of q̂."""

    proved: FreeProved
    x: Any
    reduction: Reduction

    @staticmethod
    def near(proved: FreeProved, q: Any, x: Any) -> AtPoint:
        """Reduced at q, which is best near a root."""
        A = proved.matrices(acb(0, 1) * q, [x], slopes=False)[0]
        return AtPoint(proved, x, Reduction.of(A, near_root=True))

    def value(self, q: Any) -> acb:
        return self.reduction.scalar(self.proved.matrices(acb(0, 1) * q, [self.x], slopes=False)[0])

    def slope(self, q: Any) -> acb:
        return self.both(q)[1]

    def both(self, q: Any) -> tuple[acb, acb]:
        A, (A_sigma, _) = self.proved.matrices(acb(0, 1) * q, [self.x])
        return self.reduction.scalar(A), acb(0, 1) * self.reduction.scalar_slope(A, A_sigma)

    def motion(self, q: Any) -> Any:
        """dq̂/dx̂ of the root in the ball q."""
        A, (A_sigma, A_x) = self.proved.matrices(acb(0, 1) * q, [self.x])
        f_q, f_x = acb(0, 1) * self.reduction.scalar_slope(A, A_sigma), self.reduction.scalar_slope(A, A_x)
        return -f_x / f_q


@dataclass(frozen=True)
class RootCurve:
    """States are (q̂,)."""

    proved: FreeProved

    def near(self, state: tuple[acb, ...], x: arb) -> tuple[tuple[acb, ...], tuple[acb, ...]]:
        f = AtPoint.near(self.proved, state[0], x)
        root = newton.polished(f, state[0])
        return (root,), (f.motion(root).mid(),)

    def rise(self, rates: tuple[acb, ...]) -> arb:
        return rates[0].imag

    def enclosed(self, state: tuple[acb, ...], x: arb, goal: int) -> tuple[tuple[acb, ...], arb]:
        f = AtPoint.near(self.proved, state[0], x)
        ball = newton.sharpened(f, newton.isolated(f, newton.polished(f, state[0]), abs(state[0])).image, goal)
        return (ball,), f.motion(ball).imag

    def over(self, state: tuple[acb, ...], x: Any) -> tuple[acb, ...]:
        f = AtPoint.near(self.proved, state[0], x.mid())
        over = AtPoint(self.proved, x, f.reduction)
        return (newton.isolated(over, newton.polished(f, state[0]), abs(state[0])).image,)


_SIZE = 2.0**-4  # of the modulus: of the largest box that is tried


@dataclass(frozen=True)
class Fixed:
    """A family of two parameters at a ball of the second one, as one of the first alone."""

    proved: FreeProved
    y: Any

    def matrices(self, sigma: Any, x: Sequence[arb], slopes: bool = True) -> tuple[acb_mat, list[acb_mat]]:
        """As `FreeProved.matrices`, of the first parameter."""
        A, each = self.proved.matrices(sigma, [*x, self.y], slopes)
        return A, each[:2]


@dataclass(frozen=True)
class CrossingCurve:
    """Of a family of two parameters."""

    proved: FreeProved

    def _plane(self, state: tuple[arb, ...], y: Any, at: arb) -> InPlane:
        """The scalar at y, reduced at an exact point of the curve."""
        A = self.proved.matrices(acb(0, state[0]), [state[1], at], slopes=False)[0]
        return InPlane(cast(FreeProved, Fixed(self.proved, y)), Reduction.of(A, near_root=True))

    def _rates(self, reduction: Reduction, state: tuple[arb, ...], y: Any) -> tuple[arb, arb]:
        A, (A_sigma, A_x, A_y) = self.proved.matrices(acb(0, state[0]), [state[1], y])
        f_q = acb(0, 1) * reduction.scalar_slope(A, A_sigma)
        f_x, f_y = (reduction.scalar_slope(A, slope) for slope in (A_x, A_y))
        turn = (f_q.conjugate() * f_x).imag
        if turn.contains(0):
            raise PrecisionError("two crossings of the real axis may meet here")
        return -(f_y * f_x.conjugate()).imag / (f_q * f_x.conjugate()).imag, -(f_q.conjugate() * f_y).imag / turn

    def near(self, state: tuple[arb, ...], x: arb) -> tuple[tuple[arb, ...], tuple[arb, ...]]:
        f = self._plane(tuple(arb(s.mid()) for s in state), x, x)
        at = planar.polished(f, (float(state[0]), float(state[1])))
        return at, tuple(arb(rate.mid()) for rate in self._rates(f.reduction, at, x))

    def rise(self, rates: tuple[arb, ...]) -> arb:
        return rates[1]

    def enclosed(self, state: tuple[arb, ...], x: arb, goal: int) -> tuple[tuple[arb, ...], arb]:
        f = self._plane(state, x, x)
        zero = planar.isolated(f, planar.polished(f, (float(state[0]), float(state[1]))), _sizes(state))
        balls = planar.sharpened(f, zero, goal)
        return balls, self._rates(f.reduction, balls, x)[1]

    def over(self, state: tuple[arb, ...], x: Any) -> tuple[arb, ...]:
        middle = arb(x.mid())
        f = self._plane(state, middle, middle)
        over = InPlane(cast(FreeProved, Fixed(self.proved, x)), f.reduction)
        zero = planar.isolated(over, planar.polished(f, (float(state[0]), float(state[1]))), _sizes(state))
        return planar.settled(over, zero)


def _sizes(state: tuple[arb, ...]) -> tuple[arb, arb]:
    return abs(state[0]) * arb(_SIZE), abs(state[1]) * arb(_SIZE)
