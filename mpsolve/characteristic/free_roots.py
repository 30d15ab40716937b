"""The p-roots of a family over boxes of (q, parameters), one by one, as Taylor models.

A root is first followed to second order in u, P = z + δ(u): δ is a quadratic in floats, any would be allowed. With
the Taylor coefficients c_j of D at z + δ(u) there is exactly one root in |P − z − δ(u)| < ε, for each complex u with
|u_i| ≤ 1, where |c₀| + Σ_{j ≥ 2} |c_j| ε^j < |c₁| ε (Rouché). c₀ is of third order, so that only curvature widens ε.

Such roots are analytic in u, and no two of them ever meet, as each is alone in its disc. Those with Re P < 0 at the
middle of a box belong to U at every real point of the box: no p-root of a damped track is imaginary for real q.
"""

from __future__ import annotations

from dataclasses import dataclass
from math import comb
from typing import Any

import numpy as np

from mpsolve.numbers.arrays import Reals, Truths
from mpsolve.numbers.float64 import gaps
from mpsolve.numbers.jets import TINY, UP, U
from mpsolve.numbers.quadratic import Quadratic, pairs

_ROUNDS = 6


@dataclass(frozen=True)
class Roots:
    """Shape (boxes, roots): P and N/D_P along each root, where `good`; strain[v]: how far variable v moves roots,
    relative to the distance of the next one.
    """

    P: Quadratic
    weight: Quadratic
    good: Any
    strain: Reals


def roots_over(D: Quadratic, N: Quadratic, z: Any, low: Reals, up: int | None) -> Roots:
    """The roots of D near the floats z, the first `up` of them with Re P < 0; low: |lead| is at least this.

    up: None where nothing is said of sides.
    """
    d = shifted(D, z)
    first = d[..., 1].a
    delta = _followed(d)
    value, slope = _with_slope(d, delta)
    high = _high_orders(d, delta.size)
    least = (np.abs(slope.a) - slope.spread) * (1 - 16 * U)
    eps, alone = _isolated(value.size, least, high)
    order = np.arange(2, 2 + high.shape[-1])
    more = (order * high * eps[..., None] ** (order - 1)).sum(-1) * UP
    slope = Quadratic(slope.k, slope.e + more, slope.m)
    moved = Quadratic(delta.k, eps, delta.m)
    weight = _horner(shifted(N, z), moved) * slope.inverse()
    k = delta.k.copy()
    k[0] += z
    P = Quadratic(k, eps * UP + 4 * U * np.abs(k[0]) + TINY, delta.m)
    off, gap = np.abs(delta.k[0]) + eps, gaps(z)
    different = (gap > (off[:, :, None] + off[:, None, :]) * UP).all(2)
    good = alone & different & (low > TINY)[:, None]
    if up is not None:
        good = good & _sided(z, off, up)
    strain = (np.abs(d[..., 0].b) / (np.abs(first) * gap.min(2))[None]).max(2)
    return Roots(P, weight, good, strain)


def shifted(polynomial: Quadratic, z: Any) -> Quadratic:
    """The coefficients of (P − z)^j, shape (boxes, points, degree + 1)."""
    n = polynomial.k.shape[-1]
    power = z[..., None] ** np.arange(n)
    M = np.zeros((*z.shape, n, n), complex)  # [box, point, j, i]
    for j in range(n):
        for i in range(j, n):
            M[:, :, j, i] = comb(i, j) * power[..., i - j]
    boxes, points = z.shape
    flat = np.swapaxes(M.reshape(boxes, points * n, n), 1, 2)
    size = np.abs(flat)
    k = (polynomial.k[:, :, None, :] @ flat)[:, :, 0]
    whole = (np.abs(polynomial.k).sum(0)[:, None, :] @ size)[:, 0]
    e = (polynomial.e[:, None, :] @ size)[:, 0] + 64 * (n + 2) * U * whole
    shape = (boxes, points, n)
    return Quadratic(k.reshape(len(k), *shape), (e * UP + TINY).reshape(shape), polynomial.m)


def _followed(d: Quadratic) -> Quadratic:
    """δ(u) with D(z + δ) = 0 up to third order, in floats."""
    zero, one, two = d[..., 0], d[..., 1], d[..., 2] if d.k.shape[-1] > 2 else None
    over = -1 / one.a
    b = zero.b * over
    k = [zero.a * over, *b]
    for n, (i, j) in enumerate(pairs(d.m)):
        term = zero.c[n] + one.b[i] * b[j]
        if i != j:
            term = term + one.b[j] * b[i]
        if two is not None:
            term = term + two.a * b[i] * b[j] * (1 if i == j else 2)
        k.append(term * over)
    delta = np.stack(k)
    return Quadratic(delta, np.zeros(delta.shape[1:]), d.m)


def _horner(d: Quadratic, x: Quadratic) -> Quadratic:
    """Σ d_j x^j over the last axis."""
    total = d[..., -1]
    for j in range(d.k.shape[-1] - 2, -1, -1):
        total = total * x + d[..., j]
    return total


def _with_slope(d: Quadratic, x: Quadratic) -> tuple[Quadratic, Quadratic]:
    """(Σ d_j x^j, its derivative)."""
    n = d.k.shape[-1]
    slope = d[..., n - 1]
    value = slope * x + d[..., n - 2]
    for j in range(n - 3, -1, -1):
        slope = slope * x + value
        value = value * x + d[..., j]
    return value, slope


def _high_orders(d: Quadratic, reach: Any) -> Reals:
    """Bounds of |c_j|, j ≥ 2, where |δ| ≤ reach."""
    size, n = d.size, d.k.shape[-1]
    out = np.zeros((*reach.shape, max(n - 2, 0)))
    for j in range(2, n):
        for i in range(j, n):
            out[..., j - 2] += comb(i, j) * size[..., i] * reach ** (i - j)
    return out * UP


def _isolated(value: Any, slope: Reals, high: Reals) -> tuple[Reals, Truths]:
    """(ε, where exactly one root is proved in the disc of that radius)."""
    order = np.arange(2, 2 + high.shape[-1])
    base = value / slope * UP + TINY
    eps, done = 1.5 * base, np.zeros(base.shape, bool)
    for _ in range(_ROUNDS):
        image = base + (high * eps[..., None] ** order).sum(-1) / slope * UP * UP
        inside = image < 0.999 * eps
        done |= inside
        eps = np.where(inside, image, np.where(done, eps, 1.6 * image))
        if inside.all():
            break
    return eps, done & (slope > 0)


def _sided(z: Any, off: Reals, up: int) -> Any:
    """Where the root at the middle, within `off` of z, has Re P < 0 if it is one of the first `up`, else Re P > 0."""
    sign = np.where(np.arange(z.shape[1]) < up, -1.0, 1.0)
    return sign * z.real > off * UP
