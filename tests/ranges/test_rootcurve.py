"""A root over the velocity: it is the certified one, and moves as certified roots beside it say."""

from __future__ import annotations

from fractions import Fraction

from ranges_of_a_pair import lowest, over_velocity

from mpsolve.numbers.balls import acb, arb, precision
from mpsolve.ranges.rootcurve import RootCurve

V = Fraction(180)


def test_root_and_motion() -> None:
    scope = over_velocity()
    unit, step = float(scope.family.units[0]), Fraction(1, 1000)
    frequency = float(scope.family.frequency_unit)
    with precision(120):
        curve, x = RootCurve(scope.proved), arb(float(V)) / arb(unit)
        state, _ = curve.near((acb(lowest(V) / frequency),), x)
        (ball,), rise = curve.enclosed(state, x, 80)
        assert abs(complex(ball) * frequency - lowest(V)) < 1e-9
        slope = (lowest(V + step) - lowest(V - step)) / (2 * float(step))
        assert abs(float(rise) * frequency / unit - slope.imag) < 1e-6 * abs(slope)
        (over,) = curve.over((ball,), x + arb(0, 1e-9))
        assert over.contains(ball)
        assert over.rad() > ball.rad()
