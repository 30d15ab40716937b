"""Polynomials in several variables: arithmetic against values, order at the ring's point."""

from fractions import Fraction

import pytest
from hypothesis import given
from hypothesis import strategies as st

from mpsolve.numbers.several import Ring

RING = Ring(("x", "y"), (Fraction(2), Fraction(1, 3)))
X, Y = RING.variables
NUMBERS = st.fractions(-5, 5, max_denominator=7)


@given(NUMBERS, NUMBERS.filter(bool))
def test_the_value_of_a_formula_is_the_formula_of_the_values(x: Fraction, y: Fraction) -> None:
    formula = lambda a, b: (1 + 2 * a - b * Fraction(3, 7)) ** 3 - a * b / 5 + 4 / b  # noqa: E731
    assert formula(X, Y).at((x, y)) == formula(x, y)


def test_what_cancels_is_gone() -> None:
    assert not X - X
    assert X * Y == Y * X
    assert X + 0 == X
    assert RING.constant(3) == 3


def test_order_is_that_at_the_point() -> None:
    assert sorted([X, 1 + Y, RING.constant(Fraction(5, 3))]) == [1 + Y, RING.constant(Fraction(5, 3)), X]
    assert Fraction(1) < X


def test_a_quotient_by_a_sum_is_refused() -> None:
    with pytest.raises(ZeroDivisionError):
        1 / (X + Y)
