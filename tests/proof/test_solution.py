"""Solutions over discs hold the true ones, at every point of the disc, and are narrow."""

from __future__ import annotations

import numpy as np

from mpsolve.numbers.jets import Jet
from mpsolve.proof.solution import solution


def test_the_solution_holds_the_true_one_and_is_narrow() -> None:
    rng = np.random.default_rng(3)
    n, r = 5, 1e-3

    def draw(*shape: int) -> np.ndarray:
        return rng.normal(size=shape) + 1j * rng.normal(size=shape)

    a, b, f, g = draw(3, n, n), draw(3, n, n), draw(3, n, 1), draw(3, n, 1)
    radii = np.full(3, r)
    A, F = Jet(a, b, np.full(a.shape, 1e-9), radii), Jet(f, g, np.full(f.shape, 1e-9), radii)
    y, good = solution(A, F)
    assert good.all()
    assert (y.e < 1e-3).all()
    for _ in range(200):
        t = r * np.sqrt(rng.uniform()) * np.exp(2j * np.pi * rng.uniform())
        matrix = a + b * t + 1e-9 * np.exp(2j * np.pi * rng.uniform(size=a.shape))
        right = f + g * t + 1e-9 * np.exp(2j * np.pi * rng.uniform(size=f.shape))
        truth = np.linalg.solve(matrix, right)
        assert (np.abs(truth - y.a - y.b * t) <= y.e).all()


def test_a_singular_matrix_is_not_solved() -> None:
    a = np.array([[[1.0 + 0j, 1], [1, 1 + 1e-4]]])
    zero = np.zeros_like(a)
    A = Jet(a, zero, np.full(a.shape, 1e-3), np.array([1e-3]))
    f = Jet(np.ones((1, 2, 1), complex), np.zeros((1, 2, 1), complex), np.zeros((1, 2, 1)), np.array([1e-3]))
    assert not solution(A, f)[1].any()
