"""Polynomials in several variables as Taylor models over boxes: many at once, from their exact coefficients.

Over a box y = y₀ + ρ u a monomial Π y_v^e_v has the Taylor coefficients of its factors, and the moduli of all its
coefficients add up to Π (|y₀| + |ρ|)^e (for e < 0 to (|y₀| − |ρ|)^e): what is beyond second order is the difference.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from fractions import Fraction
from typing import Any

import numpy as np

from mpsolve.numbers.jets import TINY, UP, U, nearest
from mpsolve.numbers.quadratic import Quadratic, pairs

Terms = dict[tuple[int, ...], Fraction]
"""Exponents and coefficients of one polynomial."""


@dataclass(frozen=True)
class Forms:
    """weights[p, t]: the coefficient of monomial t in polynomial p, rounded to nearest; powers[t, v]: exponents."""

    weights: Any
    powers: Any

    @staticmethod
    def of(polynomials: Sequence[Terms], variables: int) -> Forms:
        monomials = sorted({e for polynomial in polynomials for e in polynomial}) or [(0,) * variables]
        number = {e: t for t, e in enumerate(monomials)}
        weights = np.zeros((len(polynomials), len(monomials)))
        for p, polynomial in enumerate(polynomials):
            for exponents, c in polynomial.items():
                weights[p, number[exponents]] = nearest(c)
        return Forms(weights, np.array(monomials, int).reshape(len(monomials), variables))

    @property
    def fixed(self) -> bool:
        """Whether nothing varies."""
        return not self.powers.any()

    @np.errstate(all="ignore")
    def __call__(self, y: Any, rho: Any) -> Quadratic:
        """Shape (boxes, polynomials). y, rho: complex, shape (variables, boxes); y may err by 4 u |y| unseen."""
        m = len(y)
        zeroth, first, second, whole = (np.ones((m, len(self.powers), y.shape[1]), complex) for _ in range(4))
        for v in range(m):
            e = self.powers[:, v, None]
            zeroth[v] = _power(y[v], e)
            first[v] = e * _power(y[v], _lower(e, 1)) * rho[v]
            second[v] = e * (e - 1) / 2 * _power(y[v], _lower(e, 2)) * rho[v] ** 2
            size, radius = np.abs(y[v]), np.abs(rho[v])
            least = size - radius
            whole[v] = np.where(e >= 0, (size + radius) ** np.maximum(e, 0), _power(np.where(least > 0, least, 0), e))
        k = [zeroth.prod(0)]
        k += [_replaced(zeroth, {v: first[v]}) for v in range(m)]
        k += [_replaced(zeroth, {i: first[i], j: first[j]} if i != j else {i: second[i]}) for i, j in pairs(m)]
        models = np.stack(k)
        bound = whole.real.prod(0)
        loss = 64 * (int(np.abs(self.powers).sum(1).max(initial=0)) + len(self.powers) + 8) * U
        rest = np.maximum(bound - np.abs(models).sum(0), 0) + loss * bound
        values = np.einsum("pt,ktb->kbp", self.weights, models, optimize=True)
        e = np.einsum("pt,tb->bp", np.abs(self.weights), rest) * UP + TINY
        return Quadratic(values, np.where(np.isfinite(e), e, np.inf), m)


def _lower(e: Any, n: int) -> Any:
    """e − n, but 0 where a derivative of order n has the factor 0."""
    return np.where((e >= 0) & (e < n), 0, e - n)


def _power(y: Any, e: Any) -> Any:
    """y^e by products."""
    out = np.ones(np.broadcast_shapes(np.shape(y), np.shape(e)), np.result_type(y, float))
    step = np.where(e < 0, 1 / np.where(y == 0, 1, y), y)
    step = np.where((e < 0) & (y == 0), np.inf, step)
    for n in range(int(np.abs(e).max(initial=0))):
        out = np.where(np.abs(e) > n, out * step, out)
    return out


def _replaced(factors: Any, new: dict[int, Any]) -> Any:
    out = np.ones(factors.shape[1:], complex)
    for v in range(len(factors)):
        out = out * new.get(v, factors[v])
    return out
