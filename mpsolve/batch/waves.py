"""The p-roots of very many dispersion polynomials at once, those that decay ahead of a force first."""

from __future__ import annotations

from typing import Any

import numpy as np

from mpsolve.numbers.arrays import Complexes, Reals, Truths
from mpsolve.numbers.float64 import companions, polynomial_and_slope

_STEPS = 10
_SETTLED = 1e-6
_LEAST = 1e-15
_TIE = 1e-9
_AHEAD = 1e-7
_SIDES = 0.4
_THIRDS = np.exp(2j * np.pi * np.arange(3) / 3)


def by_companions(D: Any) -> Complexes:
    """The roots of Σ D[:, i] z^i by eigenvalues, shape (len(D), degree); nan where D is not finite."""
    C = companions(D)
    fine: Any = np.isfinite(C).all((1, 2))
    out = np.linalg.eigvals(np.where(fine[:, None, None], C, np.eye(C.shape[1])))
    return np.where(fine[:, None], out, np.nan)


def first_roots(D: Any) -> Any:
    """Roots to begin `from_near` with: of degree 4 by Ferrari's formula, which may lose digits."""
    if D.shape[1] != 5:
        return by_companions(D)
    d, c, b, a = (D[:, i] / D[:, 4] for i in range(4))
    p, q = b - 3 * a * a / 8, c - a * b / 2 + a**3 / 8
    r = d - a * c / 4 + a * a * b / 16 - 3 * a**4 / 256
    # m³ + p m² + (p²/4 − r) m − q²/8 = 0, by Cardano's formula
    e, f = -p * p / 12 - r, -(p**3) / 108 + p * r / 3 - q * q / 8
    root = np.sqrt(f * f / 4 + e**3 / 27)
    cube = np.where(np.abs(root - f / 2) > np.abs(root + f / 2), root - f / 2, -root - f / 2) ** (1 / 3)
    turned = cube[:, None] * _THIRDS
    m = turned - e[:, None] / (3 * turned) - p[:, None] / 3
    m = np.take_along_axis(m, np.abs(m).argmax(1)[:, None], 1)[:, 0]
    s = np.sqrt(2 * m)
    one, other = np.sqrt(-2 * p - 2 * m - 2 * q / s), np.sqrt(-2 * p - 2 * m + 2 * q / s)
    return np.stack([s + one, s - one, -s + other, -s - other], 1) / 2 - a[:, None] / 4


def from_near(D: Any, z: Any) -> Any:
    """The roots by Aberth's method from those of a neighbour; by eigenvalues where it does not settle."""
    open_ = np.arange(len(z))
    out = z.copy()
    for _ in range(_STEPS):
        some, at = D[open_], out[open_]
        value, slope = polynomial_and_slope(some, at)
        newton = value / slope
        step = newton / (1 - newton * _repulsion(at))
        at = at - step
        out[open_] = at
        size = np.abs(at)
        floor = _LEAST * size.max(1, keepdims=True)
        moving = ~(np.abs(step) <= _SETTLED * size + floor).all(1)  # cubic: the step after this one is rounding
        open_ = open_[moving]
        if not len(open_):
            return out
    out[open_] = by_companions(D[open_])
    return out


def _repulsion(z: Any) -> Any:
    """Σ 1/(z_k − z_j) over the other roots of each row."""
    out = np.zeros_like(z)
    n = z.shape[1]
    for k in range(n):
        for j in range(k):
            over = 1 / (z[:, k] - z[:, j])
            out[:, k] += over
            out[:, j] -= over
    return out


def upper_first(z: Any, up: int, drift: Any) -> Complexes:
    """Each row with its `up` roots of smallest real part first; drift(rows, z) = dP/dσ settles ties on the axis."""
    key = z.real.copy()
    n = z.shape[1]
    if 0 < up < n:
        ranks = np.sort(key, 1)
        tie = np.flatnonzero(ranks[:, up] - ranks[:, up - 1] < _TIE * np.abs(z).max(1))
        if len(tie):
            key[tie] += _AHEAD * drift(tie, z[tie]).real
    return np.take_along_axis(z, np.argsort(key, 1), 1)


def passes_branch(z: Any, up: int) -> Truths:
    """Whether G may have a branch point between a point and the next: an upper and a lower p-root come together.

    That is so where a root moves by more than a part of its distance to the other side.
    """
    before, after = z[:-1], z[1:]
    out = np.zeros(len(after), bool)
    for one, other in ((before, after), (after, before)):
        for k in range(z.shape[1]):
            rest = range(up, z.shape[1]) if k < up else range(up)
            room = np.full(len(after), np.inf)
            for j in rest:
                room = np.minimum(room, np.abs(one[:, k] - one[:, j]))
            out |= ~(_nearest(one[:, k], other) < _SIDES * room)
    return out


def moved_between(z: Any, weight: Reals) -> Reals:
    """The largest move of a p-root from each point to the next; weight: of each root at the later points."""
    before, after = z[:-1], z[1:]
    out = np.zeros(len(after))
    for k in range(z.shape[1]):
        out = np.maximum(out, _nearest(after[:, k], before) * weight[:, k])
    return out


def felt(z: Any, shortest: Reals, longest: Reals) -> Any:
    """The largest ξ |e^{zξ}| over the distances between these: how much a move of a root turns what it adds to G."""
    decay = np.abs(z.real)
    with np.errstate(all="ignore"):
        xi = np.clip(1 / decay, np.minimum(shortest, longest)[:, None], longest[:, None])
        return xi * np.exp(-decay * xi)


def _nearest(one: Any, other: Complexes) -> Any:
    out = np.abs(one - other[:, 0])
    for j in range(1, other.shape[1]):
        out = np.minimum(out, np.abs(one - other[:, j]))
    return out
