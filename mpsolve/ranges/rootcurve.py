"""A root over one parameter as a curve, with the imaginary part of q̂ as its height."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

from flint import arb

from mpsolve.characteristic.free_proved import FreeProved
from mpsolve.numbers.balls import acb
from mpsolve.numbers.reduction import Reduction
from mpsolve.proof import newton


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
