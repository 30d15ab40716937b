"""Stacks of matrices: one entry of the stack is what it is alone, and large exponents do not hurt."""

from __future__ import annotations

import numpy as np
from numpy.polynomial.polynomial import polyval2d

from mpsolve.numbers.float64 import Float64, distinct, log_slope, lowest, value_at

K = Float64()


def test_a_stack_is_its_matrices() -> None:
    x = np.array([0.1, 2.0, 30.0])
    stack = K.exp(K.matrix([[-x, x / 2], [0 * x, -2 * x]]))
    for k, a in enumerate(x):
        alone = np.exp(-a), np.exp(-2 * a), 0.5 * (np.exp(-a) - np.exp(-2 * a))
        assert np.allclose([stack[k, 0, 0], stack[k, 1, 1], stack[k, 0, 1]], alone, rtol=1e-11, atol=1e-25)


def test_scalars_spread_over_the_stack() -> None:
    a = K.matrix([[np.array([1.0, 2.0]), 3.0]])
    assert a.shape == (2, 1, 2)
    assert np.array_equal(K.times(a, np.array([1, 10]))[1], [[20, 30]])
    assert np.array_equal(K.entry(a, 0, 1), [3, 3])
    assert K.matrix([]).shape == (0, 0)


def test_distinct_is_numpys_unique() -> None:
    rng = np.random.default_rng(1)
    for x in (
        rng.integers(0, 9, 50).astype(float),
        rng.integers(0, 3, 40) + 1j * rng.integers(0, 3, 40),
        np.zeros(0),
    ):
        found = distinct(x)
        wanted, index = np.unique(x, return_inverse=True)
        assert (found == wanted).all()
        assert (np.searchsorted(found, x) == index).all()


def test_values_of_two_variables_are_numpys_to_the_bit() -> None:
    rng = np.random.default_rng(2)
    c = rng.normal(size=(4, 3))
    for shape in ((), (5,), (2, 6)):
        x, y = rng.normal(size=(2, *shape))
        assert (value_at(x, y, c) == polyval2d(x, y, c)).all()


def test_the_slope_of_a_logarithm_of_determinants() -> None:
    """Against difference quotients; a singular matrix and one that is not finite leave the others alone."""
    draw = np.random.default_rng(4)
    A, A_slope = draw.normal(size=(2, 4, 3, 3)) + 1j * draw.normal(size=(2, 4, 3, 3))
    h = 1e-6
    moved = np.log(np.linalg.det(A + h * A_slope) / np.linalg.det(A - h * A_slope)) / (2 * h)
    assert np.allclose(log_slope(A, A_slope), moved, rtol=1e-7)
    A[1], A[2, 0, 0] = 0, np.nan
    found = log_slope(A, A_slope)
    assert np.allclose(found[[0, 3]], moved[[0, 3]], rtol=1e-7)
    assert abs(found[1]) > 1e290
    assert np.isnan(found[2])


def test_the_least_value_is_found_on_ever_finer_grids() -> None:
    x, value = lowest(lambda x: np.where(x > 0, (x - 0.3) ** 2 - 1, np.nan), np.linspace(-1, 1, 11), 21, 8)
    assert abs(x - 0.3) < 1e-6
    assert abs(value + 1) < 1e-12
    assert lowest(lambda x: x, np.linspace(0, 1, 5), 5, 3) == (0.0, 0.0)
