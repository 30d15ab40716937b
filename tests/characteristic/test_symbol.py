"""Symbols are the polynomials that they come from, in every arithmetic."""

from __future__ import annotations

from fractions import Fraction

import numpy as np
import pytest
from multiprecision import Multiprecision
from residue import TRACKS

from mpsolve.characteristic.symbol import Symbol, Symbols, horner, product, slope_in_P
from mpsolve.numbers.balls import Balls, acb, precision
from mpsolve.numbers.float64 import Float64
from mpsolve.problem.reduced import track_guide

POLYNOMIAL = {(0, 0): Fraction(1, 3), (2, 1): Fraction(-5), (2, 0): Fraction(2), (1, 3): Fraction(7, 2)}
"""1/3 + (2 − 5σ) P² + 7/2 σ³ P."""


def test_the_same_in_all_arithmetics() -> None:
    symbol = Symbol.of(POLYNOMIAL)
    exact = [1 / 3, 3.5 * (0.5 - 1j) ** 3, 2 - 5 * (0.5 - 1j)]
    floats = symbol.at(Float64(), np.array([0.5 - 1j]))
    digits = symbol.at(Multiprecision(30), 0.5 - 1j)
    with precision(80):
        balls = symbol.at(Balls(), acb(0.5, -1))
    for found in ([x[0] for x in floats], digits, balls):
        assert [complex(x) for x in found] == pytest.approx(exact, rel=1e-15)


@pytest.mark.parametrize("name", TRACKS)
def test_slopes_in_sigma(name: str) -> None:
    symbols = Symbols.of(track_guide(TRACKS[name], Fraction(10)))
    K, s, h = Multiprecision(40), 0.25 + 0.5j, Fraction(1, 10**10)
    for symbol, slope in ((symbols.D, symbols.D_sigma), (symbols.N, symbols.N_sigma)):
        step = K.number(h)
        ends = [symbol.at(K, s + step), symbol.at(K, s - step)]
        rates = [(a - b) / (2 * step) for a, b in zip(*ends, strict=True)]
        found = [*slope.at(K, s), *[0] * len(rates)]
        assert all(abs(a - b) < 1e-15 * (1 + abs(b)) for a, b in zip(found, rates, strict=False))
    assert symbols.degree == len(symbols.D.rows) - 1


def test_polynomials_in_p() -> None:
    assert product([1, 2], [3, 0, 1]) == [3, 6, 1, 2]
    assert horner([3, 6, 1, 2], 2) == 3 + 12 + 4 + 16
    assert slope_in_P([3, 6, 1, 2]) == [6, 2, 6]
    assert horner([], 2.0) == 0
