"""The edge of the cut in arrays: p-roots and R·Δ on both of its sides, for real r = q − iη_b ≥ q_lm.

The float64 twin of model/edge.py: D is real in p, its resolvent's largest real root pairs the p-roots by their
order, and the right one of two real roots is an upper root, seen from below the cut, exactly where αp > r.
"""

from __future__ import annotations

from typing import Any

import numpy as np

from mpsolve.fast.cases import Cases, largest_real_root
from mpsolve.model.scaled import SplitRoots, scaled_characteristic


def edge_roots(cases: Cases, r: Any) -> SplitRoots:
    """The p-roots seen from below the cut; r broadcasts with the cases."""
    c2, c1 = -4 * (cases.axial + cases.alpha**2), 8 * cases.alpha * r
    c0 = 4 * (1 - cases.eta_b**2) - 4 * r * r
    y = np.maximum(largest_real_root(2 * c2, c2 * c2 - 4 * c0, -c1 * c1), 0)
    s = np.sqrt(y)
    wide = np.sqrt(np.maximum((y + c2) ** 2 - 4 * c0, 0))
    beyond = wide > s  # s and h share the product c1: the larger one is the better known
    h = np.where(beyond, wide, c1 / np.where(s > 0, s, 1))
    s = np.where(beyond, c1 / np.where(wide > 0, wide, 1), s)
    a, c = _split(cases.alpha, r, s / 2, -s * s / 4 - (c2 + h) / 2)
    b, e = _split(cases.alpha, r, -s / 2, -s * s / 4 - (c2 - h) / 2)
    return SplitRoots(a, b, c, e)


def _split(alpha: Any, r: Any, centre: Any, delta2: Any) -> tuple[Any, Any]:
    """The upper and the lower one of the roots centre ± √δ²."""
    size = np.sqrt(np.abs(delta2))
    offset = np.where(delta2 < 0, 1j * size, np.where(alpha * (centre + size) > r, size, -size))
    return centre + offset, centre - offset


def edge_values(cases: Cases, r: Any) -> tuple[Any, Any]:
    """R·Δ on the lower side of the cut, and its conjugate on the upper side."""
    shift = 1j * cases.eta_b
    kappas = [2 * (r + sign * shift) ** 2 / np.pi for sign in (1, -1)]
    plus, minus = scaled_characteristic(cases.track, edge_roots(cases, r), kappas)
    return plus, minus
