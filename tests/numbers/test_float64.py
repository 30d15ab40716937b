"""Stacks of matrices: one entry of the stack is what it is alone, and large exponents do not hurt."""

from __future__ import annotations

import numpy as np

from mpsolve.numbers.float64 import Float64

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
