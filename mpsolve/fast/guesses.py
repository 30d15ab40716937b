"""Guesses for roots that the neighbours of a case do not have: from the edge of the cut, and from a grid."""

from __future__ import annotations

from typing import Any

import numpy as np

from mpsolve.fast.cases import Cases
from mpsolve.fast.count import Edge, far_end

_TURNS = np.array([-0.5, -0.35, -0.2, -0.08, -0.02, 0.02, 0.08, 0.2, 0.35, 0.5]) * np.pi
_FAR = np.geomspace(0.02, 1, 8)
_NEAR = np.array([0.2, 0.4, 0.6, 0.8, 1.0])


def edge_guesses(cases: Cases, edge: Edge, nearest: int) -> Any:
    """One Newton step in t, with difference quotients, from between the nodes: shape (cases, nearest).

    A frequency line begins and ends on the cut, so that a root which the neighbours lack is close to it.
    """
    t, branch = edge.t, np.abs(cases.limit)[:, None]
    gap, middle = np.diff(t, axis=1), (t[:, :-1] + t[:, 1:]) / 2
    guesses, reach = [], []
    for side, G in ((1, edge.plus), (-1, edge.minus.conj())):
        with np.errstate(all="ignore"):
            move = -(G[:, :-1] + G[:, 1:]) / 2 * gap / np.diff(G, axis=1)
            distance = np.abs(move) / gap
        r = branch + np.where(middle < 0, -1, 1) * (middle + move) ** 2
        inside = (side * move.imag < 0) & (distance < 4)
        guesses.append(np.where(inside, r + 1j * cases.eta_b[:, None], np.nan))
        reach.append(np.where(inside, distance, np.inf))
    best = np.argsort(np.concatenate(reach, axis=1), axis=1)[:, :nearest]
    return np.take_along_axis(np.concatenate(guesses, axis=1), best, axis=1)


def grid_guesses(cases: Cases) -> Any:
    """Polar grids in the right half-plane of r, dense towards both sides of the cut: wide, and within |q_lm|."""
    radius = np.concatenate([_FAR * np.sqrt(far_end(cases))[:, None], _NEAR * np.abs(cases.limit)[:, None]], axis=1)
    grid = (radius[:, :, None] * np.exp(1j * _TURNS)).reshape(len(cases), radius.shape[1] * len(_TURNS))
    return grid + 1j * cases.eta_b[:, None]
