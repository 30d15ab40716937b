"""The glance in floats sees the certified lowest root."""

from __future__ import annotations

from fractions import Fraction

from ranges_of_a_pair import lowest, over_velocity

from mpsolve.ranges.least_seen import least_seen
from mpsolve.spectrum.candidates import Area


def test_it_is_the_lowest_certified_root_of_the_points_looked_at() -> None:
    scope = over_velocity()
    unit, frequency = float(scope.family.units[0]), float(scope.family.frequency_unit)
    seen = least_seen(scope.family, float(scope.low[0]), float(scope.high[0]), Area(0.0, 2.0, -1.0, 0.02))
    assert seen is not None
    v = seen.x * unit
    assert abs(seen.q * frequency - lowest(Fraction(v))) < 1e-6
    for beside in (v - seen.step * unit, v + seen.step * unit):
        if 150 <= beside <= 230:
            assert lowest(Fraction(beside)).imag > seen.q.imag * frequency
