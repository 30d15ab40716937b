"""The argument at which a count closes: pivots of an accretive matrix at ρ, in float64 (spectrum/closing.py)."""

from __future__ import annotations

from typing import Any

import numpy as np

from mpsolve.batch.groups import Group
from mpsolve.batch.kernel import chunks, receptances
from mpsolve.numbers.arrays import Complexes, Integers, Reals

_SMALL = 1e-9  # of the largest entry of its row: a pivot below it is not told from 0


def closing_argument(group: Group, rho: Reals) -> Reals:
    """Σ Arg(pivots of M) at σ̂ = iρ̂, M = [[S/σ, −B], [Bᵀ, σ(G + h)]]; nan where a pivot may be 0."""
    out, rows = np.empty(len(group)), np.arange(len(group))
    for part in chunks(group, len(group)):
        out[part] = _pivots(accretive(group, rows[part], 1j * rho[part]))
    return out


def accretive(group: Group, rows: Integers, sigma: Any) -> Complexes:
    """M, contacts first: their block is clearly accretive, and the bodies' are so where it reaches them."""
    n, c = group.bodies, group.contacts
    G = receptances(group, rows, sigma).G
    s = sigma[:, None, None]
    S = (group.S2[rows] * s + group.S1[rows]) * s + group.S0[rows]
    S[:, ~group.neutral] /= s
    M = np.zeros((len(rows), n + c, n + c), complex)
    M[:, :c, :c] = s * (G + group.h[rows][:, :, None] * np.eye(c))
    M[:, :c, c:] = group.B[rows].swapaxes(1, 2)
    M[:, c:, :c] = -group.B[rows]
    M[:, c:, c:] = S
    return M


def _pivots(M: Complexes) -> Reals:
    """By elimination with the largest diagonal entry first."""
    total, index = np.zeros(len(M)), np.arange(len(M))
    size = np.maximum(np.abs(M).max(2), 1e-300)
    while M.shape[1]:
        diagonal = np.einsum("kii->ki", M)
        pick = np.argmax(np.abs(diagonal) / size, 1)
        pivot = diagonal[index, pick]
        with np.errstate(all="ignore"):
            total = np.where(np.abs(pivot) > _SMALL * size[index, pick], total + np.angle(pivot), np.nan)
            row, column = M[index, pick], M[index, :, pick]
            M = M - column[:, :, None] * (row / pivot[:, None])[:, None, :]
        rest = np.arange(M.shape[1] - 1)[None, :]
        rest = rest + (rest >= pick[:, None])
        M = np.take_along_axis(np.take_along_axis(M, rest[:, :, None], 1), rest[:, None, :], 2)
        size = np.take_along_axis(size, rest, 1)
    return total
