"""Integrals of polynomials times exponentials over a step [0, 1], and the shifted Legendre polynomials."""

from __future__ import annotations

from functools import cache
from math import factorial
from typing import Any

import numpy as np
from numpy.polynomial import Polynomial, legendre

_SMALL = 3.0
_POINTS = 14


@cache
def gauss(points: int) -> tuple[Any, Any]:
    """Nodes and weights of Gauss on [0, 1], each (points,)."""
    x, weight = legendre.leggauss(points)
    return (x + 1) / 2, weight / 2


def legendre_powers(degree: int) -> Any:
    """Row l: the coefficients of P_l(2θ − 1) in 1, θ, θ², …; (degree + 1, degree + 1)."""
    rows = np.zeros((degree + 1, degree + 1))
    for row, unit in zip(rows, np.eye(degree + 1), strict=True):
        power = Polynomial(legendre.leg2poly(unit))(Polynomial([-1, 2])).coef
        row[: len(power)] = power
    return rows


def moments(z: Any, degree: int) -> Any:
    """∫₀¹ θ^d e^{zθ} dθ for d = 0 … degree, (degree + 1, *z.shape); good to 1e-14 where Re z ≲ 1, degree ≤ 8.

    By parts from d − 1 to d where |z| > 3, by Gauss elsewhere.
    """
    out = np.empty((degree + 1, *z.shape), complex)
    large = np.abs(z) > _SMALL
    far, near = z[large], z[~large]
    end = np.exp(far)
    value = (end - 1) / far
    out[0][large] = value
    for d in range(1, degree + 1):
        value = (end - d * value) / far
        out[d][large] = value
    theta, weight = gauss(_POINTS)
    wave = np.exp(np.multiply.outer(theta, near))
    for d in range(degree + 1):
        out[d][~large] = np.tensordot(weight * theta**d, wave, 1)
    return out


def nested_moments(p: Any, q: Any, outer: int, inner: int) -> Any:
    """∫₀¹ θ^a e^{pθ} ∫₀^θ σ^l e^{qσ} dσ dθ for a ≤ outer, l ≤ inner; (outer + 1, inner + 1, *p.shape).

    The inner integral is taken in closed form where |q| > 3, by Gauss over σ/θ elsewhere.
    """
    out = np.zeros((outer + 1, inner + 1, *p.shape), complex)
    large = np.abs(q) > _SMALL
    far = q[large]
    both, first = moments(p[large] + far, outer + inner), moments(p[large], outer)
    for a in range(outer + 1):
        for power in range(inner + 1):
            value = -((-1) ** power) * factorial(power) / far ** (power + 1) * first[a]
            for i in range(power + 1):
                falling = factorial(power) // factorial(power - i)
                value += (-1) ** i * falling / far ** (i + 1) * both[a + power - i]
            out[a, power][large] = value
    for node, weight in zip(*gauss(_POINTS), strict=True):
        inside = moments(p[~large] + q[~large] * node, outer + inner + 1)
        for a in range(outer + 1):
            for power in range(inner + 1):
                out[a, power][~large] += weight * node**power * inside[a + power + 1]
    return out
