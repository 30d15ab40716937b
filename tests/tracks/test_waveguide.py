"""Exact polynomials in P and s: arithmetic against plain evaluation, determinants against sympy."""

from __future__ import annotations

from fractions import Fraction

import pytest
import sympy as sp
from hypothesis import given
from hypothesis import strategies as st

from mpsolve import tracks
from mpsolve.numbers.several import multiply, plus
from mpsolve.tracks.waveguide import Polynomial, determinant, moving, power, scaled

NUMBERS = st.fractions(min_value=-3, max_value=3, max_denominator=4)
POLYNOMIALS = st.dictionaries(st.tuples(st.integers(0, 2), st.integers(0, 2)), NUMBERS.filter(bool), max_size=3)


def value(a: Polynomial, P: Fraction, s: Fraction) -> Fraction:
    return sum((c * P**i * s**j for (i, j), c in a.items()), Fraction(0))


@given(POLYNOMIALS, POLYNOMIALS, NUMBERS, NUMBERS, NUMBERS)
def test_arithmetic_is_that_of_values(a: Polynomial, b: Polynomial, P: Fraction, s: Fraction, v: Fraction) -> None:
    assert value(plus(a, b), P, s) == value(a, P, s) + value(b, P, s)
    assert value(multiply(a, b), P, s) == value(a, P, s) * value(b, P, s)
    assert value(scaled(a, v), P, s) == v * value(a, P, s)
    assert value(moving(a, v), P, s) == value(a, P, s - v * P)
    assert all(plus(a, b).values())


@given(st.lists(st.lists(POLYNOMIALS, min_size=3, max_size=3), min_size=3, max_size=3), NUMBERS, NUMBERS)
def test_a_determinant_is_sympys(rows: list[list[Polynomial]], P: Fraction, s: Fraction) -> None:
    numbers = sp.Matrix([[sp.Rational(*value(entry, P, s).as_integer_ratio()) for entry in row] for row in rows])
    found = value(determinant(tuple(map(tuple, rows))), P, s)
    assert sp.Rational(found.numerator, found.denominator) == numbers.det()


def test_the_power_is_that_of_complex_numbers() -> None:
    """−Im(N conj D) = Ω w(p², Ω²), with D and N at P = ip, s = iΩ."""
    track = tracks.TwoLayer(EI=3, m=2, k_pad=5, c_pad="0.5", m_sleeper=1, k_ballast=4, c_ballast="0.25", kp="0.3")
    guide, p, omega = track.waveguide, 0.7, 1.3
    D, N = (sum(float(c) * (1j * p) ** i * (1j * omega) ** j for (i, j), c in x.items())
            for x in (guide.dispersion, guide.numerator))  # fmt: skip
    w = sum(
        float(c) * p ** (2 * i) * omega ** (2 * j) for (i, j), c in power(guide.dispersion, guide.numerator).items()
    )
    assert w * omega == pytest.approx(-(N * D.conjugate()).imag, rel=1e-12)
