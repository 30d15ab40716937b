"""Blocks of wavenumber that absorb much at high frequencies, in floats: proposals for the theorem at large q."""

from __future__ import annotations

from typing import Any

import numpy as np

from mpsolve.characteristic.table import Table
from mpsolve.numbers.arrays import Reals
from mpsolve.numbers.float64 import distinct, value_at
from mpsolve.passivity.absorption import Absorption, in_block
from mpsolve.passivity.decay import Edge
from mpsolve.problem.reduced import Guide

_PRICE = 0.03  # of a further block, of all that is absorbed


class Search:
    """W/|D|² · q^e in floats at p = z q^γ on a grid of z, for one γ."""

    def __init__(self, absorption: Absorption, guide: Guide, edge: Edge, width: float) -> None:
        self.gamma, self.v = edge.slope, float(guide.v)
        self.e = absorption.exponent(edge.slope)
        k, self.m = edge.slope.numerator, edge.slope.denominator
        self.W, self.D2 = (Table.of(in_block(a, k, self.m)).d for a in absorption.moving)
        roots = np.roots([float(c) for c in reversed(edge.roots.coeffs())])
        scale = float(np.abs(roots).max()) if len(roots) else 1.0
        real = [float(root.real) for root in roots if abs(root.imag) < 1e-9 * scale]
        steps = 2.0 ** (-np.arange(1, 40) / 2)
        near = np.concatenate([steps, [0.0], -steps])
        z = np.concatenate([np.linspace(-width, width, 61) * scale, *(root * (1 + near) for root in real)])
        self.z = distinct(z.astype(np.float32).astype(float))

    def shortest(self, sieve: float) -> float:
        """The X below which no block is as long as the sieve's loss."""
        if not self.gamma:
            return 1.0 if sieve < self.z[-1] - self.z[0] else np.inf
        return float((sieve / (self.z[-1] - self.z[0])) ** (1 / float(self.gamma)))

    def blocks(self, X: float, sieve: float) -> tuple[tuple[float, float, float], ...]:
        """Intervals between points of the grid, with the least value sampled there, that absorb most for X."""
        growth = X ** float(self.gamma)
        z = self.z[self.z * self.v * growth < 0.97 * X]
        if len(z) < 2:
            return ()
        tau = X ** (-1 / self.m) * np.concatenate([np.geomspace(1, 1e-3, 40), [0.0]])
        with np.errstate(all="ignore"):
            inner = np.concatenate([z, (z[1:] + z[:-1]) / 2])[:, None]
            f = ratio(inner, tau[None, :], self.W, self.D2)
        least = np.where(np.isfinite(f), f, 0.0).min(1)
        return best_blocks(z, least[: len(z)], least[len(z) :], growth, sieve)


def best_blocks(
    z: Reals, ends: Reals, middles: Reals, growth: float, sieve: float
) -> tuple[tuple[float, float, float], ...]:
    """Disjoint intervals with ends in z for which Σ (length·growth − sieve)·least value is largest; few of them."""
    cells = np.minimum(np.minimum(ends[1:], ends[:-1]), middles)
    n = len(z)
    kappa = np.zeros((n, n))
    for i in range(n - 1):
        kappa[i, i + 1 :] = np.minimum.accumulate(cells[i:])
    length = (z[None, :] - z[:, None]) * growth - sieve
    value = np.where((kappa > 0) & (length > 0), length * kappa, 0.0)
    price = 0.0
    for _ in range(2):
        best, before = np.zeros(n), np.full(n, -1)
        for j in range(1, n):
            sums = best[:j] + np.maximum(value[:j, j] - price, 0.0)
            before[j] = int(np.argmax(sums))
            best[j] = sums[before[j]]
        price = _PRICE * float(best[-1])  # of a block, so that few are taken
    blocks, j = [], n - 1
    while j > 0:
        i = int(before[j])
        if value[i, j] > price:
            blocks.append((float(z[i]), float(z[j]), float(kappa[i, j])))
        j = i
    return tuple(reversed(blocks))


def ratio(x: Reals, y: Any, top: Reals, bottom: Reals) -> Any:
    x, y = np.broadcast_arrays(x, y)
    return value_at(x, y, top) / value_at(x, y, bottom)
