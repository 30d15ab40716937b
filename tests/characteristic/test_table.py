"""Expansions of polynomials in floats against exact ones in rational numbers."""

from __future__ import annotations

from fractions import Fraction
from math import comb
from typing import Any

import numpy as np
import pytest
from track_models import DAMPED

from mpsolve.characteristic.table import Table
from mpsolve.errors import PrecisionError
from mpsolve.numbers.jets import U
from mpsolve.problem.reduced import track_guide
from mpsolve.tracks.waveguide import Polynomial

Complex = tuple[Fraction, Fraction]


def times(a: Complex, b: Complex) -> Complex:
    return a[0] * b[0] - a[1] * b[1], a[0] * b[1] + a[1] * b[0]


def power(z: Complex, k: int) -> Complex:
    out = (Fraction(1), Fraction(0))
    for _ in range(k):
        out = times(out, z)
    return out


def exact(z: complex) -> Complex:
    return Fraction(z.real), Fraction(z.imag)


def coefficient(polynomial: Polynomial, z: complex, sigma: complex, i: int, j: int) -> tuple[Complex, float]:
    """That of e^i t^j at (z + e, σ + t), and the sum of the moduli of its terms."""
    total, size = (Fraction(0), Fraction(0)), 0.0
    for (a, b), c in polynomial.items():
        if a >= i and b >= j:
            x, y = times(power(exact(z), a - i), power(exact(sigma), b - j))
            factor = c * comb(a, i) * comb(b, j)
            total = total[0] + factor * x, total[1] + factor * y
            size += float(abs(factor)) * abs(z) ** (a - i) * abs(sigma) ** (b - j)
    return total, size


def distance(a: complex, b: Complex) -> float:
    return float(np.hypot(float(Fraction(a.real) - b[0]), float(Fraction(a.imag) - b[1])))


@pytest.mark.parametrize("name", DAMPED)
@pytest.mark.parametrize("v", [0, 30])
def test_expansions_are_within_their_errors(name: str, v: int) -> None:
    guide = track_guide(DAMPED[name], Fraction(v))
    rng = np.random.default_rng(v + len(name))
    for polynomial in (guide.D, guide.N):
        table = Table.of(polynomial)
        sigma = (rng.normal(size=4) + 1j * rng.normal(size=4)) * np.array([0.0, 0.3, 1.0, 40.0])
        z = (rng.normal(size=(4, 3)) + 1j * rng.normal(size=(4, 3))) * np.array([1e-3, 1.0, 20.0])
        T, error = table.in_time(sigma)
        c, lost = table.at(z, T, error)
        for d, k, i, j in np.ndindex(*c.shape):
            truth, size = coefficient(polynomial, complex(z[d, k]), complex(sigma[d]), i, j)
            off = distance(c[d, k, i, j], truth)
            # eight times more than what can be lost, so that later operations may lose as much (its docstring)
            assert off <= lost[d, k, i, j] / 8 + 1e-290
            assert lost[d, k, i, j] <= 3000 * U * size + 1e-270


def test_the_matrix_in_time_is_within_its_errors() -> None:
    polynomial = {(2, 3): Fraction(1, 3), (2, 0): Fraction(-1, 7), (0, 3): Fraction(1), (0, 1): Fraction(22, 7)}
    sigma = np.array([0j, 1e-200 + 0j, 0.3 + 2j, -5j])
    T, error = Table.of(polynomial).in_time(sigma)
    for d, j, i in np.ndindex(*T.shape):
        truth: Any = [Fraction(0), Fraction(0)]
        for (a, b), c in polynomial.items():
            if a == i and b >= j:
                x, y = power(exact(complex(sigma[d])), b - j)
                truth = [truth[0] + c * comb(b, j) * x, truth[1] + c * comb(b, j) * y]
        assert distance(T[d, j, i], (truth[0], truth[1])) <= error[d, j, i]


def test_coefficients_that_no_float_holds_are_refused() -> None:
    with pytest.raises(PrecisionError):
        Table.of({(2, 0): Fraction(1), (0, 2): Fraction(1, 10**330)})
