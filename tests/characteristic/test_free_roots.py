"""Models of p-roots hold the roots of the polynomial, at real and complex points of their boxes, and are narrow."""

from __future__ import annotations

import numpy as np

from mpsolve.characteristic.free_roots import free_roots
from mpsolve.numbers.quadratic import Quadratic, pairs

# D = P² + (3 + u₁)P + 2 + u₂/10, N = 1 + u₁ P; u scaled by h
H = 0.05


def _models(h: float) -> tuple[Quadratic, Quadratic]:
    D, N = np.zeros((6, 1, 3), complex), np.zeros((6, 1, 2), complex)
    D[0, 0] = [2, 3, 1]
    D[1, 0, 1], D[2, 0, 0] = h, h / 10
    N[0, 0, 0], N[1, 0, 1] = 1, h
    return Quadratic(D, np.zeros((1, 3)), 2), Quadratic(N, np.zeros((1, 2)), 2)


def _at(f: Quadratic, u: tuple[complex, complex], root: int) -> complex:
    k = f.k[:, 0, root]
    second = sum(k[3 + n] * u[i] * u[j] for n, (i, j) in enumerate(pairs(2)))
    return complex(k[0] + k[1] * u[0] + k[2] * u[1] + second)


def test_roots_and_weights_are_held() -> None:
    D, N = _models(H)
    found = free_roots(D, N, np.array([[-1.0 + 0j, -2.0]]), np.zeros((1, 2)))
    assert found.good.all()
    for u in ((0.3, -0.9), (1, 1), (-1, 1j), (0.6 + 0.8j, -1)):
        b, c = 3 + H * u[0], 2 + H * u[1] / 10
        split = np.sqrt(b * b - 4 * c + 0j)
        for k, root in enumerate(((-b + split) / 2, (-b - split) / 2)):
            weight = (1 + H * u[0] * root) / (2 * root + b)
            assert abs(_at(found.P, u, k) - root) <= found.P.e[0, k] + 1e-14
            assert abs(_at(found.w, u, k) - weight) <= found.w.e[0, k] + 1e-14
    assert found.P.e.max() < 20 * H**3
    thin = free_roots(*_models(H / 10), np.array([[-1.0 + 0j, -2.0]]), np.zeros((1, 2)))
    assert thin.P.e.max() < found.P.e.max() / 500  # of third order


def test_roots_that_may_meet_are_refused() -> None:
    D, N = _models(1.5)
    assert not free_roots(D, N, np.array([[-1.0 + 0j, -2.0]]), np.zeros((1, 2))).good.all()
