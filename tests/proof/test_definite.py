"""Definite matrices against eigenvalues."""

import numpy as np

from mpsolve.proof.definite import positive_definite


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
