"""The p-roots of very many dispersion polynomials at once, those that decay ahead of a force first."""

from __future__ import annotations

from typing import Any

import numpy as np

_STEPS = 10
_SETTLED = 1e-13
_TIE = 1e-9
_AHEAD = 1e-7


def by_companions(D: Any) -> Any:
    """The roots of Σ D[:, i] z^i by eigenvalues, shape (len(D), degree); nan where D is not finite."""
    n = D.shape[1] - 1
    C = np.zeros((len(D), n, n), complex)
    C[:, range(n - 1), range(1, n)] = 1
    C[:, -1] = -D[:, :-1] / D[:, -1:]
    fine = np.isfinite(C).all((1, 2))
    out = np.linalg.eigvals(np.where(fine[:, None, None], C, np.eye(n)))
    return np.where(fine[:, None], out, np.nan)


def polynomial_and_slope(D: Any, z: Any) -> tuple[Any, Any]:
    """Values and slopes in z at several z for each polynomial; D ascending, shape (…, n + 1)."""
    value = np.broadcast_to(D[:, -1:], z.shape)
    slope = np.zeros_like(z)
    for i in range(D.shape[1] - 2, -1, -1):
        slope = slope * z + value
        value = value * z + D[:, i : i + 1]
    return value, slope


def from_near(D: Any, z: Any) -> Any:
    """The roots by Aberth's method from those of a neighbour; by eigenvalues where it does not settle."""
    n = z.shape[1]
    open_ = np.arange(len(z))
    out = z.copy()
    for _ in range(_STEPS):
        some, at = D[open_], out[open_]
        value, slope = polynomial_and_slope(some, at)
        newton = value / slope
        others = np.zeros_like(at)
        for k in range(1, n):
            others += 1 / (at - np.roll(at, k, 1))
        step = newton / (1 - newton * others)
        at = at - step
        out[open_] = at
        size = np.abs(at).max(1)
        moving = ~(np.abs(step).max(1) < _SETTLED**0.5 * size)  # cubic: the step after this one is rounding
        open_ = open_[moving]
        if not len(open_):
            return out
    out[open_] = by_companions(D[open_])
    return out


def upper_first(z: Any, up: int, drift: Any) -> Any:
    """Each row with its `up` roots of smallest real part first; drift(rows, z) = dP/dσ settles ties on the axis."""
    key = z.real.copy()
    n = z.shape[1]
    if 0 < up < n:
        ranks = np.sort(key, 1)
        tie = np.flatnonzero(ranks[:, up] - ranks[:, up - 1] < _TIE * np.abs(z).max(1))
        if len(tie):
            key[tie] += _AHEAD * drift(tie, z[tie]).real
    return np.take_along_axis(z, np.argsort(key, 1), 1)
