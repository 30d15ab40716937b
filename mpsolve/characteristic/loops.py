"""Closed paths round a branch point: the splitting is followed from sheet to sheet until it is back, while Δ̂ turns.

Where an upper and a lower p-root meet, U and L are analytic on a covering of the punctured disc; a path that goes
round as often as the covering asks comes back to its pair. Floats near the p-roots are followed from point to point;
the proof is that neighbouring pieces are linked, as on any other path.
"""

from __future__ import annotations

from math import fsum
from typing import Any

import numpy as np

from mpsolve.characteristic.bordered import Arrays
from mpsolve.characteristic.discs import Splittings, linked, near_roots
from mpsolve.characteristic.paths import discs
from mpsolve.numbers.jets import UP, U
from mpsolve.proof.turning import pivot_arguments, regular


def turn_round(arrays: Arrays, first: Splittings, points: Any, room: float = 1.0) -> tuple[float, float] | None:
    """(the change of arg Δ̂ along the closed polygon, a bound of its error), or None where it is not proved.

    first: the thin splitting at points[0] = points[-1] (q̂), whose pair is the first one and must be the last.
    """
    with np.errstate(all="ignore"):
        m, r = discs(points[:-1], points[1:])
        nodes = _followed(arrays, np.stack([1j * points[:-1], m], 1).ravel(), first.z[0])
        nodes = np.concatenate([nodes, _followed(arrays, 1j * points[-1:], nodes[-1])])
        thin, G, good = arrays.evaluate(1j * points, np.zeros(len(points)), first.up, nodes[::2])
        pieces, values, fine = arrays.evaluate(m, r * room, first.up, nodes[1::2])
        piece = regular(arrays.matrix(values, m))
        A = arrays.matrix(G, 1j * points)
        here, ahead = np.arange(len(m)), np.arange(1, len(points))
        start, lost, sharp = pivot_arguments(piece, A.take(here))
        end, lost_too, sharp_too = pivot_arguments(piece, A.take(ahead))
        passed = fine & piece.good & sharp & sharp_too & good[here] & good[ahead]
        passed &= linked(pieces, thin.take(here)) & linked(pieces, thin.take(ahead))
        back = linked(first, thin.take([0])) & linked(first, thin.take([-1]))
    if not (passed.all() and back.all()):
        return None
    turn = end - start
    error = fsum(np.concatenate([lost, lost_too, 2 * U * np.abs(turn)])) * UP
    return fsum(turn), error + 2 * U * abs(fsum(turn))


def _followed(arrays: Arrays, sigma: Any, z: Any) -> Any:
    """Floats near the p-roots at each σ̂, in the order of those that are nearest at the point before."""
    T, _ = arrays.D.in_time(sigma)
    out = []
    for roots in near_roots(T[:, 0, :]):
        left, here = list(roots), []
        for x in z:
            k = int(np.argmin([abs(x - y) for y in left]))
            here.append(left.pop(k))
        z = np.array(here)
        out.append(z)
    return np.array(out)
