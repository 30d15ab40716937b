"""K(ξ, q) of (17) between two masses in float64, for arrays of velocity ratios and frequencies."""

from __future__ import annotations

from typing import Any

import numpy as np

from mpsolve import Problem, tracks, vehicles
from mpsolve.batch.entries import entries_of
from mpsolve.batch.groups import groups_of
from mpsolve.batch.kernel import receptances


def kernels(alpha: Any, eta_b: float, d: float, q: Any, slope: bool = False) -> tuple[Any, Any]:
    """K between the masses, shape (…, 2, 2), and dK/dq where asked; alpha and q broadcast; nan where q is nan."""
    alpha, q = np.broadcast_arrays(np.asarray(alpha, float), np.asarray(q, complex))
    if not q.size:
        return np.zeros((*q.shape, 2, 2), complex), np.zeros((*q.shape, 2, 2), complex)
    velocities, which = np.unique(alpha, return_inverse=True)
    beam = tracks.EulerBernoulli(EI="0.25", m=1, k=1, c=str(2 * eta_b))
    pair = Problem(beam, vehicles.train(vehicles.Mass(1), 2, str(d)), v=1)
    entries = entries_of(pair, {"v": velocities})
    (group,) = groups_of(entries, np.arange(len(entries)))[0]
    S, B, unit = (group.S2[0, 0, 0], group.B[0, 0, 0], group.unit[0])
    scale = np.pi / 2 * S / (unit * B) ** 2  # K = π/2 G, G = g Ĝ, and S₂ = g (unit · B)² for a mass of 1
    row = np.argsort(group.index)[which.ravel()]
    fine = np.flatnonzero(np.isfinite(q.ravel()))
    out = np.full((2, q.size, 2, 2), np.nan, complex)
    values = receptances(group, row[fine], 1j * q.ravel()[fine] / unit, slope=slope)
    out[0, fine] = scale * values.G
    if slope:
        out[1, fine] = scale * values.G_sigma * 1j / unit
    return out[0].reshape(*q.shape, 2, 2), out[1].reshape(*q.shape, 2, 2)
