"""All zeros along one side of the cut between two wavenumbers, by a cover of boxes in (p, x̂).

Low wavenumbers come first, so that zeros are found even where the effort does not suffice.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Any

import numpy as np

from mpsolve.cuts.balls import EdgeBalls, InPlane
from mpsolve.cuts.boxes import EdgeMatrix
from mpsolve.errors import PrecisionError
from mpsolve.numbers.arrays import Reals
from mpsolve.numbers.balls import arb, precision
from mpsolve.numbers.reduction import Reduction
from mpsolve.outcome import Reason
from mpsolve.problem.family import Family
from mpsolve.progress import Progress
from mpsolve.proof import planar
from mpsolve.proof.effort import Effort
from mpsolve.proof.ladder import climb
from mpsolve.proof.subdivide import Covered, subdivide
from mpsolve.ranges.judge import Judge, boxes_of

ELSEWHERE = 4
"""Of a box that belongs to the other side of the cut, or to mirror images."""
_BITS, _TRIED = 80, 80
_SMALLEST = 2.0**-32  # of the whole
_INNER = 6.0  # of |p|, scaled
_SIZE = 2.0**-6  # of half the whole: where a zero is looked for round a point


@dataclass(frozen=True)
class Found:
    """A zero: balls of p and x̂, and the box (p, x̂) in which it is the only one."""

    p: arb
    x: arb
    box: tuple[arb, arb]


class Search:
    """The cover of one side; zeros that it meets are enclosed on the way, those of other sides too."""

    def __init__(self, family: Family, side: int, most: float, digits: int) -> None:
        """most: of |p|."""
        ends = tuple(
            math.nextafter(float(x), way) for x, way in zip(family.box[0], (-math.inf, math.inf), strict=True)
        )
        inner = min(most, _INNER)
        self.low, self.high = (np.array([sign * inner, end]) for sign, end in zip((-1, 1), ends, strict=True))
        self.digits, self.most = digits, most
        self.matrix, self.balls = EdgeMatrix(family, side), EdgeBalls(family, side)
        self.judge = Judge(self.matrix, None, (self.high - self.low) / 2, self._enclose, way=1.0)  # type: ignore[arg-type]
        # that there is one zero at most rests on slopes, of what is analytic
        self._rooms = Judge(EdgeMatrix(family, side, meeting=False), None, self.judge.width, way=1.0)  # type: ignore[arg-type]
        self.found: list[Found] = []
        self._failed: list[Any] = []

    def low_wavenumbers(self, budget: Effort, progress: Progress) -> Reason | None:
        """Why the cover of low wavenumbers, where zeros are, is not complete; None: it is."""
        return self._covered(self.low, self.high, budget, progress).reason

    def high_wavenumbers(self, budget: Effort, progress: Progress) -> Reason | None:
        """The same of the rest."""
        inner = float(self.high[0])
        for ends in ((-self.most, -inner), (inner, self.most)) if self.most > inner else ():
            low, high = self.low.copy(), self.high.copy()
            low[0], high[0] = ends
            cover = self._covered(low, high, budget, progress)
            if cover.reason is not None:
                return cover.reason
        return None

    def _covered(self, low: Reals, high: Reals, budget: Effort, progress: Progress) -> Covered:
        return subdivide(low, high, self._judged, budget, _SMALLEST, lambda share: progress("boxes", share))

    def _judged(self, low: Reals, high: Reals) -> tuple[Any, Any]:
        kind = np.where(self.matrix.elsewhere(boxes_of(low, high, way=1.0)), ELSEWHERE, 0).astype(np.int8)
        axis = np.zeros(low.shape[1], np.int8)
        rest = np.flatnonzero(kind == 0)
        if len(rest):
            kind[rest], axis[rest] = self.judge(low[:, rest], high[:, rest])
        return kind, axis

    def _enclose(self, point: Reals, half: Reals) -> bool:
        if any((np.abs(point - other) < 8 * half).all() for other in self._failed):
            return False
        size = self.judge.width * _SIZE
        try:
            with precision(_BITS):
                zero = self._zero(point, size)
            at = np.array([float(zero.p.mid()), float(zero.x.mid())])
            if any(((at >= a) & (at <= b)).all() for a, b in self.judge.known):
                return True
            room = self._rooms.room(at, size * 4)
        except PrecisionError:
            room = None
        if room is None or not _inside(zero, room):
            self._failed.append(point)
            return False
        self.judge.known.append(room)
        self.found.append(zero)
        return True

    def _zero(self, point: Reals, size: Any) -> Found:
        goal = math.ceil(self.digits * math.log2(10)) + 10

        def proved(_: int) -> Found:
            at: planar.Point = (arb(point[0]), arb(point[1]))
            for _turn in range(2):  # the reduction is best made at the zero itself
                f = InPlane(self.balls, Reduction.of(self.balls.matrices(*at)[0], near_root=True))
                at = planar.polished(f, (float(at[0]), float(at[1])))
            zero = planar.isolated(f, at, (arb(size[0]), arb(size[1])))
            p, x = planar.sharpened(f, zero, goal)
            return Found(p, x, zero.box)

        return climb(proved, _BITS, _TRIED)


def _inside(zero: Found, room: tuple[Any, Any]) -> bool:
    parts = zip((zero.p, zero.x), room[0].tolist(), room[1].tolist(), strict=True)
    return all(bool(ball > low) and bool(ball < high) for ball, low, high in parts)
