"""The whole sheet of a beam as the region of its lines: its border are both sides of the cuts.

Roots come and go at the cuts alone: far out there are none for any value of the parameter (`cuts.far`), and what
comes to a branch point is a zero along the cut, too. So the number of roots is the same between two cut points.

Next to branch points, where upper and lower p-roots almost meet, the receptance is large, and Δ̂ the small difference
of large products. With an unknown for each pair of p-roots that are about to meet (`cuts.entries`) it is a
determinant of moderate numbers, over a factor that does not vanish.
"""

from __future__ import annotations

from dataclasses import dataclass
from fractions import Fraction
from functools import cached_property

import numpy as np

from mpsolve.characteristic.boxes import Boxes
from mpsolve.characteristic.free_matrix import FreeMatrix
from mpsolve.characteristic.free_receptance import Receptances
from mpsolve.characteristic.free_roots import roots_over
from mpsolve.cuts.boxes import EdgeMatrix
from mpsolve.cuts.edge import beam
from mpsolve.cuts.reached import all_reached
from mpsolve.errors import InputError
from mpsolve.loci.border import Border, Passing
from mpsolve.loci.gate import gate_of
from mpsolve.loci.room import Room, SheetRoom
from mpsolve.numbers.arrays import Complexes, Truths
from mpsolve.numbers.quadratic import Quadratic
from mpsolve.outcome import Reason
from mpsolve.problem.family import Family, family_of
from mpsolve.problem.line import line_height
from mpsolve.problem.problem import Problem
from mpsolve.progress import Progress
from mpsolve.proof.effort import Effort
from mpsolve.ranges.answer import Interval
from mpsolve.ranges.scope import Scope, scope_of
from mpsolve.spectrum.regions import Sheet


@dataclass(frozen=True)
class OnSheet:
    """height: 0 where no root crosses the real axis but at a cut, as without damping; else only that it is above."""

    scope: Scope
    height: Fraction

    @property
    def asked(self) -> str:
        """What the spectrum at one point is asked for."""
        return "sheet"

    @property
    def answered(self) -> Sheet:
        """What the answer speaks of."""
        return Sheet()

    @property
    def matrix(self) -> FreeMatrix:
        """Whose determinant vanishes where roots are."""
        return NearCuts(self.scope.family)

    @property
    def room(self) -> Room:
        low, high = (float(end[0]) for end in (self.scope.low, self.scope.high))
        return SheetRoom(low, high, family=self.scope.family)

    def border(self, digits: int, budget: Effort, progress: Progress) -> Border:
        """All cut points, with a gate to each at an end of the gap."""
        found = all_reached(self.scope.family, digits, budget, progress)
        passings, room = [], self.room
        for one in found.points:
            gate = gate_of(one, room.low, room.high) if one.side == "gap" else None
            passings.append(Passing(one.q, one.x, 2 if one.appears else -2, one.side, gate))
        reason = found.reason
        if reason is None and found.reach is not None:
            message = "no theorem tells of roots on the cut at higher frequencies for this vehicle"
            reason = Reason("far", message, {}, "ask for a region below the cuts")
        return Border(tuple(passings), (), (), reason)


def on_sheet(problem: Problem, over: dict[str, Interval]) -> OnSheet:
    """InputError for a track whose cuts do not lie on one line, and where a premise fails somewhere."""
    if line_height(problem.track) is None:
        raise InputError(
            "region", 'is "sheet", which is told of an Euler–Bernoulli beam with c² < 4 k m: leave it out'
        )
    family = family_of(problem, over)
    if not beam(family)[4]:
        return OnSheet(Scope(family), Fraction(0))
    scope = scope_of(problem, over)
    return OnSheet(scope, Fraction(scope.X))


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
