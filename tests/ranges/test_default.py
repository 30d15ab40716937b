"""Ranges that hold the case."""

from __future__ import annotations

from fractions import Fraction

from hypothesis import given
from hypothesis import strategies as st

from mpsolve import Problem, read_problem, tracks, vehicles
from mpsolve.ranges.default import critical_of, root_up, rounded_up, top_velocity, velocity_ranges
from mpsolve.waves.speeds import wave_speeds

BOGIE = read_problem("examples/two_layer_bogie.toml").problem
CATENARY = Problem(tracks.EulerBernoulli(EI=130, m="1.35", k=100, c="0.5", N=-20000), vehicles.Mass(10), v=139)
RAIL = Problem(tracks.Timoshenko(EI="6.4e6", m=60, J="0.24", k="1e6", c=770, S="2.4e8"), vehicles.Mass(900), v=100)
STRING = Problem(tracks.String(T=100, m=1, k=1, c="0.1"), vehicles.Mass(2), v=3)


@given(st.fractions(min_value="1/100", max_value=10**9))
def test_round_numbers_are_not_below(x: Fraction) -> None:
    up = rounded_up(x)
    assert x <= up <= x * Fraction(11, 10) + Fraction(1, 100)


def test_the_range_holds_the_velocity_and_the_first_critical_one() -> None:
    top = top_velocity(BOGIE, critical_of(BOGIE))
    assert top > 2 * BOGIE.v
    assert float(top) > float(critical_of(BOGIE).velocities[0].value.mid())


@given(st.fractions(min_value="1/1000", max_value=10**9))
def test_roots_are_not_below(square: Fraction) -> None:
    up = root_up(square)
    assert square <= up**2
    assert (up - Fraction(3, 10**6)) ** 2 < square or up < Fraction(3, 10**6)


def test_the_range_of_a_contact_wire_holds_its_waves() -> None:
    """√(T/m) is 122 m/s, the velocity 139: a range up to twice the beam's α, 26 m/s, would say nothing."""
    found = velocity_ranges(CATENARY)
    assert found.near[0][0] == 0
    assert found.near[-1][1] >= 2 * 139
    assert found.far == ()
    assert (0, 280) in found.steps
    assert found.steps[-1][1] == found.near[-1][1]


def test_wave_speeds_part_the_ranges() -> None:
    """Of a string at 10; of Timoshenko's rail far beyond its critical velocity."""
    (low, before), (after, high) = velocity_ranges(STRING).near
    assert low == 0 < before < 10 < after < high
    near, far = velocity_ranges(RAIL).near, velocity_ranges(RAIL).far
    assert near[0][0] == 0
    assert near[-1][1] == far[0][0]
    speeds = [float(square) ** 0.5 for square in wave_speeds(RAIL.track).values()]
    assert far[-1][1] > max(speeds)
    assert not any(a <= speed <= b for speed in speeds for a, b in (*near, *far))
