"""A small loop round a branch point and the ways to it, in coordinates about that point.

Light masses, and loads next to the velocity at which the cuts join, have roots closer to a branch point than floats
of q tell. Loop and ways are those of SPEC2 8.4; only the numbers that they are computed with count from the point.
"""

from __future__ import annotations

from dataclasses import field, replace
from fractions import Fraction
from math import log2
from typing import Any

import numpy as np

from mpsolve.characteristic.discs import split
from mpsolve.characteristic.local import LocalArrays, same_pair
from mpsolve.characteristic.path import Kind, Path
from mpsolve.characteristic.paths import Paths
from mpsolve.errors import PrecisionError
from mpsolve.frozen import frozen
from mpsolve.numbers.arrays import Complexes
from mpsolve.numbers.jets import UP, U
from mpsolve.problem.reduced import Reduced
from mpsolve.proof.cover import OpenPieceError
from mpsolve.proof.effort import Effort

_PER_OCTAVE = 1.5  # points of a way that is planned
_PART = 12  # points of a way that are planned together
_SHORT = 2**120  # the branch point is rounded to a whole number of this part


@frozen
class Ways:
    """From `first` to a loop of this radius round z, and from it to `last`: points t stand for z + t.

    first and last are floats, at the ends of both ways. turn: the change of arg Δ̂ along both, and its error. linked:
    on the first way the splitting alone is followed, as Δ̂ may have roots on it.
    """

    near: LocalArrays = field(compare=False, repr=False)
    linked: bool
    first: float
    last: float
    before: Complexes
    behind: Complexes
    turn: tuple[float, float]

    @property
    def z(self) -> Fraction:
        """The branch point."""
        return self.near.z

    @property
    def ends(self) -> tuple[Complexes, Complexes]:
        """The points of both ways that count from z: all but `first` and `last`."""
        return self.before[1:], self.behind[:-1]

    @property
    def pieces(self) -> int:
        return len(self.before) + len(self.behind) - 2


def about(reduced: Reduced, z: Fraction, pole: complex | None) -> LocalArrays:
    """The same problem about the branch point z, and about the pair of p-roots that meets there."""
    z = Fraction(z.numerator * _SHORT // z.denominator, _SHORT)
    return LocalArrays(reduced, z, Fraction(pole.imag) if pole is not None else Fraction(0))


def ways_to(paths: Paths, near: LocalArrays, radius: float, reach: float, linked: bool, effort: Effort) -> Ways:
    """Ways from and to the distance `reach` of the branch point; PrecisionError where they are not proved."""
    first, last = (float(np.float32(float(near.z) + sign * reach)) for sign in (-1, 1))
    if not all(same_pair(paths.arrays, near, q, paths.up) for q in (first, last)):
        raise PrecisionError("the splittings about a branch point do not join on to those further away")
    before, behind = (_spread(float(Fraction(q) - near.z), radius) for q in (first, last))
    at = before[:1]
    begin = split(near.D, 1j * at, 2.0**-50 * np.abs(at), paths.up)
    local = Paths(near, replace(paths.start, splitting=begin), paths.room)
    both = (
        _planned(local, "link" if linked else "turn", before, effort),
        _planned(local, "turn", behind[::-1], effort),
    )
    proved = local.prove(both, effort, (complex(before[0]), complex(radius)))
    (a, lost), (b, lost_too) = proved.turns
    turn = (a + b, (lost + lost_too + 4 * U * (abs(a) + abs(b))) * UP)
    return Ways(near, linked, first, last, proved.paths[0].points, proved.paths[1].points, turn)


def _planned(local: Paths, kind: Kind, points: Complexes, effort: Effort) -> Path:
    """Each part by itself: what is too short for a piece is told by the length of a part."""
    found = [points[:1]]
    try:
        for at in range(0, len(points) - 1, _PART):
            found.append(local.plan(kind, points[at : at + _PART + 1], effort).points[1:])
    except OpenPieceError as error:
        raise OpenPieceError(error.place + float(local.arrays.z), error.length) from None  # type: ignore[attr-defined]
    return Path(kind, np.concatenate(found))


def _spread(far: float, radius: float) -> Any:
    """Points from `far` to the radius on the same side, each closer by about the same factor."""
    count = max(2, int(log2(abs(far) / radius) * _PER_OCTAVE) + 1)
    out = np.geomspace(abs(far), radius, count).astype(np.float32).astype(float) * np.sign(far)
    out[0], out[-1] = far, np.sign(far) * radius
    return out + 0j
