"""Ranges between exact numbers, and what is said of others."""

from __future__ import annotations

from fractions import Fraction

import pytest

from mpsolve.errors import InputError
from mpsolve.numbers.ranges import checked_range


def test_ends_are_exact() -> None:
    low, high = checked_range(("0.1", Fraction(1, 3)), "alpha")
    assert (low.as_fraction(), high.as_fraction()) == (Fraction(1, 10), Fraction(1, 3))


@pytest.mark.parametrize(
    ("given", "said"),
    [
        (3, "alpha: is 3: give a range"),
        ((1, 2, 3), r"alpha: is \(1, 2, 3\): give a range"),
        ((0, "root4(2)"), "alpha: has an irrational end"),
        ((1, 1), "alpha: ends at 1, not above its start 1"),
        ((2, 1), "alpha: ends at 1, not above its start 2"),
    ],
)
def test_what_is_no_range_is_refused(given: object, said: str) -> None:
    with pytest.raises(InputError, match=f"^{said}"):
        checked_range(given, "alpha")
