"""Affine forms hold the exact values of what they were made of, and are not much wider than first order allows."""

from __future__ import annotations

import math
from fractions import Fraction
from typing import Any

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from mpsolve.numbers.affine import Affine, between, constant, horner

NUMBERS = st.fractions(min_value=-50, max_value=50, max_denominator=10**6)
WIDTHS = st.fractions(min_value=0, max_value=2, max_denominator=10**6)
SHARES = st.fractions(min_value=-1, max_value=1, max_denominator=1000)


def interval(middle: Fraction, width: Fraction, name: str) -> tuple[Affine, Fraction, Fraction]:
    low, high = float(middle - width), float(middle + width)
    return between(np.array([low]), np.array([high]), name), Fraction(low), Fraction(high)


def holds(form: Affine, exact: Fraction) -> bool:
    low, high = float(form.low[0]), float(form.high[0])
    return (low == -math.inf or Fraction(low) <= exact) and (high == math.inf or exact <= Fraction(high))


@settings(max_examples=200, deadline=None)
@given(NUMBERS, WIDTHS, NUMBERS, WIDTHS, SHARES, SHARES)
def test_formulas_hold_their_values(
    a: Fraction, r: Fraction, b: Fraction, s: Fraction, t: Fraction, u: Fraction
) -> None:
    x, x0, x1 = interval(a, r, "x")
    y, y0, y1 = interval(b, s, "y")
    p, q = (x0 + x1) / 2 + t * (x1 - x0) / 2, (y0 + y1) / 2 + u * (y1 - y0) / 2
    third = constant(Fraction(1, 3))
    assert holds(x + y, p + q)
    assert holds(x * y - x, p * q - p)
    assert holds(x.square() * y + third, p * p * q + Fraction(1, 3))
    assert holds((x - y).times(0.5).square(), (p - q) ** 2 / 4)
    assert holds(horner([third, None, x, y], x), Fraction(1, 3) + p**3 + q * p**3)
    positive = x.square() + y.square() + constant(Fraction(1, 7))
    assert holds(positive.inverse() * y, q / (p * p + q * q + Fraction(1, 7)))


def test_what_may_vanish_has_no_inverse() -> None:
    x = between(np.array([-0.5, 0.5]), np.array([1.0, 1.0]), "x")
    assert np.isinf(x.inverse().e[0])
    assert np.isfinite(x.inverse().e[1])


@pytest.mark.parametrize("power", [1, 2, 3])
def test_the_rest_is_of_second_order(power: int) -> None:
    def rest(width: float) -> Any:
        x = between(np.array([1.5 - width]), np.array([1.5 + width]), "x")
        y = x
        for _ in range(power):
            y = y * x
        return (y * y.inverse() + x.inverse()).e[0]

    assert rest(1e-3) < 0.011 * rest(1e-2) * 1.2
