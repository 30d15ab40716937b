"""Determinants of models: boxes without a zero are told, boxes with one never are."""

from typing import Any

import numpy as np

from mpsolve.numbers.quadratic import Quadratic, pairs
from mpsolve.proof.vanishing import guess, nonzero, one_at_most, scalar

RNG = np.random.default_rng(11)


def matrices(boxes: int, n: int, size: float) -> Quadratic:
    count = 1 + 2 + len(pairs(2))
    k = RNG.normal(size=(count, boxes, n, n)) + 1j * RNG.normal(size=(count, boxes, n, n))
    k[1:] *= size
    k[3:] *= size
    return Quadratic(k, np.full((boxes, n, n), size**3), 2)


def at(f: Quadratic, u: Any) -> Any:
    weights = np.array([1.0, *u, *(u[i] * u[j] for i, j in pairs(2))])
    return np.tensordot(weights, f.k, 1)


def test_a_box_with_a_zero_is_never_called_free_of_one() -> None:
    for n in (1, 2, 4):
        A = matrices(200, n, 0.05)
        u = RNG.uniform(-1, 1, size=2)
        # make A singular at u in every box
        left, sizes, right = np.linalg.svd(at(A, u))
        A.k[0] -= (left[:, :, -1:] * sizes[:, -1, None, None]) @ right[:, -1:, :]
        s = scalar(A, np.ones(200, bool))
        assert not (s.good & nonzero(s.s).nonzero).any()


def test_boxes_far_from_zeros_are_told() -> None:
    A = matrices(200, 3, 1e-4)
    s = scalar(A, np.ones(200, bool))
    assert (s.good & nonzero(s.s).nonzero).mean() > 0.95


def test_a_direction_normal_to_the_slopes_tells_a_narrow_miss() -> None:
    k = np.zeros((6, 1), complex)
    k[0], k[1], k[2] = 1e-3j, 1.0, -0.5  # real slopes, a value just off the real axis
    assert nonzero(Quadratic(k, np.full(1, 1e-4), 2)).nonzero[0]
    assert not nonzero(Quadratic(k, np.full(1, 2e-3), 2)).nonzero[0]


def test_one_zero_at_most() -> None:
    k = np.zeros((6, 2), complex)
    k[0], k[1], k[2] = 0.1, 1.0, 1e-2j + 1  # nearly parallel, but regular
    k[5, 1] = 0.1j  # a bend that makes two zeros possible
    s = Quadratic(k, np.full(2, 1e-5), 2)
    assert one_at_most(s).tolist() == [True, False]
    u = guess(s)
    assert np.allclose(at(s, u[:, 0])[0], 0, atol=1e-12)
