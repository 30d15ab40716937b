"""Polynomials in several variables as Taylor models over boxes: many at once, from their exact coefficients.

Over a box y = y₀ + ρ u a monomial Π y_v^e_v has the Taylor coefficients of its factors, and the moduli of all its
coefficients add up to Π (|y₀| + |ρ|)^e (for e < 0 to (|y₀| − |ρ|)^e): what is beyond second order is the difference.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from fractions import Fraction
from functools import cached_property
from typing import Any

import numpy as np

from mpsolve.numbers.arrays import Complexes, Integers, Reals
from mpsolve.numbers.jets import TINY, UP, U, nearest
from mpsolve.numbers.quadratic import Quadratic, pairs

Terms = dict[tuple[int, ...], Fraction]
"""Exponents and coefficients of one polynomial."""


@dataclass(frozen=True)
class Forms:
    """weights[p, t]: the coefficient of monomial t in polynomial p, rounded to nearest; powers[t, v]: exponents."""

    weights: Reals
    powers: Integers

    @staticmethod
    def of(polynomials: Sequence[Terms], variables: int) -> Forms:
        monomials = sorted({e for polynomial in polynomials for e in polynomial}) or [(0,) * variables]
        number = {e: t for t, e in enumerate(monomials)}
        weights = np.zeros((len(polynomials), len(monomials)))
        for p, polynomial in enumerate(polynomials):
            for exponents, c in polynomial.items():
                weights[p, number[exponents]] = nearest(c)
        return Forms(weights, np.array(monomials, int).reshape(len(monomials), variables))

    @cached_property
    def fixed(self) -> bool:
        """Whether nothing varies."""
        return not self.powers.any()

    @cached_property
    def _loss(self) -> float:
        """Of roundings, relative to the sum of moduli."""
        return float(64 * (int(np.abs(self.powers).sum(1).max(initial=0)) + len(self.powers) + 8) * U)

    def _constant(self, m: int, boxes: int) -> Quadratic:
        k = np.zeros((1 + m + len(pairs(m)), boxes, len(self.weights)), complex)
        k[0] = self.weights.sum(1)
        e = np.abs(self.weights).sum(1) * self._loss * UP + TINY
        return Quadratic(k, np.broadcast_to(e, k.shape[1:]).copy(), m)

    @np.errstate(all="ignore")
    def __call__(self, y: Any, rho: Any) -> Quadratic:
        """Shape (boxes, polynomials). y, rho: complex, shape (variables, boxes); y may err by 4 u |y| unseen.

        rho of shape (variables, variables, boxes): variable v is y_v + Σ ρ_vw u_w.
        """
        m = len(y)
        if self.fixed:
            return self._constant(m, y.shape[1])
        if rho.ndim == 3:  # |Σ ρ_vw u_w| ≤ R_v: over the larger box, and there U_v = Σ (ρ_vw/R_v) u_w
            R = np.abs(rho).sum(1) * UP
            return self(y, R + 0j).turned(rho / np.where(R > 0, R, 1)[:, None])
        zeroth, first, second, whole = (np.ones((m, len(self.powers), y.shape[1]), complex) for _ in range(4))
        for v in np.flatnonzero(self.powers.any(0)):
            e = self.powers[:, v]
            powers, size, radius = _Powers.of(y[v], e), np.abs(y[v]), np.abs(rho[v])
            zeroth[v] = powers(e)
            first[v] = e[:, None] * powers(_lower(e, 1)) * rho[v]
            second[v] = (e * (e - 1) / 2)[:, None] * powers(_lower(e, 2)) * rho[v] ** 2
            whole[v] = _Powers.of(size + radius, np.maximum(e, 0))(np.maximum(e, 0))
            if (e < 0).any():
                least = size - radius
                beneath = _Powers.of(np.where(least > 0, least, 0), e)(e)
                whole[v] = np.where(e[:, None] >= 0, whole[v], beneath)
        for v in np.flatnonzero(~self.powers.any(0)):
            first[v] = second[v] = 0
        k = [zeroth.prod(0)]
        k += [_replaced(zeroth, {v: first[v]}) for v in range(m)]
        k += [_replaced(zeroth, {i: first[i], j: first[j]} if i != j else {i: second[i]}) for i, j in pairs(m)]
        models = np.stack(k)
        bound = whole.real.prod(0)
        rest = np.maximum(bound - np.abs(models).sum(0), 0) + self._loss * bound
        values = np.einsum("pt,ktb->kbp", self.weights, models, optimize=True)
        e = np.einsum("pt,tb->bp", np.abs(self.weights), rest) * UP + TINY
        return Quadratic(values, np.where(np.isfinite(e), e, np.inf), m)


def _lower(e: Integers, n: int) -> Integers:
    """e − n, but 0 where a derivative of order n has the factor 0."""
    return np.where((e >= 0) & (e < n), 0, e - n)


@dataclass(frozen=True)
class _Powers:
    """table[n]: y^(n − down), by products; ∞ for powers of 0 that are not."""

    table: Any
    down: int

    @staticmethod
    def of(y: Any, e: Integers) -> _Powers:
        """With all that derivatives up to the second need."""
        up, down = max(int(e.max(initial=0)), 0), max(-int(e.min(initial=0)), 0)
        down = down + 2 if down else 0
        rows = [np.ones_like(y)]
        for _ in range(up):
            rows.append(rows[-1] * y)
        if down:
            step = np.where(y == 0, np.inf, 1 / np.where(y == 0, 1, y))
            for _ in range(down):
                rows.insert(0, rows[0] * step)
        return _Powers(np.stack(rows), down)

    def __call__(self, e: Any) -> Any:
        return self.table[e + self.down]


def _replaced(factors: Complexes, new: dict[int, Complexes]) -> Complexes:
    out = np.ones(factors.shape[1:], complex)
    for v in range(len(factors)):
        out = out * new.get(v, factors[v])
    return out
