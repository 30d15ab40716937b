"""Stacks of matrices: one entry of the stack is what it is alone, and large exponents do not hurt."""

from __future__ import annotations

import numpy as np
from numpy.polynomial.polynomial import polyval2d

from mpsolve.numbers.float64 import Float64, distinct, value_at

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
