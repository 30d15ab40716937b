"""A root over the velocity: it is the certified one, and moves as certified roots beside it say."""

from __future__ import annotations

from fractions import Fraction

import pytest
from ranges_of_a_pair import PAIR, lowest, over_velocity, over_velocity_and_mass

from mpsolve import onset
from mpsolve.numbers.balls import acb, arb, precision
from mpsolve.ranges.curves import CrossingCurve, RootCurve

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


def at(factor: Fraction) -> tuple[float, float]:
    """(v, q) of the onset where masses are scaled."""
    found = onset(PAIR.changed("scale.mass", factor), over={"v": (150, 230)}, digits=20, check=False)
    assert found.value is not None
    return float(found.value), float(found.q)


def test_the_rate_of_the_onset_in_mass() -> None:
    scope, step = over_velocity_and_mass(), Fraction(1, 10000)
    v, q = at(Fraction(1))
    units = [float(unit) for unit in scope.family.units]
    frequency = float(scope.family.frequency_unit)
    with precision(120):
        curve, y = CrossingCurve(scope.proved), arb(1) / arb(units[1])
        state, rates = curve.near((arb(q / frequency), arb(v / units[0])), y)
        (q_ball, x_ball), rate = curve.enclosed(state, y, 80)
        assert float(x_ball) * units[0] == pytest.approx(v, rel=1e-12)
        assert float(q_ball) * frequency == pytest.approx(q, rel=1e-12)
        assert float(rate) == pytest.approx(float(curve.rise(rates)), rel=1e-9)
    difference = (at(1 + step)[0] - at(1 - step)[0]) / (2 * float(step))
    assert float(rate) * units[0] / units[1] == pytest.approx(difference, rel=1e-6)
