"""Balls against printed numbers: decided only where both ends of the ball agree."""

from __future__ import annotations

from fractions import Fraction

import pytest
from flint import arb
from hypothesis import given, settings
from hypothesis import strategies as st

from mpsolve.audit.values import decimal, first_on_grid, grid, last_on_grid, rounded, rounds_to
from mpsolve.errors import PrecisionError


def test_rounding_needs_both_ends() -> None:
    assert rounds_to(arb("21.8854", "1e-6"), "21.9")
    assert not rounds_to(arb("20.7266", "1e-6"), "21.9")
    with pytest.raises(PrecisionError):
        rounds_to(arb("21.85", "1e-6"), "21.9")


@settings(max_examples=40)
@given(st.integers(1, 10**6), st.integers(0, 3))
def test_a_decimal_rounds_to_itself(units: int, places: int) -> None:
    exact = Fraction(units, 10**places)
    text = rounded(arb(exact.numerator) / exact.denominator, places)
    assert Fraction(text) == exact
    assert len(text.partition(".")[2]) == places


def test_neighbours_on_a_grid() -> None:
    ball, step = arb("0.961957", "1e-6"), Fraction(1, 100)
    assert (last_on_grid(ball, step), first_on_grid(ball, step)) == (Fraction(96, 100), Fraction(97, 100))
    with pytest.raises(PrecisionError):
        last_on_grid(arb("0.96", "1e-6"), step)


def test_the_papers_notation() -> None:
    assert grid("0.5:0.5:1.5") == ("0.5", "1", "1.5")
    assert len(grid("0.04:0.01:0.99")) == 96
    assert (decimal(Fraction(1, 8)), decimal(Fraction(70))) == ("0.125", "70")
