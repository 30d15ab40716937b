"""mpmath in a context of its own."""

from __future__ import annotations

from fractions import Fraction

import mpmath

from mpsolve.numbers.multiprecision import Multiprecision


def test_digits_do_not_leak() -> None:
    before = mpmath.mp.dps
    K = Multiprecision(60)
    assert abs(K.number(Fraction(1, 3)) * 3 - 1) < K.mp.mpf(10) ** -59
    assert abs(K.exp(K.matrix([[K.number(Fraction(1))]]))[0, 0] - K.mp.e) < K.mp.mpf(10) ** -58
    assert mpmath.mp.dps == before
