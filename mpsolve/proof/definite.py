"""Hermitian matrices, many at once, proved positive definite in float64 with bounds."""

from __future__ import annotations

from typing import Any

import numpy as np

from mpsolve.numbers.arrays import Reals
from mpsolve.numbers.jets import UP, Jet, U
from mpsolve.proof.turning import weighed

_MOST = 0.98  # of θ: below 1 by a margin, so that a checker that rounds otherwise agrees


@np.errstate(all="ignore")
def positive_definite(H: Any, E: Reals) -> Any:
    """Whether H₀ + Σ ε_k H_k + R is positive definite for all |ε_k| ≤ 1 and Hermitian |R| ≤ E, entry by entry.

    H: (boxes, 1 + k, n, n), E: (boxes, n, n). X H X* = 1 + F with |F| x ≤ θ x, θ < 1, for some regular X and x > 0.
    """
    n = H.shape[2]
    finite = np.isfinite(H).all((1, 2, 3)) & np.isfinite(E).all((1, 2))
    H0 = np.where(finite[:, None, None], H[:, 0], -np.eye(n))
    values, vectors = np.linalg.eigh(H0)
    sane = values[:, 0] > 0
    values = np.where(sane[:, None], values, 1.0)
    X = vectors / np.sqrt(values)[:, None] @ np.swapaxes(vectors.conj(), 1, 2)  # ≈ H₀^(−1/2): its entries fall off
    size, Xh = np.abs(X), np.swapaxes(X.conj(), 1, 2)
    whole = np.abs(H).sum(1)
    lost = 64 * (n + 4) * U
    F = np.abs(X @ H0 @ Xh - np.eye(n)) + lost * np.eye(n)
    for k in range(1, H.shape[1]):
        F = F + np.abs(X @ H[:, k] @ Xh)
    F = (F + size @ (E + lost * whole) @ np.swapaxes(size, 1, 2)) * UP
    F = np.where(sane[:, None, None], F, 1.0)
    return finite & sane & (weighed(F)[1] < _MOST)


def positive(V: Jet, way: Any, drift: Reals) -> Any:
    """True where V + V* is positive definite for t along `way` |t| ≤ r, to within `drift` of the line."""
    n, r = V.a.shape[1], V.r[:, None, None]
    with np.errstate(all="ignore"):
        H = np.stack([_hermitian(V.a), _hermitian(way[:, None, None] * V.b) * r], 1)
        rest = V.e + drift[:, None, None] * np.abs(V.b) + 64 * (n + 4) * U * (np.abs(V.a) + np.abs(V.b) * r)
        return positive_definite(H, (rest + np.swapaxes(rest, 1, 2)) / 2)


def _hermitian(a: Any) -> Any:
    return (a + np.swapaxes(a.conj(), 1, 2)) / 2
