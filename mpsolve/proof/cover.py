"""Covering a path by pieces that each pass a test: all open pieces are tried at once, those that fail are halved.

Then there are fewer pieces than halving leaves: neighbours are joined where both together pass as one, and break
points are moved so that all pieces are equally hard.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from itertools import pairwise
from typing import Any

import numpy as np

from mpsolve.errors import PrecisionError
from mpsolve.numbers.arrays import Complexes, Reals, Truths
from mpsolve.proof.effort import Effort

Test = Callable[[Any, Any], Any]
"""(starts, ends) → which pieces pass."""
Middle = Callable[[Any, Any], Any]
"""(starts, ends) → the points at which pieces are halved."""


_SPARE = 1.02  # of the pieces that are needed by what each of them costs


class OpenPieceError(PrecisionError):
    """A piece passes its test at no length; `place` is its middle."""

    def __init__(self, place: complex, length: float) -> None:
        super().__init__(f"pieces of the path shorter than {length:.2g} do not pass near {place:.6g}")
        self.place, self.length = place, length


def midpoints(a: Any, b: Complexes) -> Any:
    """The middles of straight pieces, rounded."""
    return (a + b) / 2


def cover(points: Any, test: Test, effort: Effort, smallest: float = 2.0**-40, middle: Middle = midpoints) -> Any:
    """The break points of a refinement of the polyline through `points` (complex) whose pieces all pass.

    Pieces stay in order, so the result runs through all `points`. `smallest` is relative to the length of the path.
    Raises OpenPieceError where halving does not help, EffortError where the effort is spent.
    """
    return covered([points], test, effort, smallest, middle)[0]


def covered(
    parts: Sequence[Any], test: Test, effort: Effort, smallest: float = 2.0**-40, middle: Middle = midpoints
) -> list[Any]:
    """Each of several polylines as by `cover`, pieces of all tried at once."""
    if not parts:
        return []
    points, ends = np.concatenate(parts).astype(complex), np.cumsum([len(part) for part in parts])[:-1]
    gaps = np.isin(np.arange(1, len(points)), ends)  # from part to part
    length = float(np.abs(np.diff(points))[~gaps].sum())
    passed = gaps
    while not passed.all():
        a, b = points[:-1][~passed], points[1:][~passed]
        effort.spend(len(a))
        found = np.array(test(a, b), bool)
        passed = passed.copy()
        passed[~passed] = found
        a, b = a[~found], b[~found]
        short = np.abs(b - a) < smallest * length
        between = middle(a, b)
        short |= (between == a) | (between == b)
        if short.any():
            raise OpenPieceError(complex((a[short][0] + b[short][0]) / 2), smallest * length)
        gaps = np.insert(gaps, np.flatnonzero(~passed) + 1, np.zeros(len(a), bool))
        points, passed = halved(points, passed, between)
    return np.split(points, np.flatnonzero(gaps) + 1)


def halved(points: Complexes, passed: Truths, between: Complexes) -> tuple[Complexes, Truths]:
    """The points with those `between` put into the pieces that have not passed, and which pieces have."""
    at = np.flatnonzero(~passed) + 1
    return np.insert(points, at, between), np.insert(passed, at, np.zeros(len(at), bool))


def joined(points: Complexes, test: Test, effort: Effort, anywhere: bool = False, rounds: int = 2) -> Complexes:
    """The points of a path without those between two pieces that pass as one.

    Only points whose two neighbours lie with them on one line parallel to an axis are left out, so the path stays
    where it is. anywhere: any point but the ends may be left out, so the path may leave its corners.
    A point that stays is not tried again, as the pieces beside it only grow.
    """
    points = np.asarray(points, complex)
    open_ = np.ones(len(points), bool)
    for _ in range(rounds):
        candidates = np.flatnonzero(open_[1:-1] & (_inner(points) | anywhere)) + 1
        if not len(candidates):
            break
        chosen = [candidates[0]]
        for k in candidates[1:]:
            if k > chosen[-1] + 1:
                chosen.append(k)
        at = np.array(chosen)
        effort.spend(len(at))
        passed = np.array(test(points[at - 1], points[at + 1]), bool)
        open_[at[~passed]] = False
        kept = np.ones(len(points), bool)
        kept[at[passed]] = False
        points, open_ = points[kept], open_[kept]
    return points


def evened(points: Complexes, hardness: Reals) -> Complexes:
    """Points on the same polyline so that each piece would have a hardness of about 1, were it its length.

    hardness: one number > 0 for each piece. Corners are kept; straight parts that are not parallel to an axis are
    left as they are, since points on them would be rounded off the line.
    """
    out = [points[:1]]
    for first, last in _parts(points):
        part, cost = points[first : last + 1], hardness[first:last]
        count = int(np.ceil(cost.sum() * _SPARE))
        if (part.real == part[0].real).all() | (part.imag == part[0].imag).all():
            at = np.concatenate([[0.0], np.cumsum(cost)])
            where = np.linspace(0, at[-1], count + 1)
            inner = np.interp(where, at, part.real) + 1j * np.interp(where, at, part.imag)
            part = np.concatenate([part[:1], inner[1:-1], part[-1:]])
        out.append(part[1:])
    return np.concatenate(out)


def _ways(points: Complexes) -> Any:
    """Of each piece the signs of both coordinates as one number; ±2 and ±4 are oblique."""
    way = np.sign(np.diff(points).real) + 3 * np.sign(np.diff(points).imag)
    return way.astype(int)


def _inner(points: Complexes) -> Any:
    """Which points but the ends lie on one line parallel to an axis with the points beside them, and between them."""
    way = _ways(points)
    return (way[1:] == way[:-1]) & np.isin(np.abs(way[1:]), (0, 1, 3))


def _parts(points: Complexes) -> list[tuple[int, int]]:
    """(first, last) of the parts along which both coordinates go one way."""
    cuts = [0, *(np.flatnonzero(np.diff(_ways(points))) + 1).tolist(), len(points) - 1]
    return list(pairwise(cuts))
