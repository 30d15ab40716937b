"""The p-roots of very many dispersion polynomials at once, in float64; those that decay ahead of a force first."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np

from mpsolve.numbers.arrays import Complexes, Integers
from mpsolve.numbers.float64 import companions, polynomial_and_slope

_EVERY = 5
_STEPS = 10
_SETTLED = 1e-6
_LEAST = 1e-15
_TIE = 1e-9
_AHEAD = 1e-7
_THIRDS = np.exp(2j * np.pi * np.arange(3) / 3)


def eigenvalues(D: Any) -> Complexes:
    """The roots of Σ D[:, i] z^i by eigenvalues, shape (len(D), degree); nan where D is not finite."""
    C = companions(D)
    fine: Any = np.isfinite(C).all((1, 2))
    out = np.linalg.eigvals(np.where(fine[:, None, None], C, np.eye(C.shape[1])))
    return np.where(fine[:, None], out, np.nan)


def first_roots(D: Any) -> Any:
    """Roots to begin `from_near` with: of degree 4 by Ferrari's formula, which may lose digits."""
    if D.shape[1] != 5:
        return eigenvalues(D)
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
    out[open_] = eigenvalues(D[open_])
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


def followed(D: Any) -> Complexes:
    """The roots of each row of D, of which few solved as eigenvalues are near those of the rows beside them."""
    rows = len(D)
    if rows <= 2 * _EVERY or D.shape[1] < 4:
        return eigenvalues(D)
    anchors = np.arange(_EVERY // 2, rows, _EVERY)
    near = eigenvalues(D[anchors])[np.minimum(np.arange(rows) // _EVERY, len(anchors) - 1)]
    with np.errstate(all="ignore"):
        out: Complexes = from_near(D, near)
        return out


def upper_first(z: Any, up: int, drift: Callable[[Any, Any], Any]) -> Complexes:
    """Each row with its `up` roots of smallest real part first; drift(rows, z) = dP/dσ settles ties on the axis.

    There roots are waves: those count as upper that decay for Re σ > 0.
    """
    key = z.real.copy()
    if 0 < up < z.shape[1]:
        ranks = np.sort(key, 1)
        tie = np.flatnonzero(ranks[:, up] - ranks[:, up - 1] < _TIE * np.abs(z).max(1))
        if len(tie):
            with np.errstate(all="ignore"):
                key[tie] += _AHEAD * np.nan_to_num(drift(tie, z[tie])).real
    return np.take_along_axis(z, np.argsort(key, 1), 1)


def cancelled(z: Any, w: Complexes, up: int, slope: bool, share: float) -> Integers:
    """The rows where residues w of close roots of one side cancel so far that a sum of them, or its slope, loses this
    share.

    With s = |z|/gap a residue is off by 2⁻⁵³ s² of itself, its slope by s³, and what is left of a pair is w/s.
    """
    pairs = [(i, j) for i in range(z.shape[1]) for j in range(i) if (i < up) == (j < up)]
    power, size, near = 3 if slope else 2, np.abs(z), np.zeros(len(z), bool)
    least = (share * 2.0**53) ** (1 / (power + 1))  # any other s loses less
    for i, j in pairs:
        near |= np.abs(z[:, i] - z[:, j]) * least < np.maximum(size[:, i], size[:, j])
    rows = np.flatnonzero(near & np.isfinite(size).all(1))
    gap = np.full((len(rows), z.shape[1]), np.inf)
    for i, j in pairs:
        apart = np.abs(z[rows, i] - z[rows, j])
        gap[:, i], gap[:, j] = np.minimum(gap[:, i], apart), np.minimum(gap[:, j], apart)
    close, weight = np.maximum(size[rows] / gap, 1.0), np.abs(w[rows])
    lost = 2.0**-53 * (weight * close**power).max(1, initial=0.0)
    kept = lost < share * (weight / close).max(1, initial=0.0)
    out: Integers = rows[~kept]
    return out
