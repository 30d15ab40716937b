"""Where the counted zeros may be, in float64: heuristic, nothing is proved here.

f′/f along the path of the count is approximated by a rational function in barycentric form (the AAA algorithm of
Nakatsukasa, Sète and Trefethen, 2018). Its poles inside are the zeros of f, also multiple ones. The path's own points
serve as samples: they lie densely where f turns fast.
"""

from __future__ import annotations

from typing import Any

import numpy as np

from mpsolve.numbers.arrays import Complexes

_TOLERANCE = 1e-10


def poles_by_aaa(points: Complexes, values: Any, most: int) -> Complexes:
    """The poles of a rational function of degree below `most` that agrees with the values at the points."""
    fine = np.isfinite(values)
    points, places = np.unique(points[fine], return_index=True)  # the sides of a cut share theirs
    values = values[fine][places]
    if len(points) < 4:
        return np.zeros(0, complex)
    rest = np.ones(len(points), bool)
    near = np.full(len(points), values.mean())
    chosen: list[int] = []
    weights = np.zeros(0, complex)
    scale = np.abs(values)
    for _ in range(min(most, len(points) // 2 - 1)):
        with np.errstate(all="ignore"):
            error = np.nan_to_num(np.where(rest, np.abs(values - near) / scale, 0))
        if error.max() <= _TOLERANCE:
            break
        chosen.append(int(error.argmax()))
        rest[chosen[-1]] = False
        cauchy = 1 / (points[rest, None] - points[chosen][None, :])
        loewner = (values[rest, None] - values[chosen][None, :]) * cauchy / scale[rest, None]
        try:
            small = np.linalg.qr(loewner, "r") if len(loewner) > 2 * len(chosen) else loewner
            weights = np.linalg.svd(small)[2][-1].conj()
        except np.linalg.LinAlgError:
            break
        with np.errstate(all="ignore"):
            near = values.copy()
            near[rest] = (cauchy @ (weights * values[chosen])) / (cauchy @ weights)
        if not np.isfinite(near).all():
            break
    return _poles(points[chosen], weights) if len(chosen) == len(weights) else np.zeros(0, complex)


def _poles(points: Complexes, weights: Complexes) -> Any:
    """Where Σ w_j/(z − z_j) = 0: the eigenvalues of an arrowhead pencil, inverted about a point off the path."""
    m = len(points)
    if m < 2:
        return np.zeros(0, complex)
    head, unit = np.zeros((m + 1, m + 1), complex), np.eye(m + 1)
    head[0, 1:], head[1:, 0], unit[0, 0] = weights, 1, 0
    head[1:, 1:] = np.diag(points)
    middle = points.mean()
    shift = middle + (1.2345 + 0.5432j) * np.abs(points - middle).max()
    try:
        inverse = np.linalg.eigvals(np.linalg.solve(head - shift * unit, unit))
    except np.linalg.LinAlgError:
        return np.zeros(0, complex)
    inverse = inverse[np.abs(inverse) > 1e-13 * np.abs(inverse).max(initial=0)]
    return shift + 1 / inverse
