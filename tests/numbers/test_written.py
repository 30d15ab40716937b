"""Texts of numbers are read exactly, within limits, and decimals are printed short."""

from __future__ import annotations

from decimal import Decimal
from fractions import Fraction

import pytest

from mpsolve import InputError
from mpsolve.numbers.written import MAX_DIGITS, bounded, refuse_text, short_text, unsigned


@pytest.mark.parametrize(
    ("text", "value"), [("0.67", Fraction(67, 100)), ("67 / 100", Fraction(67, 100)), (".5e-3", Fraction(1, 2000)),
                        ("1_000", Fraction(1000))]
)  # fmt: skip
def test_a_text_is_the_number_that_it_says(text: str, value: Fraction) -> None:
    assert unsigned(text, text, MAX_DIGITS, "x") == value


@pytest.mark.parametrize(
    ("text", "why"),
    [("1e500", "exponent beyond ±400"), ("1/0", "divides by zero"), ("1__0", "is not a number"), ("abc", "write a")],
)
def test_what_is_none_is_refused_with_its_reason(text: str, why: str) -> None:
    with pytest.raises(InputError, match=why):
        unsigned(text, text, MAX_DIGITS, "x")


def test_the_limit_of_digits_is_exact() -> None:
    assert bounded(Fraction(10**3 - 1), 3, "x") == 999
    with pytest.raises(InputError, match="more than 3 digits"):
        bounded(Fraction(1, 10**3), 3, "x")


def test_infinity_is_told_from_nonsense() -> None:
    with pytest.raises(InputError, match="is not finite"):
        refuse_text("-inf", "x")


@pytest.mark.parametrize(
    ("number", "text"), [("0", "0"), ("1.50", "1.5"), ("0.00012", "0.00012"), ("1234567", "1.234567e+6"),
                         ("-1E-7", "-1e-7")]
)  # fmt: skip
def test_a_decimal_is_printed_without_zeros_and_with_an_exponent_where_it_is_shorter(number: str, text: str) -> None:
    assert short_text(Decimal(number).normalize(), 6) == text
