"""The three arithmetics do the same with the same numbers."""

from __future__ import annotations

from fractions import Fraction
from typing import Any

import numpy as np
import pytest
from multiprecision import Multiprecision

from mpsolve.numbers.arithmetic import Arithmetic
from mpsolve.numbers.balls import Balls, acb, precision
from mpsolve.numbers.float64 import Float64

A = np.array([[0.5, 2 - 1j, 0], [1j, -3, 0.25], [1, 1, 4]])
B = np.array([[1.0], [2j], [-1]])


def as_array(K: Arithmetic, a: Any, shape: tuple[int, int]) -> Any:
    return np.array([[complex(K.entry(a, i, j)) for j in range(shape[1])] for i in range(shape[0])])


def made(K: Arithmetic, a: Any) -> Any:
    number = acb if isinstance(K, Balls) else (lambda z: z)
    return K.matrix([[number(complex(x)) for x in row] for row in a])


@pytest.mark.parametrize("K", [Float64(), Multiprecision(30), Balls()])
def test_matrices(K: Arithmetic) -> None:
    with precision(100):
        a, b = made(K, A), made(K, B)
        assert np.allclose(as_array(K, K.product(a, b), (3, 1)), A @ B, rtol=1e-14)
        assert np.allclose(as_array(K, K.times(a, 2), (3, 3)), 2 * A)
        assert np.allclose(as_array(K, K.solve(a, b), (3, 1)), np.linalg.solve(A, B), rtol=1e-13)
        values, vectors = np.linalg.eig(A)
        exact = vectors @ np.diag(np.exp(values)) @ np.linalg.inv(vectors)
        assert np.allclose(as_array(K, K.exp(a), (3, 3)), exact, rtol=1e-12)
        assert complex(K.det(a)) == pytest.approx(complex(np.linalg.det(A)), rel=1e-14)
        assert complex(K.number(Fraction(1, 4))) == 0.25
        assert complex(K.evaluate((Fraction(1), Fraction(0), Fraction(3)), K.number(Fraction(2)))) == 13
