"""Polynomials over boxes: inside, at third order, negative powers and powers of 0 too."""

from fractions import Fraction

import numpy as np

from mpsolve.numbers.forms import Forms
from mpsolve.numbers.quadratic import pairs

POLYNOMIALS = [
    {(0, 0): Fraction(3), (2, 1): Fraction(-1, 3), (1, 4): Fraction(2)},
    {(3, -1): Fraction(1, 7), (0, -2): Fraction(5)},
    {},
]


def truth(terms: dict[tuple[int, ...], Fraction], y: np.ndarray) -> complex:
    return sum((float(c) * y[0] ** e[0] * y[1] ** e[1] for e, c in terms.items()), 0j)


def test_values_at_points_of_the_boxes_are_inside() -> None:
    rng = np.random.default_rng(3)
    y = np.stack([1j * rng.uniform(0, 2, 30), rng.uniform(1, 2, 30) + 0j])
    y[0, 0] = 0
    rho = np.stack([1j * rng.uniform(0, 0.2, 30), rng.uniform(0, 0.2, 30) + 0j])
    found = Forms.of(POLYNOMIALS, 2)(y, rho)
    for _ in range(40):
        u = rng.uniform(-1, 1, (2, 30))
        z = y + rho * u
        weights = np.stack([np.ones(30), *u, *(u[i] * u[j] for i, j in pairs(2))])
        value = np.einsum("kb,kbp->bp", weights, found.k)
        exact = np.array([[truth(terms, z[:, b]) for terms in POLYNOMIALS] for b in range(30)])
        assert (np.abs(value - exact) <= found.e + 1e-13 * np.abs(exact)).all()


def test_the_remainder_is_of_third_order_and_0_where_there_is_none() -> None:
    forms = Forms.of([{(2, 0): Fraction(1)}, {(3, 0): Fraction(1)}], 2)
    for r in (0.1, 0.01):
        e = forms(np.array([[1.0 + 0j], [1.0]]), np.array([[r + 0j], [0.0]])).e[0]
        assert e[0] < 1e-11
        assert r**3 * 0.9 < e[1] < r**3 * 1.1 + 1e-11


def test_a_negative_power_over_a_box_with_0_is_not_bounded() -> None:
    found = Forms.of([{(0, -1): Fraction(1)}], 2)(np.array([[1j], [0.1 + 0j]]), np.array([[0j], [0.2 + 0j]]))
    assert not np.isfinite(found.e).any()


def test_a_matrix_of_spreads_turns_the_variables() -> None:
    rng = np.random.default_rng(5)
    y = np.stack([1j * rng.uniform(0, 2, 20), rng.uniform(1, 2, 20) + 0j])
    rho = np.zeros((2, 2, 20), complex)
    rho[0, 0], rho[0, 1], rho[1, 1] = 1j * rng.uniform(0, 0.2, 20), 1j * rng.uniform(-0.2, 0.2, 20), 0.1
    rho[0, :, 3] = rho[:, 0, 4] = 0
    found = Forms.of(POLYNOMIALS, 2)(y, rho)
    straight = Forms.of([{(1, 0): Fraction(1)}], 2)(y, rho)
    assert np.allclose(straight.b[:, :, 0], rho[0])
    for _ in range(40):
        u = rng.uniform(-1, 1, (2, 20)) * np.exp(2j * np.pi * rng.uniform(size=(2, 20)))
        z = y + (rho * u[None]).sum(1)
        weights = np.stack([np.ones(20), *u, *(u[i] * u[j] for i, j in pairs(2))])
        value = np.einsum("kb,kbp->bp", weights, found.k)
        exact = np.array([[truth(terms, z[:, b]) for terms in POLYNOMIALS] for b in range(20)])
        assert (np.abs(value - exact) <= found.e + 1e-13 * np.abs(exact)).all()
    assert (found.e[:, 0] < 0.3).all()  # of third order
