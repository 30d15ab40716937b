"""A polynomial in P and σ as a table of floats, expanded at points in batches, with bounds of what rounding loses."""

from __future__ import annotations

from math import comb
from typing import Any

import numpy as np

from mpsolve.frozen import frozen
from mpsolve.numbers.arrays import Reals
from mpsolve.numbers.jets import TINY, UP, U, nearest
from mpsolve.tracks.waveguide import Polynomial


@frozen
class Table:
    """d[i, j]: the coefficient of P^i σ^j, rounded to nearest."""

    d: Any

    @classmethod
    def of(cls, polynomial: Polynomial, degree: int | None = None) -> Table:
        top = max((i for i, _ in polynomial), default=0) if degree is None else degree
        d = np.zeros((top + 1, max((j for _, j in polynomial), default=0) + 1))
        for (i, j), value in polynomial.items():
            d[i, j] = nearest(value)
        return cls(d)

    @property
    def degree(self) -> int:
        """In P."""
        return int(self.d.shape[0]) - 1

    @property
    def _loss(self) -> float:
        """The relative error of each coefficient of an expansion, against the sum of the moduli of its terms.

        The k-th power loses √5 k U, a coefficient, its weight and their product 3 U, a complex scalar product of n
        terms (BLAS, any order of the sums) √2 (2n + 2) U: together below 8 (n + 1) U. The factor is eight times that,
        so that later operations with a coefficient c, |c| − lost say, may lose up to 32 U |c| unseen.
        """
        return float(64 * (self.d.shape[0] + self.d.shape[1]) * U)

    def in_time(self, sigma: Any) -> tuple[Any, Reals]:
        """T[:, j, i], the coefficient of P^i t^j at σ + t, and a bound of its error.

        sigma: real or complex, shape (discs,).
        """
        weights = _binomials(self.d.shape[1])
        powers = _powers(sigma, self.d.shape[1])
        sizes = np.abs(powers)
        T = np.zeros((len(sigma), self.d.shape[1], self.d.shape[0]), sigma.dtype)
        A = np.zeros(T.shape)
        for j in range(self.d.shape[1]):
            w = weights[j, j:]
            T[:, j, :] = powers[:, : len(w)] @ (self.d[:, j:] * w).T
            A[:, j, :] = sizes[:, : len(w)] @ (np.abs(self.d[:, j:]) * w).T
        return T, A * self._loss * UP + TINY

    def at(self, z: Any, T: Any, error: Reals, orders: int | None = None) -> tuple[Any, Reals]:
        """c[:, k, i, j], the coefficient of e^i t^j at P = z + e, and a bound of its error; z: (discs, nodes).

        orders: how many i are wanted, the lowest first; None: all.
        """
        n = self.d.shape[0]
        wanted = n if orders is None else min(orders, n)
        weights, powers = _binomials(n), _powers(z, n)
        sizes = np.abs(powers)
        absolute = np.abs(T) + error / self._loss
        c = np.empty((*z.shape, wanted, T.shape[1]), np.result_type(z, T))
        size = np.empty(c.shape)
        for i in range(wanted):
            w = weights[i, i:]
            c[:, :, i, :] = powers[:, :, : len(w)] @ np.swapaxes(T[:, :, i:] * w, 1, 2)
            size[:, :, i, :] = sizes[:, :, : len(w)] @ np.swapaxes(absolute[:, :, i:] * w, 1, 2)
        return c, size * self._loss * UP + TINY


def _binomials(n: int) -> Reals:
    return np.array([[comb(m, j) for m in range(n)] for j in range(n)], float)


def _powers(z: Any, n: int) -> Any:
    out = np.ones((*z.shape, n), z.dtype)
    for k in range(1, n):
        out[..., k] = out[..., k - 1] * z
    return out
