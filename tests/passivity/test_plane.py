"""Bounds of polynomials on boxes hold exactly, and branch and bound ends where there is none."""

from fractions import Fraction
from typing import Any

import numpy as np
from hypothesis import given
from hypothesis import strategies as st

from mpsolve.characteristic.table import Table
from mpsolve.numbers.jets import UP
from mpsolve.passivity.plane import bounds, clipped, negative, supremum
from mpsolve.proof.effort import Effort


def test_where_the_bottom_vanishes_there_is_no_bound() -> None:
    circle = {(2, 0): Fraction(1), (0, 2): Fraction(1), (0, 0): Fraction(-1)}
    one = {(0, 0): Fraction(1)}
    assert supremum(one, circle, ((0.0, 2.0), (0.0, 2.0)), 9.0, Effort()) is None
    assert supremum(one, circle, ((0.0, 0.5), (0.0, 0.5)), 9.0, Effort()) is None  # negative there
    away = {(2, 0): Fraction(1), (0, 2): Fraction(1), (0, 0): Fraction(1, 4)}
    found = supremum(one, away, ((0.0, 2.0), (0.0, 2.0)), 1.0, Effort())
    assert found is not None
    assert 4 <= found < 6.1


def test_a_touching_polynomial_is_notnegative() -> None:
    touching = {(2, 0): Fraction(-1), (1, 1): Fraction(2), (0, 2): Fraction(-1)}
    assert not negative(touching, ((0.0, 1.0), (0.0, 1.0)), Effort())
    assert negative({**touching, (0, 0): Fraction(-1, 1000)}, ((0.0, 1.0), (0.0, 1.0)), Effort())


SIDE = st.tuples(st.floats(0, 4), st.floats(0, 4)).map(sorted)
PART = st.fractions(0, 1, max_denominator=50)


POWERS = st.tuples(st.integers(0, 5), st.integers(0, 4))
POLYNOMIALS = st.dictionaries(POWERS, st.fractions(-9, 9, max_denominator=40), min_size=1)


@given(POLYNOMIALS, SIDE, SIDE, PART, PART)
def test_bounds_hold_exactly(polynomial: Any, x: list[float], y: list[float], s: Fraction, t: Fraction) -> None:
    boxes = tuple(np.array([value]) for a, b in (x, y) for value in ((a + b) / 2, (b - a) / 2 * UP + 1e-15 * b))
    low, high, _ = bounds(Table.of(polynomial), boxes)
    at = [Fraction(a) + part * (Fraction(b) - Fraction(a)) for (a, b), part in ((x, s), (y, t))]
    value = sum(c * at[0] ** i * at[1] ** j for (i, j), c in polynomial.items())
    assert Fraction(low[0]) <= value <= Fraction(high[0])


@given(SIDE, SIDE, PART, PART, st.floats(1e-3, 9))
def test_clipping_keeps_what_counts(x: list[float], y: list[float], s: Fraction, t: Fraction, product: float) -> None:
    boxes = tuple(np.array([value]) for a, b in (x, y) for value in ((a + b) / 2, (b - a) / 2 * UP + 1e-15 * b))
    at = [Fraction(a) + part * (Fraction(b) - Fraction(a)) for (a, b), part in ((x, s), (y, t))]
    left = clipped(boxes, product)
    if at[0] * at[1] <= Fraction(product):
        assert len(left[0]) == 1
        for value, middle, radius in ((at[0], left[0], left[1]), (at[1], left[2], left[3])):
            assert abs(value - Fraction(middle[0])) <= Fraction(radius[0])
    for k in range(len(left[0])):
        assert (left[0][k] - left[1][k]) * (left[2][k] - left[3][k]) <= product * (1 + 1e-9)
