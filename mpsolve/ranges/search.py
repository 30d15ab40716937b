"""A cover of boxes in (q, parameter) along an edge; the zeros that it meets are enclosed on the way."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from mpsolve.errors import PrecisionError
from mpsolve.numbers.arrays import Reals
from mpsolve.numbers.balls import precision
from mpsolve.progress import Progress
from mpsolve.proof.effort import Effort
from mpsolve.proof.subdivide import FEW, Covered, subdivide
from mpsolve.ranges.edge import REAL_AXIS, Edge
from mpsolve.ranges.enclosed import Crossing as Scaled
from mpsolve.ranges.enclosed import enclose
from mpsolve.ranges.judge import Judge
from mpsolve.ranges.leaning import LeaningJudge
from mpsolve.ranges.scope import Scope

_HINT = 2.0**-13  # of half of the whole: how near a zero is to where it is expected
_TINY = 2.0**-20  # the same, of boxes that show a zero for which pains are taken
_NEXT_TO_ZERO = 2.0**-8  # of half an edge
_FEW = 24  # boxes judged at once where a verifier follows, which takes longer for a leaf than they for a box
_SMALLEST = 2.0**-40  # of the whole: heavy masses have crossings at frequencies so low that rooms are this small


@dataclass
class Search:
    """The cover of a scope with one parameter; zeros that it meets are enclosed on the way.

    side: the edge and the corners in (y, x̂) between which it is looked at, in place of the real axis.
    """

    scope: Scope
    digits: int
    side: tuple[Edge, Reals, Reals] | None = None

    def __post_init__(self) -> None:
        self.edge, self.low, self.high = self.side or (REAL_AXIS, *self.scope.corners)
        self.judge: Judge = self._judge()
        self.judge.found = self.enclose
        self.found: list[Scaled] = []
        self._failed: list[Any] = []

    def cover(self, budget: Effort, progress: Progress, check: bool = False) -> Covered:
        """Of all between the corners. check: a verifier will work through the leaves, so fewer are worth more."""
        tell = lambda share: progress("boxes", 0.9 * share)  # noqa: E731
        low, high = (np.append(end, 0.0) for end in (self.low, self.high))
        return subdivide(low, high, self.judge, budget, _SMALLEST, tell, _FEW if check else FEW)

    def enclose_near(self, points: Sequence[tuple[float, float]]) -> None:
        """Enclose the zeros near points (y, x̂), where they are."""
        for point in points:
            self.enclose(np.array(point), self.judge.width * _HINT)

    def _judge(self) -> Judge:
        if self.edge == REAL_AXIS:
            return self.scope.judge(LeaningJudge)
        width, begins = (self.high - self.low) / 2, float(self.low[0])
        # along a slope boxes reach beyond the ends of an edge: where it goes down that may be above cuts
        kind = Judge if self.edge.down else LeaningJudge
        return kind(self.scope.matrix, None, width, origin=self.edge.origin, way=self.edge.way, begins=begins)

    def enclose(self, point: Reals, half: Reals) -> bool:
        """Enclose the zero near a float point; True where it was. Next to q = 0 it is first looked for there.

        half: of the box that shows it: where this failed it is tried again from much smaller boxes only.
        """
        if any((np.abs(point - other) < 8 * half).all() for other in self._failed):
            return False
        y = abs(float(point[0])) if self.edge.mirrored else float(point[0])
        seeds = [y]
        if self.edge.mirrored and y < _NEXT_TO_ZERO * self.judge.width[0]:
            seeds.insert(0, 0.0)
        pains = bool((half < self.judge.width * _TINY).all())
        if any(self._enclosed((q, float(point[1])), pains) for q in seeds):
            return True
        self._failed.append(point)
        return False

    def _enclosed(self, seed: tuple[float, float], pains: bool) -> bool:
        size = 2 * self.judge.width * 2.0**-6
        if seed[0] and self.edge.mirrored:
            size = size * np.minimum(1.0, seed[0] / size[0])
            size[1] = min(size[1], abs(seed[1]) or np.inf)  # a range may reach from light masses to heavy ones
        try:
            with precision(80):
                zero = enclose(self.scope.proved, seed, tuple(size * 2.0**-6), self.digits, self.edge, pains)
            at = np.array([float(zero.q.mid()), float(zero.x.mid())])
            if any(((at >= a) & (at <= b)).all() for a, b in self.judge.known):
                return True
            room = self.judge.room(at, size * 4)
        except PrecisionError:
            return False
        if room is None or not _holds(room, zero) or not self._asked(room):
            return False
        self.judge.known.append(room)
        self.found.append(zero)
        return True

    def _asked(self, room: tuple[Any, Any]) -> bool:
        """Whether some of the room is to be covered: Newton's method may lead far away."""
        return bool((room[0] <= self.high).all() and (room[1] >= self.low).all())


def _holds(room: tuple[Any, Any], zero: Scaled) -> bool:
    return all(
        bool(ball > low) and bool(ball < high)
        for ball, low, high in zip((zero.q, zero.x), room[0].tolist(), room[1].tolist(), strict=True)
    )
