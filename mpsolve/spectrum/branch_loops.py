"""Loops round the branch points of a cut on one line: no sheet that meets there has a root next to them."""

from __future__ import annotations

from dataclasses import field
from typing import Any

import numpy as np
from flint import arb

from mpsolve.characteristic.discs import split
from mpsolve.characteristic.loops import turn_round
from mpsolve.characteristic.paths import Paths
from mpsolve.errors import PrecisionError
from mpsolve.frozen import frozen
from mpsolve.numbers.balls import precision
from mpsolve.problem.line import Line
from mpsolve.proof.effort import Effort

_FIRST, _SMALLEST, _SHRINK = 0.15, 2.0**-28, 4  # of the distance to what is next: radii of loops
_SIDES = (12, 16, 24, 48, 96)
_REAL = 1e-3  # relative, in floats


@frozen
class BranchPoint:
    """Where real p-roots meet, z > 0: how often it is a root of the discriminant, how far the next one or 0 is.

    pole: about the P at which one pair meets; None where more roots do.
    """

    z: float
    multiplicity: int
    room: float
    pole: complex | None


@frozen
class Loop:
    """A polygon from centre − radius several times round a branch point, on which Δ̂ turns as its pole there asks."""

    centre: float
    radius: float
    sides: int
    points: Any
    half: tuple[float, float] = field(compare=False)
    """The change of arg Δ̂ along the first half, below the real axis, and a bound of its error."""

    @property
    def first(self) -> float:
        """Where the loop begins, on the real axis."""
        return self.centre - self.radius

    @property
    def last(self) -> float:
        """Where it comes back to the real axis for the first time."""
        return self.centre + self.radius

    @property
    def reach(self) -> float:
        """The radius of a disc round the centre that holds all points."""
        return self.radius * (1 + 2.0**-10)


def edge_points(line: Line) -> list[BranchPoint]:
    """The branch points on the edge of the cut, ascending."""
    found = [(float(z), k) for z, k in line.branch_points]
    out = []
    for j, (z, k) in enumerate(found):
        others = [abs(z - other) for i, (other, _) in enumerate(found) if i != j]
        pole = _meeting(line, z)
        if k > 2 or pole is not None:
            out.append(BranchPoint(z, k, min([z, *others]), pole if k == 1 else None))
    return out


def _meeting(line: Line, z: float) -> complex | None:
    """In floats: where p-roots meet at z, if they are real (P = ip imaginary). What is left out, no path can pass."""
    coefficients = np.zeros(5, complex)
    for (i, j), c in line.lower.guide.D.items():
        coefficients[i] += float(c) * (1j * z) ** j
    roots = np.roots(coefficients[::-1])
    size = np.abs(roots).max()
    gaps = np.abs(roots[:, None] - roots[None, :]) + 10 * np.eye(4) * size
    pair = np.unravel_index(np.argmin(gaps), gaps.shape)
    middle = complex(roots[list(pair)].mean())
    return complex(0, middle.imag) if abs(middle.real) < _REAL * size else None


def find_loop(line: Line, paths: Paths, point: BranchPoint, effort: Effort) -> Loop:
    """The largest loop of a ladder round the branch point; PrecisionError where none is proved."""
    sites = len(line.lower.places)
    turns, poles = (4, 4 if sites > 1 else 3) if point.multiplicity > 2 else (2, min(point.multiplicity, sites))
    ratio = _FIRST
    while ratio > _SMALLEST:
        radius = float(np.float32(ratio * point.room))
        centre = float(np.float32(point.z)) if ratio > 2.0**-16 else point.z
        loop = _turned(paths, point, centre, radius, turns, poles, effort)
        if loop is not None:
            return loop
        ratio /= _SHRINK
    unit = float(line.lower.frequency_unit)
    place = f"the branch point of the cuts at Re q = {point.z * unit:.8g}"
    raise PrecisionError(
        f"on one of the sheets that meet at {place} a root may lie closer to it than floats can tell"
    )


def _turned(
    paths: Paths, point: BranchPoint, centre: float, radius: float, turns: int, poles: int, effort: Effort
) -> Loop | None:
    for sides in _SIDES:
        points = _polygon(centre, radius, sides, turns)
        effort.spend(2 * len(points))
        ends = split(paths.arrays.D, 1j * points[[0, sides // 2]], np.zeros(2), paths.up)
        turn = turn_round(paths.arrays, ends, points, sides // 2, paths.room, point.pole)
        if turn is None:
            continue
        with precision(64):
            number = (arb(*turn.whole) / (2 * arb.pi())).unique_fmpz()
        right = number is not None and int(number) == -poles
        return Loop(centre, radius, sides, points, turn.part) if right else None
    return None


def _polygon(centre: float, radius: float, sides: int, turns: int) -> Any:
    """Counterclockwise from centre − radius; points are short, those on the real axis exact."""
    angle = np.pi * (1 + 2 * np.arange(sides) / sides)
    once = (np.cos(angle) + 1j * np.sin(angle)).astype(np.complex64).astype(complex)
    once[0], once[sides // 2] = -1, 1
    return centre + radius * np.append(np.tile(once, turns), -1)
