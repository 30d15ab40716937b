"""Where the first crossing of a range seems to lie, in floats: heuristic, proofs start from it and do not rest on it.

From points of a grid of (q̂, x̂) Newton's method is tried, all points side by side; what stays near its point is kept.
"""

from __future__ import annotations

from typing import Any

import numpy as np

from mpsolve.characteristic.boxes import Boxes
from mpsolve.characteristic.free_matrix import FreeMatrix
from mpsolve.problem.family import Family
from mpsolve.proof.vanishing import guess, scalar

_Q = np.geomspace(2.0**-6, 2.0**3, 19)
"""Ends of cells of q̂."""
_X = 12  # cells of x̂
_WIDE = 4  # ends of a range further apart than by this factor are parted by equal factors
_SMALL = 2.0**-8  # of a cell: the boxes in which slopes are taken
_ROUNDS, _NEAR, _DONE = 4, 4.0, 2.0**-6  # steps; of a cell: as far as they may lead, and the last


def first_seen(family: Family) -> tuple[float, float] | None:
    """(q̂, x̂) of the crossing with the least x̂ that is met, for a family of one parameter; None where none is."""
    low, high = (float(x) for x in family.box[0])
    ends = np.geomspace(low, high, _X + 1) if 0 < low * _WIDE < high else np.linspace(low, high, _X + 1)
    start, half = (np.stack([a.ravel() for a in np.meshgrid(*both)]) for both in _cells(_Q, ends))
    matrix, m = FreeMatrix(family), start
    with np.errstate(all="ignore"):
        for _ in range(_ROUNDS):
            r = half * _SMALL
            A, G = matrix(Boxes(m, r))
            s = scalar(A, G.good)
            step = r * guess(s.s)
            kept = s.good & (np.abs(m + step - start) < _NEAR * half).all(0)
            start, half, m, step = (a[:, kept] for a in (start, half, m + step, step))
            if not m.size:
                return None
    sure = (np.abs(step) < _DONE * half).all(0) & (m[0] > 0) & (m[1] > low) & (m[1] < high)
    return min(((float(q), float(x)) for q, x in m[:, sure].T), key=lambda one: one[1], default=None)


def _cells(q: Any, x: Any) -> tuple[tuple[Any, Any], tuple[Any, Any]]:
    """Middles and halves along both."""
    return ((q[1:] + q[:-1]) / 2, (x[1:] + x[:-1]) / 2), ((q[1:] - q[:-1]) / 2, (x[1:] - x[:-1]) / 2)
