"""The receptance table against Fourier integrals along the real p-axis, and what cannot be asked for."""

from __future__ import annotations

import numpy as np
import pytest

from mpsolve import Case, InputError, receptance

CASE = Case(alpha="0.8", eta_b="0.1", eta_m=(10, 10), positions=(0, 1), eta_n="0.2")


def integral(case: Case, xi: float, q: complex) -> complex:
    """∫ e^{ipξ}/D dp over |p| ≤ 400, by Gauss–Legendre panels; beyond, 1/D is below p⁻⁴ and the rest below 2e-8."""
    alpha, eta_b, axial = (float(v) for v in (case.alpha, case.eta_b, case.axial))
    ends = np.concatenate([np.linspace(0, 12, 121), np.linspace(12, 400, 1001)[1:]])
    nodes, weights = np.polynomial.legendre.leggauss(16)
    half = np.diff(ends)[:, None] / 2
    p = ((ends[1:] + ends[:-1])[:, None] / 2 + half * nodes).ravel()
    total = 0j
    for sign in (1, -1):
        k = sign * p
        D = k**4 - 4 * k * k * (axial + alpha**2) - 4 * q * q + 8 * alpha * k * q + 8j * eta_b * (q - alpha * k) + 4
        total += complex(np.sum((half * weights).ravel() * np.exp(1j * k * xi) / D))
    return total


def test_it_is_the_fourier_integral() -> None:
    xi, q = [-1.5, 0.0, 0.7], [0.3 - 0.2j, 1.5 - 0.4j, -0.1 - 1j]
    table = receptance(CASE, xi, q)
    assert table.shape == (3, 3)
    for i, place in enumerate(xi):
        for j, point in enumerate(q):
            assert abs(table[i, j] - integral(CASE, place, point)) < 2e-8


def test_symmetry_and_scalars() -> None:
    table = receptance(CASE, 0.4, np.array([0.3 - 0.2j, -0.3 - 0.2j]))
    assert abs(table[0, 1] - table[0, 0].conj()) < 1e-13


def test_undamped_real_frequencies_in_the_gap_are_real() -> None:
    case = Case(alpha="0.5", eta_b=0, eta_m=1)
    table = receptance(case, 0.0, [0.1, 0.5])
    assert np.abs(table.imag).max() < 1e-13
    assert (table.real > 0).all()


@pytest.mark.parametrize(
    ("case", "xi", "q", "key"),
    [
        (CASE, [np.nan], [0], "xi"),
        (CASE, [[0.0]], [0], "xi"),
        (CASE, [0], [1 + 0.1j], "q"),
        (Case(alpha="0.5", eta_b=0, eta_m=1), [0], [1.7], "q"),
        (Case(alpha=1, eta_b=2, eta_m=1), [0], [1 + 1j], "q"),
    ],
)
def test_bad_input(case: Case, xi: list[float], q: list[complex], key: str) -> None:
    with pytest.raises(InputError) as caught:
        receptance(case, xi, q)
    assert caught.value.key == key
