"""Tests of pieces of a path in the q-plane: the splitting is carried on, Δ̂ turns, the mobility is passive.

Points are complex floats q̂ (scaled); σ̂ = i q̂. Every piece stands for a disc that holds it.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np

from mpsolve.characteristic.bordered import Arrays
from mpsolve.characteristic.discs import Splittings, linked, split
from mpsolve.numbers.jets import UP, Jet, U
from mpsolve.proof.turning import pivot_arguments, regular


@dataclass(frozen=True)
class PathTests:
    """The three tests of a problem with `up` p-roots in U, for `mpsolve.proof.cover`."""

    arrays: Arrays
    up: int

    def link(self, a: Any, b: Any) -> tuple[Any, Any, Any]:
        """The splitting exists on each disc and is the same at common points."""
        m, r = discs(a, b)
        s = split(self.arrays.D, m, r, self.up)
        good = s.good & self._joined(s, a, b)
        return good, np.zeros(len(a)), np.zeros(len(a))

    def turn(self, a: Any, b: Any) -> tuple[Any, Any, Any]:
        """Δ̂ ≠ 0 on each disc; the change of arg Δ̂ from a to b."""
        m, r = discs(a, b)
        s, G, good = self.arrays.evaluate(m, r, self.up)
        piece = regular(self.arrays.matrix(G, m))
        good = good & piece.good
        value, error = np.zeros(len(a)), np.zeros(len(a))
        rows = np.flatnonzero(good)
        if not len(rows):
            return good, value, error
        points, index = np.unique(np.concatenate([a[rows], b[rows]]), return_inverse=True)
        thin, thin_G, thin_good = self.arrays.evaluate(1j * points, np.zeros(len(points)), self.up)
        A = self.arrays.matrix(thin_G, 1j * points)
        own = _take(piece, rows)
        discs_ = s.take(rows)
        for end, sign in ((index[: len(rows)], -1.0), (index[len(rows) :], 1.0)):
            turned, lost, fine = pivot_arguments(own, A.take(end))
            good[rows] &= fine & thin_good[end] & linked(discs_, thin.take(end))
            value[rows] += sign * turned
            error[rows] += lost
        return good, value, error

    def passive(self, a: Any, b: Any) -> tuple[Any, Any, Any]:
        """The Hermitian part of σG between the places is positive definite on each piece."""
        m, r = discs(a, b)
        s, G, good = self.arrays.evaluate(m, r, self.up)
        sigma = Jet(m[:, None, None], np.ones((len(m), 1, 1), complex), np.zeros((len(m), 1, 1)), r)
        way = 1j * (b - a) / np.abs(b - a)
        good = good & positive(sigma * G, way)
        good[good] &= self._joined(s.take(good), a[good], b[good])
        return good, np.zeros(len(a)), np.zeros(len(a))

    def _joined(self, s: Splittings, a: Any, b: Any) -> Any:
        if not len(a):
            return np.zeros(0, bool)
        points, index = np.unique(np.concatenate([a, b]), return_inverse=True)
        thin = split(self.arrays.D, 1j * points, np.zeros(len(points)), self.up)
        return linked(s, thin.take(index[: len(a)])) & linked(s, thin.take(index[len(a) :]))


def discs(a: Any, b: Any) -> tuple[Any, Any]:
    """Midpoints and radii in σ̂ of discs that hold the pieces from a to b."""
    m = (a + b) / 2
    r = np.maximum(np.abs(a - m), np.abs(b - m)) * UP
    return 1j * m, r


def positive(V: Jet, way: Any) -> Any:
    """True where V + V* is positive definite for t along `way` (unit vectors), |t| ≤ r."""
    n = V.a.shape[1]
    with np.errstate(all="ignore"):
        H0, H1 = _hermitian(V.a), _hermitian(way[:, None, None] * V.b)
        finite = np.isfinite(V.a).all((1, 2)) & np.isfinite(V.e).all((1, 2))
        definite = np.linalg.eigvalsh(np.where(finite[:, None, None], H0, -np.eye(n)))[:, 0] > 0
        ok = finite & definite
        X = np.linalg.inv(np.linalg.cholesky(np.where(ok[:, None, None], H0, np.eye(n))))
        size, lost = np.abs(X), 64 * (n + 4) * U
        Xh, sizeh = np.swapaxes(X.conj(), 1, 2), np.swapaxes(size, 1, 2)
        r = V.r[:, None, None]
        # the piece runs through the middle to within rounding of the middle
        rest = (V.e + np.swapaxes(V.e, 1, 2)) / 2 + np.abs(V.b) * 1e-14 * r + np.swapaxes(np.abs(V.b), 1, 2) * 1e-14 * r
        spread = rest + lost * (np.abs(V.a) + np.swapaxes(np.abs(V.a), 1, 2) + (np.abs(V.b) + np.swapaxes(np.abs(V.b), 1, 2)) * r)
        E = np.abs(X @ H0 @ Xh - np.eye(n)) + np.abs(X @ H1 @ Xh) * r + lost + size @ spread @ sizeh
        E = E * UP
        x = np.ones((len(E), n))
        for _ in range(12):
            y = np.einsum("bij,bj->bi", E, x)
            x = y / y.max(1, keepdims=True) + 1e-4
        return ok & (np.max(np.einsum("bij,bj->bi", E, x) / x, axis=1) * UP < 0.95)


def _hermitian(a: Any) -> Any:
    return (a + np.swapaxes(a.conj(), 1, 2)) / 2


def _take(piece: Any, rows: Any) -> Any:
    return type(piece)(piece.R[rows], piece.x[rows], piece.theta[rows], piece.good[rows])
