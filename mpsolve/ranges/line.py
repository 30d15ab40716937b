"""All crossings of a line Im q = h by roots, over a range of one parameter: real roots of a shifted family.

For h ≤ 0 the shifted vehicle and track are passive (`problem.shifted`), so that the contacts' passivity bounds the
frequency at which a root can cross. For h > 0 vehicles are not: roots with Im q ≥ 0 are then spoken of as far as
|Re q| < reach only, and what could come in there, through the wall Re q = reach, is excluded too. Beyond the reach
no root is real, as far as the contacts are not passive, and further out as they are. So the number of roots in

    {Im q < 0} ∪ {Im q < h, |Re q| < reach}

changes with the parameter at the crossings of the line alone. Between them the lowest root is followed through boxes,
and proved to be lowest at one point.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from fractions import Fraction
from math import inf, nextafter
from typing import Any

import numpy as np

from mpsolve.errors import InputError
from mpsolve.numbers.balls import arb, precision, rational_ball
from mpsolve.outcome import Reason
from mpsolve.problem.family import Family
from mpsolve.problem.shifted import shifted
from mpsolve.progress import Progress
from mpsolve.proof.effort import Effort
from mpsolve.proof.subdivide import Covered, subdivide
from mpsolve.ranges.answer import within
from mpsolve.ranges.bend import is_convex
from mpsolve.ranges.branch import Tube, tube
from mpsolve.ranges.enclosed import Crossing
from mpsolve.ranges.judge import Judge
from mpsolve.ranges.premises import require_stable_track
from mpsolve.ranges.scope import OpenError, Scope
from mpsolve.ranges.search import Search
from mpsolve.ranges.stationary import Candidate
from mpsolve.tracks.at_rest import lowest_cut


@dataclass(frozen=True)
class Line:
    """The crossings (scaled, in ascending order) of Im q̂ = height; reason: why the list may not be complete."""

    scope: Scope
    height: Fraction
    covers: tuple[Covered, ...]
    crossings: tuple[Crossing, ...]
    known: tuple[Any, ...]
    reason: Reason | None = None

    @property
    def reach(self) -> float | None:
        """As far as which roots with Im q̂ ≥ 0 are spoken of; None where there is no limit."""
        return self.scope.reach


def cross_line(
    family: Family,
    height: Fraction,
    reach: float | None,
    near: list[tuple[float, float]],
    budget: Effort,
    progress: Progress,
) -> Line:
    """All roots of a family on the line; `OpenError` where nothing bounds them.

    reach: for a height above 0, how far roots with Im q ≥ 0 are spoken of. near: points (Re q̂, x̂) where crossings are
    expected; they are enclosed first, which saves boxes.
    """
    moved = shifted(family, -height)
    if height > 0:
        require_below_cuts(family, moved, height)
    scope = Scope(moved, reach if height > 0 else None)
    search = Search(scope, 15)
    search.enclose_near(near)
    covers = [search.cover(budget, progress)]
    if scope.reach is not None:
        covers += _beside(Scope(family), height, scope.reach, budget)
    reason, inside = next((one.reason for one in covers if one.reason is not None), None), []
    for one in search.found:
        where = within(one.x, family.box[0])
        if where is None and reason is None:
            reason = Reason(
                "end", "a root crosses a line at an end of the range", {}, "give a range that ends elsewhere"
            )
        if where:
            inside.append(one)
    inside.sort(key=lambda one: float(one.x.mid()))
    return Line(scope, height, tuple(covers), tuple(inside), tuple(search.judge.known), reason)


def require_below_cuts(family: Family, moved: Family, height: Fraction) -> None:
    """`OpenError` unless no cut comes below the height for any parameter of the range."""
    if any(any(e) for c in family.D_rest.values() for e, _ in c):
        try:
            require_stable_track(moved)
        except InputError as error:
            raise OpenError(Reason("cuts", f"the lowest root lies near the cuts: {error}", {}, "")) from None
    elif not height * family.frequency_unit < lowest_cut(family.problem.track)[0]:
        raise OpenError(Reason("cuts", "the lowest root lies at the cuts", {}, "give another range"))


def _beside(axis: Scope, height: Fraction, reach: float, budget: Effort) -> list[Covered]:
    """No root has Re q̂ = reach, 0 ≤ Im q̂ ≤ height; nor is one real from there on, as far as it takes."""
    low, high = np.concatenate([[0.0], axis.low]), np.concatenate([[float(height)], axis.high])
    wall = Judge(axis.matrix, None, (high - low) / 2, origin=1j * reach, way=-1.0)
    out = [subdivide(low, high, wall, budget)]
    if reach < axis.X:
        low, high = axis.corners
        out.append(subdivide(np.concatenate([[reach], low[1:]]), high, axis.judge(), budget))
    return out


_TUBES = (1, 4, 16, 64, 256)
"""Numbers of boxes in which a root is followed."""


def stretch(line: Line, number: int) -> tuple[arb, arb] | None:
    """Where `number` roots are below the line together, from one ball of x̂ to another; None where that is not all.

    The ends of the range count as crossings where the roots are below it there.
    """
    changes = [one.gained for one in line.crossings]
    if changes not in ([number, -number], [number], [-number], []):
        return None
    low, high = map(rational_ball, line.scope.family.box[0])
    return (
        line.crossings[0].x if changes[:1] == [number] else low,
        line.crossings[-1].x if changes[-1:] == [-number] else high,
    )


def follow(line: Line, found: Candidate, ends: tuple[arb, arb]) -> Tube | None:
    """The root, followed from one end to the other while it is below the line: lowest at one point, proved."""
    path = _path(line, found)
    for number in _TUBES:
        with precision(80):
            middles = [ends[0] + (ends[1] - ends[0]) * k / number for k in range(1, number)]
            edges = [ends[0], *(arb(x.mid()) for x in middles), ends[1]]
        x = np.interp(np.arange(2 * number + 1) / 2, np.arange(number + 1), [float(edge) for edge in edges])
        got = tube(line.scope.matrix, path(x), edges)
        if got is None or not all(got.holds(one.q, one.x) for one in line.crossings):
            continue
        if _is_lowest(got, line, found, path, number == _TUBES[-1]):
            return got
    return None


def _is_lowest(followed: Tube, line: Line, found: Candidate, path: Callable[[Any], Any], last: bool) -> bool:
    """Whether the root is lowest at the end, or falls, is convex, and rises. last: take pains."""
    if found.where != "inside":
        return followed.rises if found.where == "start" else followed.falls
    valley = followed.valley
    if valley is None:
        return False
    if followed.bends_up(*valley):
        return True
    low, high = followed.parts[valley[0]].ends[0], followed.parts[valley[1] - 1].ends[1]
    if not last or not (low < arb(found.x) and arb(found.x) < high):
        return False
    ends = (nextafter(float(low.lower()), -inf), nextafter(float(high.upper()), inf))
    return is_convex(line.scope.matrix, line.scope.proved, path, *ends, found.first[0])


def _path(line: Line, found: Candidate) -> Callable[[Any], Any]:
    """About the root (seen from the line) at floats x̂: its Taylor polynomial, made to meet the crossings."""
    here, height = float(found.x), float(line.height)
    powers, lacks = [], []
    for one in line.crossings:
        step = float(one.x.mid()) - here
        powers.append([step**k for k in range(3, 3 + len(line.crossings))])
        lacks.append(float(one.q.mid()) + 1j * height - found.beside(step)[0])
    more = np.linalg.lstsq(np.array(powers), np.array(lacks), rcond=None)[0] if powers else ()

    def path(x: Any) -> Any:
        step = x - here
        higher = sum(c * step**k for k, c in enumerate(more, 3))
        return found.beside(step)[0] + higher - 1j * height

    return path
