"""The closed sum is the sum of its terms; its slope is its derivative; the sides of the roots do not matter."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from fractions import Fraction

import numpy as np
import pytest
from endless_rows import bogies, brute_sum, masses

from mpsolve.endless.bloch import Bloch
from mpsolve.endless.lattice import Lattice, first_force
from mpsolve.endless.row import Row

POINTS = [(0.3 + 0.2j, 0.7), (0.05 + 0.6j, -2.0), (0.02 + 0.25j, 3.0)]


@pytest.mark.parametrize("make", [masses, bogies])
@pytest.mark.parametrize(("sigma", "theta"), POINTS)
def test_it_is_the_sum_over_the_row(make: Callable[[str], Row], sigma: complex, theta: float) -> None:
    row = make("0.4")
    z, bloch = np.exp(1j * theta), Bloch(row)
    distances = (Fraction(0), row.step / 3, -row.step / 3, row.step * Fraction(7, 8))
    sums, _ = Lattice(distances, row.step).sums(bloch.terms(np.array([sigma])), bloch.upper, z, float, np.exp)
    for a, found in zip(distances, sums, strict=True):
        truth = brute_sum(row, a, z, sigma, 200)
        assert abs(found[0] - truth) < 1e-10 * abs(truth)


def test_the_slope_is_the_derivative() -> None:
    row = masses("0.4")
    bloch, z, h = Bloch(row), np.exp(2.1j), 1e-5
    lattice = Lattice((Fraction(0), row.step / 4, -row.step / 4), row.step)
    at = lambda s: lattice.sums(bloch.terms(np.array([s])), bloch.upper, z, float, np.exp)  # noqa: E731
    low, high, (_, slopes) = at(0.1 + 0.3j - h)[0], at(0.1 + 0.3j + h)[0], at(0.1 + 0.3j)
    for a, b, slope in zip(low, high, slopes, strict=True):
        assert abs((b - a) / (2 * h) - slope) < 1e-7 * abs(slope)


def test_the_sum_does_not_depend_on_which_roots_are_upper() -> None:
    row = masses("0.4")
    bloch, z = Bloch(row), np.exp(2.1j)
    terms = bloch.terms(np.array([0.1 + 0.3j]))
    lattice = Lattice((Fraction(0), row.step / 4, -row.step / 4), row.step)
    one, other = (lattice.sums(terms, upper, z, float, np.exp)[0] for upper in (2, 3))
    assert np.allclose(one, other, rtol=1e-12)
    wrong = [replace(terms[0], w=2 * terms[0].w), *terms[1:]]
    assert not np.allclose(one, lattice.sums(wrong, 2, z, float, np.exp)[0], rtol=1e-3)


def test_the_first_force_is_on_its_side() -> None:
    d = Fraction(3)
    for a in (Fraction(0), Fraction(1), Fraction(-1)):
        assert 0 <= first_force(a, d, True)[0] < d
        assert -d <= first_force(a, d, False)[0] < 0
