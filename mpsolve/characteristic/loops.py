"""Closed paths round a branch point: the splitting is followed from sheet to sheet until it is back, while Δ̂ turns.

Where an upper and a lower p-root meet, U and L are analytic on a covering of the punctured disc; a path that goes
round as often as the covering asks comes back to its pair. Floats near the p-roots are followed from point to point;
the proof is that neighbouring pieces are linked, as on any other path.
"""

from __future__ import annotations

from collections.abc import Sequence
from math import fsum
from typing import Any

import numpy as np

from mpsolve.characteristic.disc_matrix import Arrays
from mpsolve.characteristic.discs import Splittings, linked, near_roots
from mpsolve.characteristic.path import discs
from mpsolve.frozen import frozen
from mpsolve.numbers.arrays import Complexes, Integers, Reals, Truths
from mpsolve.numbers.jets import UP, Jet, U
from mpsolve.proof.turning import pivot_arguments, regular


@frozen
class Turned:
    """The change of arg Δ̂ along the whole loop and along its first part, each with a bound of its error."""

    whole: tuple[float, float]
    part: tuple[float, float]


def turn_round(
    halves: Sequence[Arrays],
    first: Splittings,
    points: Complexes,
    part: int,
    room: float = 1.0,
    pole: complex | None = None,
) -> list[Turned] | None:
    """What Δ̂ turns by along the closed polygon, and along its first `part` pieces; None where that is not proved.

    halves: vehicles on one track, whose waves are the same; one answer for each.
    first: thin splittings at points[0] = points[-1] (q̂) and at points[part]: the pair begins and ends with the one,
    and passes the other. pole: about the one P at which a pair of roots meets inside. Then Δ̂ is followed as g·(Δ̂/g),
    g = G(0): the pole is in g alone, and small loops take no more pieces than large ones.
    """
    with np.errstate(all="ignore"):
        m, r = discs(points[:-1], points[1:])
        arrays = halves[0]
        nodes = _followed(arrays, np.stack([1j * points[:-1], m], 1).ravel(), first.z[0])
        nodes = np.concatenate([nodes, _followed(arrays, 1j * points[-1:], nodes[-1])])
        nodes = np.concatenate([nodes[::2], nodes[1::2]])  # of the points, then of the pieces
        middles, radii = np.concatenate([1j * points, m]), np.concatenate([np.zeros(len(points)), r * room])
        known, matrices, good = _matrices(halves, middles, radii, first.up, nodes, pole)
        here, ahead = np.arange(len(m)), np.arange(1, len(points))
        over = len(points) + here
        passed, pieces = good[over] & good[here] & good[ahead], known.take(over)
        passed &= linked(pieces, known.take(here)) & linked(pieces, known.take(ahead))
        joined = linked(pieces.take([0, -1, part]), first.take([0, 0, 1]))
        if not (passed.all() and joined.all()):
            return None
        out = [_along(some, here, ahead, over, part) for some in matrices]
    return None if None in out else [one for one in out if one is not None]


def _along(matrices: Sequence[Jet], here: Integers, ahead: Integers, over: Integers, part: int) -> Turned | None:
    """Of one half: matrices at points and, from number `over` on, over pieces from one point to the one ahead."""
    turns, errors = np.zeros(len(here)), np.zeros(len(here))
    for A in matrices:
        piece = regular(A.take(over))
        start, lost, sharp = pivot_arguments(piece, A.take(here))
        end, lost_too, sharp_too = pivot_arguments(piece, A.take(ahead))
        if not (piece.good & sharp & sharp_too).all():
            return None
        turns = turns + (end - start)
        errors = errors + (lost + lost_too + 8 * U * np.abs(end - start)) * UP
    return Turned(_total(turns, errors), _total(turns[:part], errors[:part]))


def _total(turns: Reals, errors: Reals) -> tuple[float, float]:
    total = fsum(turns)
    return total, fsum(errors) * UP + 2 * U * abs(total) + 8 * U * fsum(np.abs(turns))


def _matrices(
    halves: Sequence[Arrays], m: Complexes, r: Reals, up: int, nodes: Complexes, pole: complex | None
) -> tuple[Splittings, list[list[Jet]], Truths]:
    """(splittings, for each half matrices whose determinants have the product Δ̂ up to a constant, where bounded)."""
    if pole is None:
        s, G, good = halves[0].evaluate(m, r, up, nodes)
        return s, [[half.matrix(G, m)] for half in halves], good
    s, H, g, good = halves[0].without_pole(m, r, up, nodes, pole)
    return s, [[half.beside_pole(H, g, m, pole), g[:, None, None]] for half in halves], good


def _followed(arrays: Arrays, sigma: Any, z: Any) -> Complexes:
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
