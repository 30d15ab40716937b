"""The characteristic matrix of a beam over boxes next to branch points, where upper and lower p-roots almost meet.

There the receptance is large, and Δ̂ the small difference of large products. With an unknown for each pair of p-roots
that are about to meet (`cuts.entries`) it is a determinant of moderate numbers, over a factor that does not vanish.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

import numpy as np

from mpsolve.characteristic.boxes import Boxes
from mpsolve.characteristic.free_matrix import FreeMatrix
from mpsolve.characteristic.free_receptance import Receptances
from mpsolve.characteristic.free_roots import roots_over
from mpsolve.cuts.boxes import EdgeMatrix
from mpsolve.numbers.arrays import Complexes, Truths
from mpsolve.numbers.quadratic import Quadratic
from mpsolve.problem.family import Family

_NEAR = 0.5  # of the distance to others: how close p-roots of two sides are that may be about to meet


@dataclass(frozen=True)
class NearCuts(FreeMatrix):
    """The same matrix, and the bordered one for boxes where that is better."""

    family: Family

    @cached_property
    def _edge(self) -> EdgeMatrix:
        return EdgeMatrix(self.family, -1)

    def __call__(self, boxes: Boxes) -> tuple[Quadratic, Receptances]:
        """(A, the receptances that it is made of); A is larger where some box lies next to a branch point."""
        A, G = super().__call__(boxes)
        y, rho = boxes.variables
        track = self.receptance.track
        with np.errstate(all="ignore"):
            D = track.D(y, rho)
            z, low = track.nodes(D)
            z, near = _paired(z)
            rows = np.flatnonzero(near & (low > 0))
            if not len(rows):
                return A, G
            waves = roots_over(D[rows], track.N(y, rho)[rows], z[rows], low[rows], track.up)
            some = boxes.take(rows)
            P = waves.P
            k, e = self._edge.off_the_cut(some, [P[:, 0], P[:, 2], P[:, 1], P[:, 3]])
        good = waves.good.all(1) & np.isfinite(e).all((1, 2)) & np.isfinite(k).all((0, 2, 3))
        rows, k, e = rows[good], k[:, good], e[good]
        if not len(rows):
            return A, G
        n, more = e.shape[1], e.shape[1] - A.e.shape[1]
        whole = np.pad(A.k, ((0, 0), (0, 0), (0, more), (0, more)))
        whole[0, :, range(n - more, n), range(n - more, n)] = 1
        lost = np.pad(A.e, ((0, 0), (0, more), (0, more)))
        whole[:, rows], lost[rows] = k, e
        known = G.good.copy()
        known[rows] = True
        return Quadratic(whole, lost, A.m), Receptances(G.G, known, G.strain)


def _paired(z: Complexes) -> tuple[Complexes, Truths]:
    """(the nodes a, a′, b, b′, so that b is next to a or b′ next to a′, where one of them is close)."""
    gap = np.abs(z[:, :2, None] - z[:, None, 2:])
    crossed = np.minimum(gap[:, 0, 1], gap[:, 1, 0]) < np.minimum(gap[:, 0, 0], gap[:, 1, 1])
    z = np.where(crossed[:, None], z[:, [0, 1, 3, 2]], z)
    own = np.abs(z[:, :2] - z[:, 2:]).min(1)
    a, a2, b, b2 = z.T
    other = np.min([np.abs(x - w) for x, w in ((a, a2), (a, b2), (b, a2), (b, b2))], axis=0)
    return z, own < _NEAR * other
