"""The region of q in which all roots are followed, the same for every value of the parameter.

Im q < 0, and Im q < h as far as |Re q| < reach, h below the cuts of all tracks of the family. Its border in Re q ≥ 0
is made of edges: the upper side, the right side, and beyond them the real axis, on which contacts are passive.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from fractions import Fraction
from math import nextafter
from typing import TYPE_CHECKING

from mpsolve.characteristic.free_matrix import FreeMatrix
from mpsolve.errors import InputError
from mpsolve.loci.room import Room
from mpsolve.numbers.model import rational, shown
from mpsolve.numbers.plain import float_beside
from mpsolve.problem.family import Family
from mpsolve.problem.line import moved_in_s
from mpsolve.ranges.enclosed import REAL_AXIS, Edge
from mpsolve.ranges.premises import require_stable_track
from mpsolve.ranges.scope import Scope
from mpsolve.spectrum.regions import Below, HalfPlane
from mpsolve.spectrum.solve import default_height
from mpsolve.tracks.at_rest import lowest_cut

if TYPE_CHECKING:
    from mpsolve.problem.problem import Problem

_SHARES = (Fraction(1), Fraction(3, 4), Fraction(1, 2), Fraction(1, 4))
"""Of the height that points of a family show: what is tried where the cuts move with the parameter."""
_LEAST_REACH = 2.0


@dataclass(frozen=True)
class Side:
    """One edge of the region with the part of it, low ≤ y ≤ high, on which roots are to be found."""

    edge: Edge
    low: float
    high: float
    name: str


@dataclass(frozen=True)
class Region:
    """Scaled, and numbers of float64 both: the height h (0: Im q < 0 alone) and the reach."""

    scope: Scope
    height: Fraction
    reach: Fraction

    @property
    def asked(self) -> Below | HalfPlane:
        """What the spectrum at one point is asked for, in the problem's units."""
        return Below(self.height * self.scope.family.frequency_unit) if self.height else HalfPlane()

    @property
    def answered(self) -> Below | HalfPlane:
        """What the answer speaks of."""
        asked = self.asked
        if isinstance(asked, HalfPlane):
            return asked
        return replace(asked, reach=self.reach * self.scope.family.frequency_unit)

    @property
    def matrix(self) -> FreeMatrix:
        """Whose determinant vanishes where roots are."""
        return self.scope.matrix

    @property
    def room(self) -> Room:
        """Where tubes may stand."""
        low, high = (float(end[0]) for end in (self.scope.low, self.scope.high))
        return Room(low, high, nextafter(float(self.height), -1.0))

    @property
    def sides(self) -> tuple[Side, ...]:
        """All that has to be looked at: beyond `reach` the contacts are passive on the real axis."""
        if not self.height:
            return (Side(REAL_AXIS, 0.0, float(self.scope.X), "the real axis"),)
        top = Edge(Fraction(0), self.height)
        right = Edge(self.reach, Fraction(0), down=True)
        return (
            Side(top, 0.0, float(self.reach), "the upper side of the region"),
            Side(right, -float(self.height), 0.0, "the side of the region"),
        )


def region_of(scope: Scope, asked: object = None) -> Region:
    """None: below the cuts. "unstable": Im q < 0. ("below", h): up to a height in the problem's units, rounded down
    to a float in scaled ones, as boxes stand on it.

    OpenError where no frequency is found beyond which contacts are passive; InputError for a height at the cuts.
    """
    reach = Fraction(max(float(scope.X), _LEAST_REACH))
    if asked == "unstable":
        return Region(scope, Fraction(0), reach)
    if asked is None:
        return Region(scope, _default(scope.family), reach)
    if isinstance(asked, tuple) and len(asked) == 2 and asked[0] == "below":
        height = rational(asked[1], "region")
        if height > 0:
            scaled = Fraction(float_beside(height / scope.family.frequency_unit, up=False))
            if not _below_cuts(scope.family, scaled):
                stated = f"reaches up to {shown(height)}, which is not proved to lie below all cuts of the range"
                raise InputError("region", f"{stated}: give a smaller height")
            return Region(scope, scaled, reach)
    raise InputError(
        "region", f'is {str(asked)[:60]!r}: give "unstable", "sheet", ("below", h) with h above 0, or None'
    )


def _default(family: Family) -> Fraction:
    low = min(lowest_cut(problem.track)[0] for problem in _points(family))
    if low <= 0:
        return Fraction(0)
    whole = default_height(family.base, low) / family.frequency_unit
    return next((whole * share for share in _SHARES if _below_cuts(family, whole * share)), Fraction(0))


def _points(family: Family) -> list[Problem]:
    if not _moving(family):
        return [family.problem]
    return [family.at([a + share * (b - a) for a, b in family.box]) for share in map(Fraction, ("0", "1/2", "1"))]


def _moving(family: Family) -> bool:
    return any(any(e) for c in family.D_rest.values() for e, _ in c)


def _below_cuts(family: Family, height: Fraction) -> bool:
    """Whether Im Ω > height for all waves of all tracks: D(ip, s − height) has its roots in Re s < 0."""
    if not _moving(family):
        return height < lowest_cut(family.problem.track)[0] / family.frequency_unit
    try:
        require_stable_track(replace(family, D_rest=moved_in_s(family.D_rest, -height)))
    except InputError:
        return False
    return True
