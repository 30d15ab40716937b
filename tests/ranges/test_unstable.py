"""Ends of ranges in which roots grow."""

from fractions import Fraction

from free_cases import BEAM, PAIR

from mpsolve import Problem
from mpsolve.ranges.unstable import unstable_ranges


def test_ends_of_the_range_have_the_digits_asked_for() -> None:
    ranges = unstable_ranges(Problem(BEAM, PAIR, v=0), over={"v": ("0.75", "0.8")}, digits=100)
    (part,) = ranges.intervals
    assert part.start.rad() < 1e-100
    assert part.end.rad() < 1e-100
    assert Fraction(part.lower) <= Fraction("0.75")
    assert Fraction(part.upper) >= Fraction("0.8")
