"""Definite matrices against eigenvalues."""

import numpy as np
import pytest

from mpsolve.numbers.jets import Jet
from mpsolve.proof.definite import positive, positive_definite


def test_definite_matrices_with_slopes() -> None:
    H = np.array([[[[2, 0], [0, 1]], [[0, 0.5], [0.5, 0]]], [[[2, 0], [0, 1]], [[0, 1.5], [1.5, 0]]]], complex)
    E = np.zeros((2, 2, 2))
    assert positive_definite(H, E).tolist() == [True, False]
    assert not positive_definite(H, E + 0.9).any()


def test_what_is_proved_has_positive_eigenvalues_at_its_corners() -> None:
    draw = np.random.default_rng(5)
    A = draw.normal(size=(60, 3, 3, 3)) + 1j * draw.normal(size=(60, 3, 3, 3))
    H = (A + np.swapaxes(A.conj(), 2, 3)) / 2 * np.array([1, 0.2, 0.2])[:, None, None]
    H[:, 0] += 2.5 * np.eye(3)
    proved = positive_definite(H, np.full((60, 3, 3), 0.01))
    assert 5 < proved.sum() < 60
    for s in (-1, 1):
        for t in (-1, 1):
            low = np.linalg.eigvalsh(H[:, 0] + s * H[:, 1] + t * H[:, 2])[:, 0]
            assert (low[proved] > 0.01).all()


def test_matrices_that_are_not_finite_are_not_proved() -> None:
    H = np.full((2, 1, 2, 2), np.nan, complex)
    H[1, 0] = np.eye(2)
    assert positive_definite(H, np.zeros((2, 2, 2))).tolist() == [False, True]
    assert not positive_definite(H, np.full((2, 2, 2), np.inf)).any()


def test_where_it_is_proved_positive_the_hermitian_part_is() -> None:
    rng = np.random.default_rng(4)
    count, n = 300, 4
    base = rng.normal(size=(count, n, n)) + 1j * rng.normal(size=(count, n, n))
    a = base @ np.swapaxes(base.conj(), 1, 2) + 1j * (base + np.swapaxes(base.conj(), 1, 2))
    b = rng.normal(size=a.shape) + 1j * rng.normal(size=a.shape)
    e = 1e-3 * rng.uniform(size=a.shape)
    r, way = 10.0 ** rng.uniform(-3, 0, count), np.exp(2j * np.pi * rng.uniform(size=count))
    good = positive(Jet(a, b, e, r), way, np.zeros(count))
    assert 20 < good.sum() < 280
    least = np.full(count, np.inf)
    for t in np.linspace(-1, 1, 21):
        for _ in range(4):
            noise = e * np.exp(2j * np.pi * rng.uniform(size=a.shape))
            V = a + b * (way * t * r)[:, None, None] + noise
            least = np.minimum(least, np.linalg.eigvalsh(V + np.swapaxes(V.conj(), 1, 2))[:, 0])
    assert (least[good] > 0).all()
    thin = positive(Jet(a, b, 0 * e, 0 * r), way, np.zeros(count))
    H = np.linalg.eigvalsh(a + np.swapaxes(a.conj(), 1, 2))
    assert (thin == (H[:, 0] > 0)).all()


@pytest.mark.parametrize("t", [0.97, 0.99])
def test_at_the_edge_of_being_positive(t: float) -> None:
    one = np.ones((1, 1, 1), complex)
    wide = positive(Jet(one, one, np.zeros((1, 1, 1)), np.array([t])), np.ones(1), np.zeros(1))
    rest = positive(Jet(one, 0 * one, np.full((1, 1, 1), t), np.zeros(1)), np.ones(1), np.zeros(1))
    across = positive(Jet(one, one, np.zeros((1, 1, 1)), np.array([t])), np.array([1j]), np.zeros(1))
    drift = positive(Jet(one, one, np.zeros((1, 1, 1)), np.array([t])), np.array([1j]), np.array([t]))
    assert [wide[0], rest[0], drift[0]] == [t < 0.98] * 3
    assert across[0]


def test_negative_and_endless_matrices_are_not_positive() -> None:
    zero = np.zeros((1, 2, 2))
    for a in (-np.eye(2), np.zeros((2, 2)), np.full((2, 2), np.nan), np.full((2, 2), np.inf), np.diag([1.0, -1e-9])):
        assert not positive(Jet(a[None] + 0j, 0j * zero, zero, np.zeros(1)), np.ones(1), np.zeros(1))[0]
