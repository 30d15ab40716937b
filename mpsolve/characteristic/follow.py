"""All roots of many polynomials whose coefficients change little from one to the next: Newton from a few of them.

Some rows are solved as eigenvalues. The others start from the roots of the nearest of these; their sum and product
must then be those that the coefficients tell, else they are solved as eigenvalues too. So no root is taken twice.
"""

from __future__ import annotations

from typing import Any

import numpy as np

from mpsolve.characteristic.symbol import horner, slope_in_P
from mpsolve.numbers.arrays import Complexes
from mpsolve.numbers.float64 import companions

_EVERY = 5
_STEPS = 5
_SURE = 1e-10


def followed(D: Any) -> Complexes:
    """The roots of each row of D (rows, degree + 1), coefficients from the constant term up; (rows, degree)."""
    rows, degree = len(D), D.shape[1] - 1
    if rows <= 2 * _EVERY or degree < 3:
        return eigenvalues(D)
    anchors = np.arange(_EVERY // 2, rows, _EVERY)
    z = np.empty((rows, degree), complex)
    z[anchors] = eigenvalues(D[anchors])
    rest = np.setdiff1d(np.arange(rows), anchors)
    near = anchors[np.minimum(rest // _EVERY, len(anchors) - 1)]
    c = D[rest]
    found = _newton(c, z[near])
    sure = _whole(c, found)
    found[~sure] = eigenvalues(c[~sure])
    z[rest] = found
    return z


def eigenvalues(D: Any) -> Complexes:
    """The same, each row by the eigenvalues of its companion matrix."""
    return np.linalg.eigvals(companions(D))


def _newton(D: Any, z: Any) -> Any:
    columns = [D[:, k : k + 1] for k in range(D.shape[1])]
    slope = slope_in_P(columns)
    with np.errstate(all="ignore"):
        for _ in range(_STEPS):
            z = z - horner(columns, z) / horner(slope, z)
    return z


def _whole(D: Any, z: Any) -> Any:
    """Where all roots are there, each as often as it should be, as their sum and product tell."""
    with np.errstate(all="ignore"):
        total, product = -D[:, -2] / D[:, -1], D[:, 0] / D[:, -1] * (-1) ** z.shape[1]
        size = np.abs(z).sum(1)
        right = np.abs(z.sum(1) - total) <= _SURE * size
        return right & (np.abs(z.prod(1) / product - 1) <= _SURE)
