"""First-order pieces hold the functions that they stand for, and are bounded where they should be."""

from __future__ import annotations

import cmath

import numpy as np
import pytest

from mpsolve.numbers.jets import Jet


@pytest.mark.parametrize("length", [0.3, 1.0, 3.0, 20.0, 60.0])
def test_the_exponential_over_a_disc_of_any_size(length: float) -> None:
    """e^{a + bt} for |bt| ≤ length, at points of the disc, against cmath; far waves stay bounded, near ones tight."""
    rng = np.random.default_rng(int(length * 10))
    a = rng.uniform(-40, 1, 30) + 1j * rng.uniform(-30, 30, 30)
    b = np.exp(1j * rng.uniform(0, 6, 30)) * length
    r = np.ones(30)
    jet = Jet(a, b, np.zeros(30), r).exp()
    assert np.isfinite(jet.e).all()
    for t in np.exp(1j * np.linspace(0, 6, 25)):
        for k in range(30):
            left = cmath.exp(a[k] + b[k] * t) - jet.a[k] - jet.b[k] * t
            assert abs(left) <= jet.e[k] * (1 + 1e-12)
    assert (jet.e <= 1.5 * np.abs(np.exp(a)) * np.exp(length)).all()


def test_a_disc_that_is_far_too_large_is_not_bounded() -> None:
    jet = Jet(np.array([0j]), np.array([70 + 0j]), np.zeros(1), np.ones(1)).exp()
    assert jet.e[0] == np.inf
    mixed = Jet(np.array([0j, 0j]), np.array([70 + 0j, 0.5 + 0j]), np.zeros(2), np.ones(2)).exp()
    assert mixed.e[0] == np.inf
    assert mixed.e[1] < 0.2
