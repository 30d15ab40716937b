"""Fourth roots against their own fourth powers."""

from __future__ import annotations

from decimal import Decimal
from fractions import Fraction

import pytest

from mpsolve.numbers.root4 import decimal_root, rational_root


@pytest.mark.parametrize("x", [Fraction(0), Fraction(2, 3), Fraction(-5, 7), Fraction(10**30, 3)])
def test_a_rational_root_is_found(x: Fraction) -> None:
    assert rational_root(x * abs(x) ** 3) == x


@pytest.mark.parametrize("signed", [Fraction(2), Fraction(16, 3), Fraction(-1, 4), Fraction(10**8 + 1)])
def test_there_is_none_where_there_is_none(signed: Fraction) -> None:
    assert rational_root(signed) is None


@pytest.mark.parametrize("signed", [Fraction(2), Fraction(-3, 7), Fraction(1, 10**50)])
def test_digits_are_right_to_one_unit(signed: Fraction) -> None:
    for digits in (8, 40):
        near = Fraction(decimal_root(signed, None, digits))
        unit = abs(near) * Fraction(1, 10 ** (digits - 1))
        low, high = (x * abs(x) ** 3 for x in (near - unit, near + unit))
        assert low < signed < high


def test_a_rational_number_is_only_divided() -> None:
    assert decimal_root(Fraction(1, 81), Fraction(1, 3), 5).quantize(Decimal("1e-9")) == Decimal("0.333333333")
