"""What people read: few figures, their units, and never a figure that a ball does not hold."""

from __future__ import annotations

from fractions import Fraction
from typing import Any

import pytest
from flint import arb
from hypothesis import given
from hypothesis import strategies as st

from mpsolve.numbers.spoken import beside, decimal, rounded, said_in, spoken


@pytest.mark.parametrize(
    ("x", "said"),
    [
        (0, "0"),
        (70, "70"),
        (Fraction(2, 3), "0.6667"),
        (123456, "123500"),
        (1234567, "1.235e6"),
        (6_400_000, "6.4e6"),
        (-0.00012345, "-0.0001234"),
        (0.00001, "1e-5"),
        (arb("1.23456789", "1e-12"), "1.235"),
        (arb("1.2", "0.3"), "≈1"),
        (arb(0, 1), "0"),
    ],
)
def test_rounded(x: Any, said: str) -> None:
    assert rounded(x) == said


@pytest.mark.parametrize(
    ("x", "unit", "said"),
    [
        (70, "m/s", "252 km/h"),
        (12500, "kg", "12.5 t"),
        (900, "kg", "900 kg"),
        (1.6, "s", "1.6 s"),
        (0.023, "s", "23 ms"),
        (35 * 10**6, "N/m", "35 kN/mm"),
        (6.4e6, "N m²", "6.4 MN m²"),
        (0.0031, "m", "3.1 mm"),
        (3.2, "Hz", "3.2 Hz"),
        (5, "", "5"),
        (arb("131.61111111", "1e-9"), "m/s", "473.8 km/h"),
    ],
)
def test_spoken(x: Any, unit: str, said: str) -> None:
    assert spoken(x, unit) == said


def test_both_units_stand_beside_each_other() -> None:
    assert beside(Fraction(70), "m/s") == "70 m/s (252 km/h)"
    assert beside(Fraction(900), "kg") == "900 kg"
    assert beside(Fraction(32000), "kg") == "32000 kg (32 t)"
    assert beside(Fraction(0), "m/s") == "0 m/s"
    assert said_in(Fraction(1, 100), "m") == "mm"


@given(st.floats(1e-12, 1e12), st.integers(1, 8))
def test_rounding_is_near(x: float, figures: int) -> None:
    assert abs(float(rounded(x, figures)) - x) <= 0.51 * 10.0 ** (1 - figures) * 10 * x


@pytest.mark.parametrize(
    ("x", "said"),
    [(Fraction(1813, 2), "906.5"), (Fraction(1, 3), "1/3"), (Fraction(5), "5"), (Fraction(-1, 80), "-0.0125")],
)
def test_decimals_are_exact(x: Fraction, said: str) -> None:
    assert decimal(x) == said
    assert Fraction(said) == x
