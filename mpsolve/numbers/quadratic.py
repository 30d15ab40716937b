"""Second-order Taylor models in float64 arrays: rigorous, vectorised over boxes of several variables.

A `Quadratic` stands for analytic functions of u = (u₁ … u_m) on |u_i| ≤ 1, complex u too, one for each index:
|f(u) − a − Σ b_i u_i − Σ_{i≤j} c_ij u_i u_j| ≤ e. The scale of a variable is in its coefficients. Rounding is treated
as in `numbers.jets`: what the operations +, −, ×, ÷ lose is added to e with a wide margin, and what cannot be bounded
has e = ∞ or nan, with which no comparison proves anything.
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from functools import lru_cache
from typing import Any

import numpy as np

from mpsolve.numbers.arrays import Complexes, Reals
from mpsolve.numbers.jets import TINY, UP, U, exponential

_WIDEST = 40.0


@lru_cache(maxsize=32)
def pairs(m: int) -> tuple[tuple[int, int], ...]:
    """The pairs i ≤ j of m variables, in the order in which their coefficients stand."""
    return tuple((i, j) for i in range(m) for j in range(i, m))


def by_variable(k: Any, m: int) -> Any:
    """For each variable the sum of those coefficients, along the first axis, whose terms hold it: squares twice."""
    out = k[1 : 1 + m].copy()
    for n, (i, j) in enumerate(pairs(m), 1 + m):
        out[i] += k[n]
        out[j] += k[n]
    return out


@dataclass(frozen=True)
class Quadratic:
    """k: complex, the coefficients 1, u_i, u_i u_j along the first axis, then boxes, then any shape; e ≥ 0."""

    k: Any
    e: Reals
    m: int

    __array_ufunc__ = None

    @property
    def a(self) -> Any:
        return self.k[0]

    @property
    def b(self) -> Any:
        """The coefficients of u_i."""
        return self.k[1 : 1 + self.m]

    @property
    def c(self) -> Any:
        """The coefficients of u_i u_j, i ≤ j."""
        return self.k[1 + self.m :]

    @property
    def first(self) -> Any:
        """A bound of |Σ b_i u_i|, to within roundings."""
        return np.abs(self.b).sum(0)

    @property
    def second(self) -> Any:
        """A bound of |Σ c_ij u_i u_j|, to within roundings."""
        return np.abs(self.c).sum(0)

    @property
    def size(self) -> Any:
        """An upper bound of |f|."""
        return (np.abs(self.k).sum(0) + self.e) * UP

    @property
    def spread(self) -> Any:
        """An upper bound of |f − a|."""
        return (self.first + self.second + self.e) * UP

    def __getitem__(self, key: Any) -> Quadratic:
        """Along the axes of boxes and behind."""
        rest = key if isinstance(key, tuple) else (key,)
        return Quadratic(self.k[(slice(None), *rest)], self.e[key], self.m)

    def taken(self, numbers: Any) -> Quadratic:
        """Along the last axis."""
        return Quadratic(np.take(self.k, numbers, -1), np.take(self.e, numbers, -1), self.m)

    def __neg__(self) -> Quadratic:
        return Quadratic(-self.k, self.e, self.m)

    @np.errstate(all="ignore")
    def __add__(self, other: Quadratic) -> Quadratic:
        k = self.k + other.k
        return Quadratic(k, (self.e + other.e + 2 * U * np.abs(k).sum(0)) * UP + TINY, self.m)

    @np.errstate(all="ignore")
    def times(self, factor: Any) -> Quadratic:
        """Times an array of numbers that are meant exactly up to 2 u, broadcast behind the first axis."""
        k = self.k * factor
        return Quadratic(k, (self.e * np.abs(factor) + 8 * U * np.abs(k).sum(0)) * UP + TINY, self.m)

    @np.errstate(all="ignore")
    def __mul__(self, other: Quadratic) -> Quadratic:
        return self._product(other, np.multiply, 8 * U)

    @np.errstate(all="ignore")
    def __matmul__(self, other: Quadratic) -> Quadratic:
        """Products of matrices in the last two axes."""
        return self._product(other, np.matmul, 16 * (self.k.shape[-1] + 4) * U)

    def _product(self, other: Quadratic, times: Any, lost: float) -> Quadratic:
        m = self.m
        a, b = self.k, other.k
        k = [times(a[0], b[0])]
        k += [times(a[0], b[i]) + times(a[i], b[0]) for i in range(1, m + 1)]
        for n, (i, j) in enumerate(pairs(m), m + 1):
            term = times(a[0], b[n]) + times(a[n], b[0]) + times(a[i + 1], b[j + 1])
            k.append(term + times(a[j + 1], b[i + 1]) if i != j else term)
        a0, a1, a2 = np.abs(a[0]), self.first, self.second
        b0, b1, b2 = np.abs(b[0]), other.first, other.second
        left, right = a0 + a1 + a2, b0 + b1 + b2
        e = times(a1, b2) + times(a2, b1 + b2) + times(left, other.e) + times(self.e, right + other.e)
        e = e + lost * (m + 2) * times(left, right)
        return Quadratic(np.stack(k), e * UP + TINY, m)

    @np.errstate(all="ignore")
    def inverse(self) -> Quadratic:
        """1/f; not bounded where f may vanish. 1/(1 + w) = 1 − w + w² − w³/(1 + w)."""
        c = 1 / self.k[0]
        w = self.k[1:] * c
        size = np.abs(c) * (1 + 16 * U)
        p, q, eps = np.abs(w[: self.m]).sum(0), np.abs(w[self.m :]).sum(0), self.e * size * UP
        y = (p + q + eps) * UP
        k = [c, *(-w[: self.m] * c)]
        for n, (i, j) in enumerate(pairs(self.m), self.m):
            k.append((w[i] * w[j] * (1 if i == j else 2) - w[n]) * c)
        lost = 64 * U * (self.m + 1) * (1 + y) * (1 + y)
        e = size * (eps + (q + eps) * (2 * p + q + eps) + y * y * y / (1 - y) + lost)
        return Quadratic(np.stack(k), np.where(y < 0.95, e * UP + TINY, np.inf), self.m)

    @np.errstate(all="ignore")
    def exp(self) -> Quadratic:
        """e^f; not bounded where f varies by more than _WIDEST."""
        value, relative = exponential(self.k[0])
        w = self.k[1:]
        p, q = self.first, self.second
        y = (p + q + self.e) * UP
        k = [value, *(w[: self.m] * value)]
        for n, (i, j) in enumerate(pairs(self.m), self.m):
            k.append((w[n] + w[i] * w[j] * (0.5 if i == j else 1.0)) * value)
        power, more = exponential(np.where(y <= _WIDEST, y, 0.0))
        beyond = np.minimum(y**3 / 6 * power.real * (1 + more), power.real * (1 + more) + 1 + y + y * y)
        rest = self.e + (q + self.e) * (2 * p + q + self.e) / 2 + beyond
        lost = (relative + 64 * U * (self.m + 1)) * (1 + y + y * y)
        e = np.abs(value) * (1 + 16 * U + relative) * (rest + lost) * UP + TINY
        return Quadratic(np.stack(k), np.where(y <= _WIDEST, e, np.inf), self.m)

    @np.errstate(all="ignore")
    def turned(self, M: Complexes) -> Quadratic:
        """With u_v = Σ M_vw u′_w, of shape (m, m, boxes), Σ_w |M_vw| ≤ 1: f has one axis behind that of boxes."""
        M, which = M[..., None], pairs(self.m)
        b = np.stack([self.b[v] * M[v] for v in range(self.m)])
        c: list[Any] = [0.0] * len(which)
        for n, (i, j) in enumerate(which):
            for k, (v, w) in enumerate(which):
                c[k] = c[k] + self.c[n] * (M[i, v] * M[j, w] + (M[i, w] * M[j, v] if v != w else 0))
        size = np.abs(b).sum((0, 1)) + self.second
        return Quadratic(np.stack([self.a, *b.sum(0), *c]), (self.e + 64 * self.m**2 * U * size) * UP + TINY, self.m)

    @np.errstate(all="ignore")
    def sum(self, axis: int) -> Quadratic:
        """Along an axis behind the boxes, counted from the end (−1 is the last)."""
        terms = self.k.shape[axis]
        k = self.k.sum(axis)
        lost = 4 * terms * U * np.abs(self.k).sum(0).sum(axis)
        return Quadratic(k, (self.e.sum(axis) + lost) * UP + TINY, self.m)


def joined(parts: Iterable[Quadratic], axis: int = -1) -> Quadratic:
    """Side by side along an axis counted from the end."""
    every = list(parts)
    k = np.concatenate([part.k for part in every], axis)
    return Quadratic(k, np.concatenate([part.e for part in every], axis), every[0].m)


def constant(values: Any, boxes: int, m: int) -> Quadratic:
    """Numbers, each within 2 u of what it stands for, the same on every box."""
    k = np.zeros((1 + m + len(pairs(m)), boxes, *np.shape(values)), complex)
    k[0] = values
    return Quadratic(k, 2 * U * np.abs(k[0]), m)


def lifted(f: Quadratic, m: int) -> Quadratic:
    """The same functions among m variables, of which the further ones do not matter."""
    if m == f.m:
        return f
    where = [0, *range(1, f.m + 1), *(1 + m + pairs(m).index(pair) for pair in pairs(f.m))]
    k = np.zeros((1 + m + len(pairs(m)), *f.e.shape), complex)
    k[where] = f.k
    return Quadratic(k, f.e, m)
