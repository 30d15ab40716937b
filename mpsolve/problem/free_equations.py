"""The equations of a family as they are meant: in the problem's own units, with the free parameters as variables."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from fractions import Fraction
from typing import Any, cast

from mpsolve.numbers.several import Ring, Several
from mpsolve.problem.family import Family, factors_last
from mpsolve.problem.free_track import FreePolynomial, free_matrix
from mpsolve.problem.parameters import changed
from mpsolve.vehicles.vehicle import Pencil, joined


@dataclass(frozen=True)
class FreeEquations:
    """A(P, s)u = e·load with the rows `matrix`, the velocity, and the vehicles' pencil; entries are `Several`."""

    ring: Ring
    matrix: tuple[tuple[FreePolynomial, ...], ...]
    loaded: int
    v: Several
    pencil: Pencil

    def several(self, rows: Iterable[Iterable[Any]]) -> list[list[Several]]:
        """Rows of numbers and polynomials, all as polynomials."""
        return [[self.ring.constant(x) for x in row] for row in rows]


def free_equations(family: Family) -> FreeEquations:
    """Those of a family; x = x̂ · unit for each parameter."""
    problem = family.problem
    point = tuple(x * unit for x, unit in zip(family.ring.point, family.units, strict=True))
    ring = Ring(family.paths, point)
    track, vehicles, v = problem.track, problem.vehicles, cast(Any, problem.v)
    units = (Fraction(1),) * len(point)
    for path, _, x in factors_last(list(zip(family.paths, units, ring.variables, strict=True))):
        track, vehicles, v = changed(track, vehicles, v, path, x)
    pencil = joined([(placed.vehicle.pencil, placed.position, "") for placed in vehicles])
    matrix = tuple(
        tuple({key: ring.constant(c) for key, c in entry.items()} for entry in row)
        for row in free_matrix(track, ring)
    )
    return FreeEquations(ring, matrix, problem.track.waveguide.loaded, ring.constant(v), pencil)
