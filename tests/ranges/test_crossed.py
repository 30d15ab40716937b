"""What an answer about crossings shows of them."""

from fractions import Fraction
from math import inf

from flint import arb
from free_cases import PAIR

from mpsolve import Problem, Status, tracks
from mpsolve.ranges.crossed import Crossing, Crossings


def test_a_row_for_each_crossing_and_floats_on_its_two_sides() -> None:
    one = Crossing(arb("0.7", 1e-20), arb("0.1"), 2)
    assert -inf < one.lower < 0.7 <= one.upper < inf
    problem = Problem(tracks.EulerBernoulli(EI="1/4", m=1, k=1, c="0.1"), PAIR, v="0.5")
    found = Crossings(problem, {"v": (Fraction(0), Fraction(1))}, Status.UNVERIFIED, crossings=(one,), counts=(0, 2))
    assert found.rows() == [{"value": 0.7, "q": 0.1, "direction": 2}]
    assert list(found.records()) == found.rows()
