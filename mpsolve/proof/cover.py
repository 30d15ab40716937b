"""Covering a path by pieces that each pass a test: all open pieces are tried at once, those that fail are halved."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np

from mpsolve.errors import PrecisionError
from mpsolve.proof.effort import Effort

Test = Callable[[Any, Any], Any]
"""(starts, ends) → which pieces pass."""
Middle = Callable[[Any, Any], Any]
"""(starts, ends) → the points at which pieces are halved."""


class OpenPieceError(PrecisionError):
    """A piece passes its test at no length; `place` is its middle."""

    def __init__(self, place: complex, length: float) -> None:
        super().__init__(f"pieces of the path shorter than {length:.2g} do not pass near {place:.6g}")
        self.place, self.length = place, length


def midpoints(a: Any, b: Any) -> Any:
    """The middles of straight pieces, rounded."""
    return (a + b) / 2


def cover(points: Any, test: Test, effort: Effort, smallest: float = 2.0**-40, middle: Middle = midpoints) -> Any:
    """The break points of a refinement of the polyline through `points` (complex) whose pieces all pass.

    Pieces stay in order, so the result runs through all `points`. `smallest` is relative to the length of the path.
    Raises OpenPieceError where halving does not help, EffortError where the effort is spent.
    """
    points = np.asarray(points, complex)
    length = float(np.abs(np.diff(points)).sum())
    passed = np.zeros(len(points) - 1, bool)
    while not passed.all():
        a, b = points[:-1][~passed], points[1:][~passed]
        effort.spend(len(a))
        found = np.array(test(a, b), bool)
        passed[~passed] = found
        a, b = a[~found], b[~found]
        short = np.abs(b - a) < smallest * length
        between = middle(a, b)
        short |= (between == a) | (between == b)
        if short.any():
            raise OpenPieceError(complex((a[short][0] + b[short][0]) / 2), smallest * length)
        points, passed = halved(points, passed, between)
    return points


def halved(points: Any, passed: Any, between: Any) -> tuple[Any, Any]:
    """The points with those `between` put into the pieces that have not passed, and which pieces have."""
    at = np.flatnonzero(~passed) + 1
    return np.insert(points, at, between), np.insert(passed, at, np.zeros(len(at), bool))
