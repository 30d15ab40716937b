"""Where a vehicle vibrates on springs and dampers that stand for the track, in floats: nothing is proved.

At one frequency the track is the complex matrix G. The vehicle on it has the eigenvalues of a quadratic pencil; those
near that frequency are near roots of Δ̂. That finds bodies on soft springs far below the waves of a track, too. On a
track that does not move at all the vehicle shows how far out its own vibrations are.
"""

from __future__ import annotations

import numpy as np

from mpsolve.characteristic.floats import Floats
from mpsolve.numbers.arrays import Complexes
from mpsolve.problem.reduced import Reduced

_LEAST, _RATIO = 1e-18, 1.7  # of the size: from where on frequencies are looked at, and one over the one before
_SMALL, _SHARE = 40, 1e-5  # bodies: of more, only from this part of the size on


def on_frozen_track(function: Floats, size: float) -> Complexes:
    """Scaled q̂, Re q̂ ≥ 0, up to |q̂| = size or a little beyond."""
    reduced = function.reduced
    S, B = [np.array(rows, float) for rows in reduced.S], np.array(reduced.B, float)
    n, least = len(B), _LEAST if len(B) <= _SMALL else _SHARE
    q = size * _RATIO ** np.arange(np.log(least) / np.log(_RATIO), 1)
    with np.errstate(all="ignore"):
        G = np.array(function.receptance(1j * q, function.border.distances, slope=False)[0])
        G = np.moveaxis(G[np.array(function.border.which)], -1, 0) + np.diag([float(x) for x in reduced.h])
        known = np.isfinite(G).all((1, 2))
        q, G = q[known], G[known]
        try:
            K = S[0] + B @ np.linalg.solve(G, np.broadcast_to(B.T, (len(q), *B.T.shape)))
            less = -np.linalg.solve(K, np.broadcast_to(np.hstack(S[1:]), (len(q), n, 2 * n)))
        except np.linalg.LinAlgError:
            return np.zeros(0, complex)
        both = np.concatenate([less, np.broadcast_to(np.eye(n, 2 * n), less.shape)], 1)
        known = np.isfinite(both).all((1, 2))
        q, both = q[known], both[known]
        found = -1j / np.linalg.eigvals(both)  # of the pencil turned round, so that masses may be 0
    near = found[(np.abs(found) < q[:, None] * _RATIO) & (np.abs(found) > q[:, None] / _RATIO)]
    return np.asarray(np.abs(near.real) + 1j * near.imag, complex)


def on_rigid_rail(reduced: Reduced) -> Complexes:
    """The vehicle's own σ̂ where springs of contacts stand on a rail that stands still; tight contacts are free."""
    (K, C, M), B = (np.array(rows, float) for rows in reduced.S), np.array(reduced.B, float)
    soft = [j for j, h in enumerate(reduced.h) if h]
    K = K + (B[:, soft] / np.array([reduced.h[j] for j in soft], float)) @ B[:, soft].T
    n = len(M)
    try:
        inverse = np.linalg.pinv(M)
        found = np.linalg.eigvals(np.vstack([np.eye(n, 2 * n, n), np.hstack([-inverse @ K, -inverse @ C])]))
    except np.linalg.LinAlgError:
        return np.zeros(0, complex)
    return found.astype(complex)
