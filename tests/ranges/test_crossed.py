"""What an answer about crossings shows of them."""

from __future__ import annotations

from fractions import Fraction
from math import inf

import pytest
from flint import arb
from free_cases import PAIR
from hypothesis import given
from hypothesis import strategies as st

from mpsolve import Problem, Status, tracks, vehicles
from mpsolve.ranges.crossed import Crossing, Crossings, LeftOut, Speed, not_whole, speeds_within


def test_a_row_for_each_crossing_and_floats_on_its_two_sides() -> None:
    one = Crossing(arb("0.7", 1e-20), arb("0.1"), 2)
    assert -inf < one.lower < 0.7 <= one.upper < inf
    problem = Problem(tracks.EulerBernoulli(EI="1/4", m=1, k=1, c="0.1"), PAIR, v="0.5")
    found = Crossings(problem, {"v": (Fraction(0), Fraction(1))}, Status.UNVERIFIED, crossings=(one,), counts=(0, 2))
    assert found.rows() == [{"value": 0.7, "q": 0.1, "direction": 2}]
    assert list(found.records()) == found.rows()


BEAM = tracks.Timoshenko(EI="6.38e6", m="60.2", S="2.4e8", J="0.24", k="1e6", c=770)
RAIL = Problem(BEAM, [vehicles.Mass(3000).at(0)], v=1)


def test_the_speeds_of_shear_and_of_bending_in_a_range() -> None:
    """√(S/m) and √(EI/J)."""
    within = [float(one.ball) for one in speeds_within(RAIL, {"v": (Fraction(0), Fraction(6000))})]
    assert within == pytest.approx([(2.4e8 / 60.2) ** 0.5, (6.38e6 / 0.24) ** 0.5], rel=1e-14)
    assert speeds_within(RAIL, {"v": (Fraction(0), Fraction(1996))}) == []
    assert speeds_within(RAIL, {"track.c": (Fraction(0), Fraction(6000))}) == []


@given(st.fractions(min_value=Fraction(1, 100), max_value=10**8))
def test_rationals_on_both_sides_of_a_speed(square: Fraction) -> None:
    speed = Speed(square, "waves")
    below, above = speed.beside(-1), speed.beside(1)
    assert below**2 < square < above**2
    assert above - below <= Fraction(3, 10**6)


def test_the_speed_alone_or_a_part_of_the_range() -> None:
    point, part = LeftOut("waves", arb(2), arb(2), arb(2)), LeftOut("waves", arb(2), arb("1.5"), arb(2))
    assert (point.is_point, part.is_point) == (True, False)
    assert not_whole(()) is None
    reason = not_whole((point, part))
    assert reason is not None
    assert "v = 2 m/s itself (waves); v from 1.5 to 2 m/s (waves: 2 m/s)" in reason.message
