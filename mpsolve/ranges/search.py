"""A cover of boxes in (q, parameter) along an edge; the zeros that it meets are enclosed on the way."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np

from mpsolve.errors import PrecisionError
from mpsolve.numbers.balls import precision
from mpsolve.progress import Progress
from mpsolve.proof.effort import Effort
from mpsolve.proof.subdivide import Covered, subdivide
from mpsolve.ranges.edge import REAL_AXIS, Edge
from mpsolve.ranges.enclosed import Crossing as Scaled
from mpsolve.ranges.enclosed import enclose
from mpsolve.ranges.judge import Judge
from mpsolve.ranges.scope import Scope

_IN_MIDDLE, _NEAR_MIDDLE = 1e-6, 2.0**-5  # of half an edge


@dataclass
class Search:
    """The cover of a scope with one parameter; zeros that it meets are enclosed on the way.

    side: the edge and the corners in (y, x̂) between which it is looked at, in place of the real axis.
    """

    scope: Scope
    digits: int
    side: tuple[Edge, Any, Any] | None = None

    def __post_init__(self) -> None:
        self.edge, self.low, self.high = self.side or (REAL_AXIS, *self.scope.corners)
        self.judge: Judge = self._judge()
        self.judge.found = self.enclose
        self.found: list[Scaled] = []
        self._failed: list[Any] = []

    def cover(self, budget: Effort, progress: Progress) -> Covered:
        """Of all between the corners."""
        return subdivide(self.low, self.high, self.judge, budget, tell=lambda share: progress("boxes", 0.9 * share))

    def _judge(self) -> Judge:
        if self.edge == REAL_AXIS:
            return self.scope.judge()
        width = (self.high - self.low) / 2
        return Judge(self.scope.matrix, None, width, origin=self.edge.origin, way=self.edge.way)

    def enclose(self, point: Any) -> bool:
        """Enclose the zero near a float point; True where it was."""
        if any((np.abs(point - other) < 2.0**-10 * self.judge.width).all() for other in self._failed):
            return False
        if any(self._enclosed(seed) for seed in self._seeds(point)):
            return True
        self._failed.append(point)
        return False

    def _seeds(self, point: Any) -> list[Any]:
        """What Newton's method begins with: next to the middle of a mirrored edge it is looked for there first."""
        if not self.edge.mirrored:
            return [point]
        right, middle = np.array([abs(point[0]), point[1]]), np.array([0.0, point[1]])
        if right[0] < _IN_MIDDLE * self.judge.width[0]:
            return [middle]
        return [middle, right] if right[0] < _NEAR_MIDDLE * self.judge.width[0] else [right]

    def _enclosed(self, seed: Any) -> bool:
        size = 2 * self.judge.width * 2.0**-6
        try:
            with precision(80):
                place = float(seed[0]), float(seed[1])
                zero = enclose(self.scope.proved, place, tuple(size * 2.0**-6), self.digits, self.edge)
            at = np.array([float(zero.q.mid()), float(zero.x.mid())])
            if any(((at >= a) & (at <= b)).all() for a, b in self.judge.known):
                return bool((np.abs(at - seed) < size).all())
            room = self.judge.room(at, size * 4)
        except PrecisionError:
            return False
        if room is None or not _holds(room, zero):
            return False
        self.judge.known.append(room)
        self.found.append(zero)
        return True


def _holds(room: tuple[Any, Any], zero: Scaled) -> bool:
    return all(
        bool(ball > low) and bool(ball < high)
        for ball, low, high in zip((zero.q, zero.x), room[0].tolist(), room[1].tolist(), strict=True)
    )
