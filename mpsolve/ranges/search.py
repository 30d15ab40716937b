"""A cover of boxes in (q, parameter) along an edge; the zeros that it meets are enclosed on the way.

Next to the curve on which two waves, one ahead and one behind, all but meet, boxes may be laid along it: the
receptance varies there as quickly as there is little damping, across, but not along. With D(P, σ, x) = 0 = D_P at
their meeting point the curve has the slope dσ/dx = −D_x/D_σ. It chooses; nothing rests on it.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from mpsolve.errors import PrecisionError
from mpsolve.numbers.arrays import Complexes, Reals
from mpsolve.numbers.balls import precision
from mpsolve.numbers.float64 import gaps
from mpsolve.numbers.quadratic import Quadratic
from mpsolve.progress import Progress
from mpsolve.proof.effort import Effort
from mpsolve.proof.sheared import rounded
from mpsolve.proof.subdivide import FEW, Covered, subdivide
from mpsolve.ranges.enclosed import REAL_AXIS, Edge, enclose
from mpsolve.ranges.enclosed import Crossing as Scaled
from mpsolve.ranges.judge import Judge
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


_LEAST, _MOST = 0.25, 1.5  # of what x moves beside what q does, for boxes that are laid along
_LEFT = 0.15  # of it that may be left, by bends and by what no real slope takes away
_NEAR = 1.5  # boxes away from the curve
_APART = 4.0  # times the distance of the two p-roots: how far others must be


class LeaningJudge(Judge):
    """Of a family of one parameter, and boxes with a row of slopes; says which are to get another slope."""

    def __call__(self, low: Any, high: Any) -> tuple[Any, ...]:
        kind, axis, _ = self.judged(low, high)
        slope = np.full(len(kind), np.nan)
        rows = np.flatnonzero(kind == 0)
        if len(rows) and 0 < self.matrix.receptance.track.up < self.matrix.family.degree:
            slope[rows] = self._slopes(low[:, rows], high[:, rows])
        return kind, axis, slope

    def _slopes(self, low: Reals, high: Reals) -> Reals:
        boxes, track = self.boxes(low, high), self.matrix.receptance.track
        y, rho = boxes.variables
        with np.errstate(all="ignore"):
            D = track.D(y, rho)
            z, _ = track.nodes(D)
            more = _more(D, z, track.up) * boxes.r[0] / boxes.r[1]
            return np.where(np.isfinite(more), rounded(low[-1] + more, low, high), np.nan)


def _more(D: Quadratic, z: Complexes, up: int) -> Reals:
    """By how much u₀ should move with u₁; nan where that helps little."""
    gap = np.abs(z[:, :up, None] - z[:, None, up:])
    flat = gap.reshape(len(z), -1)
    rows, pair = np.arange(len(z)), flat.argmin(1)
    P = (z[rows, pair // gap.shape[2]] + z[rows, up + pair % gap.shape[2]]) / 2
    alone = np.sort(gaps(z).reshape(len(z), -1), 1)[:, 2] > _APART * flat[rows, pair]
    n = np.arange(D.k.shape[-1])
    power = P[:, None] ** n
    a, b0, b1, c00, c01, c11 = (D.k * power).sum(-1)
    slope = (D.k[:3, :, 1:] * n[1:] * power[:, :-1]).sum(-1)
    turn = 2 * (D.k[0, :, 2:] * (n * (n - 1))[2:] * power[:, :-2]).sum(-1)
    more = (-b1 / b0).real
    along = slope[2] + more * slope[1]
    left = np.abs(b1 + more * b0) + np.abs(c11 + more * c01 + more**2 * c00 - along**2 / turn)
    share = np.abs(more)
    fine = alone & (share > _LEAST) & (share < _MOST) & (left < _LEFT * share * np.abs(b0))
    near = np.abs(a - slope[0] ** 2 / turn) < _NEAR * (np.abs(b0) + np.abs(b1))
    return np.where(fine & near, more, np.nan)
