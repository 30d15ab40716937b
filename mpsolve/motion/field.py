"""The beam away from the masses: W̃(ξ, q) = (1/π) Σ_j S_j K(ξ − x_j, q), eq. (20), at many ξ and q in float64."""

from __future__ import annotations

from collections.abc import Iterable
from typing import Any

import numpy as np

from mpsolve.model.branch import Pairing, Track
from mpsolve.model.kernel import AHEAD, BEHIND, kernel, kernel_at_contact


def kernels_at(track: Track, pair: Pairing, xi: Any, place: float) -> Any:
    """K(ξ − place, q), shape (len(xi), number of q)."""
    values = np.empty((len(xi), np.size(pair.s)), complex)
    gap = np.asarray(xi, float) - place
    values[gap == 0] = kernel_at_contact(track, pair)
    for side, where in ((AHEAD, gap > 0), (BEHIND, gap < 0)):
        if where.any():
            values[where] = kernel(track, pair, side, np.abs(gap[where])[:, None])
    return values


def images_at(track: Track, pair: Pairing, S: Iterable[Any], xi: Any) -> Any:
    """W̃(ξ, q), shape (len(xi), number of q); with S the residues of S_j, the residues of W̃."""
    total = np.zeros((len(xi), np.size(pair.s)), complex)
    for force, place in zip(S, track.positions, strict=True):
        total += force * kernels_at(track, pair, xi, place)
    return total / np.pi
