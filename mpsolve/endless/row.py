"""An endless row: one vehicle's reduced problem, and the distance from one vehicle to the next."""

from __future__ import annotations

from dataclasses import dataclass
from fractions import Fraction
from itertools import pairwise

from mpsolve.errors import InputError
from mpsolve.numbers.model import rational, shown
from mpsolve.problem.case import Case
from mpsolve.problem.cases import Given, as_problem
from mpsolve.problem.problem import Problem
from mpsolve.problem.reduced import Reduced, reduce_problem
from mpsolve.vehicles.vehicle import Placed


@dataclass(frozen=True)
class Row:
    """problem: one vehicle; spacing: from one to the next, in its units; reduced: the problem in scaled units."""

    problem: Problem
    spacing: Fraction

    @property
    def reduced(self) -> Reduced:
        return reduce_problem(self.problem)

    @property
    def step(self) -> Fraction:
        """The spacing in scaled units."""
        return self.spacing / Fraction(2) ** self.reduced.guide.length

    @property
    def gap(self) -> Fraction:
        """The smallest distance between neighbouring contacts of the whole row, scaled."""
        places = self.reduced.places
        own = self.reduced.smallest_gap
        behind = self.step - (places[-1] - places[0])
        return behind if own is None else min(own, behind)

    def train(self, count: int) -> Problem:
        """The finite train of `count` such vehicles, the rearmost one where the problem has it."""
        placed = [
            Placed(p.vehicle, p.position + k * self.spacing) for k in range(count) for p in self.problem.vehicles
        ]
        return Problem(self.problem.track, placed, self.problem.v)

    def at_velocity(self, v: object) -> Row:
        """The same row at another velocity."""
        return Row(Problem(self.problem.track, self.problem.vehicles, v), self.spacing)


def row_of(problem: Given, spacing: object) -> Row:
    """The row that a problem of one vehicle and a spacing describe; InputError where vehicles would overlap."""
    one = as_problem(problem)
    d = _distance(problem, spacing)
    places = one.pencil.places
    span = places[-1] - places[0]
    if d <= span:
        least = "0" if not span else f"the vehicle's own length between contacts, {shown(span)}"
        raise InputError(
            "spacing", f"is {shown(d, spacing)}, but must be above {least}: give the distance to the next vehicle"
        )
    return Row(one, d)


def _distance(problem: Given, spacing: object) -> Fraction:
    """Of a problem in SI a text may have a unit."""
    unit = None if isinstance(problem, Case) else "m"
    return rational(spacing, "spacing", unit, "distance of the vehicles")


def row_in(problem: Given, spacing: object = None) -> tuple[Row, int]:
    """(row, count): of equal vehicles at equal distances, or of one vehicle with a spacing.

    InputError where the vehicles or the distances differ, and where a spacing is missing or contradicts them.
    """
    whole = as_problem(problem)
    placed = sorted(whole.vehicles, key=lambda one: one.position)
    if len(placed) == 1:
        if spacing is None:
            raise InputError("spacing", "is missing for a single vehicle: give the distance from one to the next")
        return row_of(problem, spacing), 1
    if any(one.vehicle != placed[0].vehicle for one in placed):
        raise InputError("vehicle", "are not all equal: an endless train is made of one kind")
    gaps = {b.position - a.position for a, b in pairwise(placed)}
    if len(gaps) > 1:
        raise InputError("vehicle", "are not at equal distances: give them with count and spacing")
    gap = gaps.pop()
    if spacing is not None and _distance(problem, spacing) != gap:
        raise InputError("spacing", f"is {spacing}, but the vehicles are {shown(gap)} apart: leave it out")
    return row_of(Problem(whole.track, placed[0], whole.v), gap), len(placed)
