"""The whole sheet of a beam as the region of its lines: its border are both sides of the cuts.

Roots come and go at the cuts alone: far out there are none for any value of the parameter (`cuts.far`), and what
comes to a branch point is a zero along the cut, too. So the number of roots is the same between two cut points.
"""

from __future__ import annotations

from dataclasses import dataclass
from fractions import Fraction

from mpsolve.characteristic.free_matrix import FreeMatrix
from mpsolve.cuts.edge import beam
from mpsolve.cuts.reached import all_reached
from mpsolve.errors import InputError
from mpsolve.loci.border import Border, Passing
from mpsolve.loci.gate import gate_of
from mpsolve.loci.near_cuts import NearCuts
from mpsolve.loci.room import Room, SheetRoom
from mpsolve.outcome import Reason
from mpsolve.problem.family import family_of
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
