"""Loops round the branch points of a cut on one line: no sheet that meets there has a root next to them."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import field, replace
from fractions import Fraction
from typing import Any

import numpy as np
from flint import arb

from mpsolve.characteristic.disc_matrix import Arrays
from mpsolve.characteristic.discs import split
from mpsolve.characteristic.loops import turn_round
from mpsolve.characteristic.paths import Paths
from mpsolve.errors import PrecisionError
from mpsolve.frozen import frozen
from mpsolve.numbers.arrays import Complexes
from mpsolve.numbers.balls import precision
from mpsolve.numbers.jets import UP, U
from mpsolve.numbers.realroots import end_of
from mpsolve.problem.line import Line
from mpsolve.proof.effort import Effort
from mpsolve.spectrum.near_loop import Ways, about, ways_to

_RATIOS = [0.06 * 4.0**-k for k in range(6)] + [2.0**-k for k in range(18, 84, 5)]
"""Of the distance to what is next: radii of loops that are tried."""
_SMALL = 2.0**-14  # below it floats count from the branch point
_JOIN = 2.0**-7  # where ways to such a loop begin
_SIDES, _FEW = (8, 12, 16, 24, 48, 96), 3
_REAL = 1e-3  # relative, in floats


@frozen
class BranchPoint:
    """Where real p-roots meet, z > 0: how often it is a root of the discriminant, how far the next one or 0 is.

    exact: z to some 120 bits.
    pole: about the P at which one pair meets; None where more roots do.
    """

    z: float
    multiplicity: int
    room: float
    pole: complex | None
    exact: Fraction


@frozen
class Loop:
    """A polygon from centre − radius several times round a branch point, on which Δ̂ turns as its pole there asks.

    ways: those to a loop that is so small that its numbers count from the branch point.
    """

    centre: float
    radius: float
    sides: int
    points: Complexes
    half: tuple[float, float] = field(compare=False)
    """The change of arg Δ̂ from `first` to `last`, below the real axis, and a bound of its error."""
    ways: Ways | None = None

    @property
    def about(self) -> Fraction:
        """What the points and the centre count from."""
        return self.ways.z if self.ways is not None else Fraction(0)

    @property
    def first(self) -> float:
        """Where the way along the real axis is left, on it."""
        return self.ways.first if self.ways is not None else self.centre - self.radius

    @property
    def begin(self) -> Fraction:
        """Where Δ̂ begins to be followed, exactly: at `first`, or where the loop begins."""
        linked = self.ways is not None and self.ways.linked
        return self.about - Fraction(self.radius) if linked else Fraction(self.first)

    @property
    def last(self) -> float:
        """Where it goes on."""
        return self.ways.last if self.ways is not None else self.centre + self.radius

    @property
    def reach(self) -> float:
        """The radius of a disc round the centre that holds all points."""
        return self.radius * (1 + 2.0**-10)

    @property
    def pieces(self) -> int:
        return len(self.points) - 1 + (self.ways.pieces if self.ways is not None else 0)

    @property
    def places(self) -> Any:
        """The points, and those of the ways, in floats."""
        if self.ways is None:
            return self.points
        return float(self.ways.z) + np.concatenate([self.points, self.ways.before, self.ways.behind])


def edge_points(line: Line) -> list[BranchPoint]:
    """The branch points on the edge of the cut, ascending."""
    found = [(float(z), k, end_of(z, 0)) for z, k in line.branch_points]
    out = []
    for j, (z, k, exact) in enumerate(found):
        others = [abs(z - other) for i, (other, *_) in enumerate(found) if i != j]
        pole = _meeting(line, z)
        if k > 2 or pole is not None:
            out.append(BranchPoint(z, k, min([z, *others]), pole if k == 1 else None, exact))
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


def find_loops(line: Line, halves: Sequence[Paths], point: BranchPoint, effort: Effort) -> list[Loop]:
    """The largest loop of a ladder round the branch point, for each half; PrecisionError where none is proved."""
    sites = len(line.lower.places)
    turns, poles = (4, 4 if sites > 1 else 3) if point.multiplicity > 2 else (2, min(point.multiplicity, sites))
    near = [about(paths.arrays.reduced, point.exact, point.pole) for paths in halves]
    linked = not line.height and not line.joined  # real roots may lie in the gap
    for sides in (_SIDES[:_FEW], _SIDES[_FEW:]):  # more of them are tried where no smaller loop will do
        for ratio in _RATIOS:
            large = ratio > _SMALL
            arrays = [paths.arrays for paths in halves] if large else near
            centre = float(np.float32(point.z)) if large else 0.0
            loops = _turned(halves[0], arrays, point, centre, ratio * point.room, (turns, poles), sides, effort)
            if loops and large:
                return loops
            if loops:
                reach = _JOIN * point.room
                told = (
                    ways_to(*one, loops[0].radius, reach, linked, effort) for one in zip(halves, near, strict=True)
                )
                return [_with_ways(loop, ways) for loop, ways in zip(loops, told, strict=True)]
    unit = float(line.lower.frequency_unit)
    place = f"the branch point of the cuts at Re q = {point.z * unit:.8g}"
    raise PrecisionError(
        f"on one of the sheets that meet at {place} a root may lie closer to it than floats can tell"
    )


def _with_ways(loop: Loop, ways: Ways) -> Loop:
    turn, lost = (x + y for x, y in zip(loop.half, ways.turn, strict=True))
    return replace(loop, half=(turn, (lost + 4 * U * abs(turn)) * UP), ways=ways)


def _turned(
    paths: Paths,
    halves: Sequence[Arrays],
    point: BranchPoint,
    centre: float,
    radius: float,
    asked: tuple[int, int],
    numbers: tuple[int, ...],
    effort: Effort,
) -> list[Loop]:
    """The loop of this radius, of one of the numbers of sides, for each half, or none; asked: rounds and poles."""
    radius, (turns, poles) = float(np.float32(radius)), asked
    for sides in numbers:
        points = _polygon(centre, radius, sides, turns)
        effort.spend(2 * len(points))
        ends = split(halves[0].D, 1j * points[[0, sides // 2]], np.zeros(2), paths.up)
        found = turn_round(halves, ends, points, sides // 2, paths.room, point.pole)
        if found is None:
            continue
        with precision(64):
            rounds = [(arb(*turn.whole) / (2 * arb.pi())).unique_fmpz() for turn in found]
        right = all(number is not None and int(number) == -poles for number in rounds)
        return [Loop(centre, radius, sides, points, turn.part) for turn in found] if right else []
    return []


def _polygon(centre: float, radius: float, sides: int, turns: int) -> Any:
    """Counterclockwise from centre − radius; points are short, those on the real axis exact."""
    angle = np.pi * (1 + 2 * np.arange(sides) / sides)
    once = (np.cos(angle) + 1j * np.sin(angle)).astype(np.complex64).astype(complex)
    once[0], once[sides // 2] = -1, 1
    return centre + radius * np.append(np.tile(once, turns), -1)
