"""The lowest root between its crossings of a line: followed through boxes, and proved to be lowest at one point."""

from __future__ import annotations

from collections.abc import Callable
from math import inf, nextafter
from typing import Any

import numpy as np

from mpsolve.numbers.balls import arb, precision, rational_ball
from mpsolve.ranges.bend import is_convex
from mpsolve.ranges.branch import Tube, tube
from mpsolve.ranges.line import Line
from mpsolve.ranges.stationary import Candidate

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
