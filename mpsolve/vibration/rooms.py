"""How far a point of the σ-plane is from the cuts, the curves σ = ivp + s_k(p) of waves with real p; in float64."""

from __future__ import annotations

from typing import Any

import numpy as np

from mpsolve.vibration.image import Image

_POINTS, _ROUNDS, _CLOSER = 600, 4, 30.0
_FURTHEST = 4096.0


def room(image: Image, sigma: complex) -> float:
    """The distance of σ from the nearest cut, scaled; nothing is proved by it."""
    guide = image.guide
    rows = np.zeros((max(i for i, _ in guide.D) + 1, max(j for _, j in guide.D) + 1))
    for (i, j), c in guide.D.items():
        rows[i, j] = float(c)
    low, high, best, at = 1e-9, 2.0, np.inf, 0.0
    while high < _FURTHEST:  # as far as waves of some branch are as slow as σ
        p = _grid(low, high)
        found = _distances(rows, p, sigma)
        if found.min() < best:
            best, at = float(found.min()), float(p[int(np.argmin(found))])
        low, high = high, 2 * high
    width = max(abs(at), 1.0) * 0.05
    for _ in range(_ROUNDS):
        p = at + np.linspace(-width, width, _POINTS)
        found = _distances(rows, p, sigma)
        best, at, width = min(best, float(found.min())), float(p[int(np.argmin(found))]), width / _CLOSER
    return best


def _grid(low: float, high: float) -> Any:
    positive = np.linspace(low, high, _POINTS)
    return np.concatenate([-positive[::-1], positive])


def _distances(rows: Any, p: Any, sigma: complex) -> Any:
    """From σ to the nearest root of D(ip, ·) at each p."""
    powers = (1j * p[:, None]) ** np.arange(len(rows))
    D = powers @ rows
    lead = np.abs(D).max(1)
    degree = D.shape[1] - 1
    while degree and (np.abs(D[:, degree]) < 1e-14 * lead).all():
        degree -= 1
    companion = np.zeros((len(p), degree, degree), complex)
    companion[:, range(degree - 1), range(1, degree)] = 1
    with np.errstate(all="ignore"):
        companion[:, -1] = -D[:, :degree] / D[:, degree : degree + 1]
    companion[~np.isfinite(companion).all((1, 2))] = np.nan_to_num(np.inf)
    return np.abs(np.linalg.eigvals(companion) - sigma).min(1)
