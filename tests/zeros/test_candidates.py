"""Poles of a rational approximation are near the truth; what cannot be approximated gives none."""

from __future__ import annotations

import numpy as np

from mpsolve.zeros.candidates import poles_by_aaa


def test_poles_of_a_rational_function_are_exact_to_rounding() -> None:
    path = 2 * np.exp(2j * np.pi * np.arange(60) / 60)
    poles = np.array([0.3, -0.5 + 1j, 1.1j])
    values = sum(k / (path - p) for k, p in enumerate(poles, 1)) + np.exp(path)
    got = poles_by_aaa(path, values, 25)
    for p in poles:
        assert np.abs(got - p).min() < 1e-8
    assert poles_by_aaa(path[:3], values[:3], 20).size == 0
    assert poles_by_aaa(path, np.full(60, np.nan), 20).size == 0
