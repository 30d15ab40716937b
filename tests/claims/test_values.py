"""Balls against printed numbers are decided either way, or refused."""

from __future__ import annotations

from fractions import Fraction

import flint
import pytest
from hypothesis import given
from hypothesis import strategies as st

from mpsolve.claims.values import below, decimal, first_on_grid, grid, last_on_grid, places, rounded, rounds_to, shown
from mpsolve.errors import PrecisionError
from mpsolve.numbers.packed import exact_ends

arb = flint.arb


def test_an_order_is_proved_or_refused() -> None:
    assert below(arb(1, 0.1), arb(2, 0.1))
    assert not below(arb(2, 0.1), arb(1, 0.1))
    assert not below(arb(1), arb(1))
    assert below(arb(1, 0.1), 2)
    for other in (arb(1.05, 0.1), arb(1, 0.1)):
        with pytest.raises(PrecisionError, match="overlap"):
            below(arb(1, 0.1), other)


def test_a_printed_number_is_met_by_every_point_of_a_ball() -> None:
    assert rounds_to(arb("1.2501 +/- 1e-5"), "1.25")
    assert not rounds_to(arb("1.2501 +/- 1e-5"), "1.26")
    assert rounds_to(arb(1.25), "1.3")  # exactly half: upward
    assert rounds_to(arb("-1.3 +/- 1e-5"), "-1.3")
    assert rounded(arb("33.1174 +/- 1e-4"), 2) == "33.12"
    assert rounded(arb("-0.004 +/- 1e-4"), 2) == "0.00"
    for refused in (lambda x: rounds_to(x, "1.3"), lambda x: rounded(x, 1)):
        with pytest.raises(PrecisionError, match="round differently"):
            refused(arb("1.25 +/- 1e-5"))


def test_neighbours_on_a_grid() -> None:
    step = Fraction(1, 100)
    assert last_on_grid(arb("0.674 +/- 1e-4"), step) == Fraction(67, 100)
    assert first_on_grid(arb("0.674 +/- 1e-4"), step) == Fraction(68, 100)
    for search in (last_on_grid, first_on_grid):
        with pytest.raises(PrecisionError, match="lies in a ball"):
            search(arb("0.67 +/- 1e-4"), step)


@given(st.integers(-(10**6), 10**6), st.integers(0, 4))
def test_decimals_are_exact(units: int, digits: int) -> None:
    x = Fraction(units, 10**digits)
    assert Fraction(decimal(x)) == x
    assert places(decimal(x)) <= digits


def test_texts() -> None:
    assert decimal(Fraction(1, 3)) == "1/3"
    assert (places("1.250"), places("12")) == (3, 0)
    assert grid("0.04:0.01:0.07") == ("0.04", "0.05", "0.06", "0.07")
    assert grid("1:0.3:2") == ("1", "1.3", "1.6", "1.9")
    assert shown(arb("0.6666666666666 +/- 1e-14"), 6) == "0.666667"


@given(st.floats(-1e6, 1e6), st.floats(0, 1))
def test_the_ends_enclose_the_ball(middle: float, radius: float) -> None:
    low, high = exact_ends(arb(middle, radius))
    assert low <= Fraction(middle) - Fraction(radius) <= Fraction(middle) + Fraction(radius) <= high
    assert high - low <= 2 * Fraction(radius) * (1 + Fraction(1, 2**25))
