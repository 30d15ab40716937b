"""The edge of the cut of a beam whose loads stand still, past its branch points (SPEC2, at rest).

Points are numbers u: in s, of which all is a function without branch points, the edge runs from −u on the real axis
to 0, where T ≥ 0 up the imaginary axis as iu, and on along Re s² = −T/EI. The turn of Δ̂ is told by discs of s over
the image of a piece, on both halves of the sheet at once.
"""

from __future__ import annotations

from dataclasses import field
from fractions import Fraction
from functools import cached_property
from math import isqrt
from typing import Any

import numpy as np

from mpsolve.characteristic.paths import ROOM
from mpsolve.characteristic.resting import Resting
from mpsolve.errors import PrecisionError
from mpsolve.frozen import frozen
from mpsolve.numbers.jets import UP, U
from mpsolve.problem.line import Line
from mpsolve.proof.cover import cover, joined
from mpsolve.proof.effort import Effort
from mpsolve.proof.turning import pivot_arguments, regular

_BITS = 190  # of the points of z
_WIDER = 1 + 2.0**-11
_AHEAD = (0.06, 0.015, 0.004, 1e-3, 1e-4, 1e-5)  # of z: how far beyond the last branch point the other pieces begin
_SPAN = 3.0  # of |s| times the distances there, where one of these allows it
_LEAST = 44  # halvings of the first piece: 2^−44 is as close to a branch point as a point of z can be told
_SMALLEST = 2.0**-60


@frozen
class Rest:
    """z: exact points on the edge, from the gap to beyond the branch points; turns: of both halves, with errors."""

    z: tuple[Fraction, ...]
    height: Fraction
    u: Any = field(compare=False)
    turns: tuple[tuple[float, float], ...] = field(compare=False)
    halves: tuple[Resting, ...] = field(compare=False, repr=False)

    @property
    def closest(self) -> float:
        """The least |u|."""
        return float(np.abs(self.u).min())

    @property
    def pieces(self) -> int:
        return len(self.z) - 1


@frozen
class Edge:
    """The edge of the cut by u, in s and z."""

    halves: tuple[Resting, ...]
    room: float

    @cached_property
    def beam(self) -> tuple[Fraction, Fraction, Fraction, Fraction]:
        return self.halves[0].beam

    def z(self, u: float) -> Fraction:
        """z of u, rounded where it is no float that was asked for."""
        EI, A, k, m = self.beam
        w = (A - (Fraction(u) ** 2 if u > 0 else -(Fraction(u) ** 2))) / 2
        square = (k - EI * w * abs(w)) / m
        if square <= 0:
            raise PrecisionError("a point before the cut lies beyond z = 0")
        return Fraction(isqrt(square.numerator * 4**_BITS // square.denominator), 2**_BITS)

    def u(self, z: Fraction) -> float:
        """u of a z beyond the branch points."""
        EI, A, k, m = self.beam
        square = float(A) + 2 * np.sqrt(float((m * z * z - k) / EI))
        return float(np.copysign(np.sqrt(abs(square)), square))

    def s(self, u: Any) -> Any:
        A = float(self.beam[1])
        w = (A - np.sign(u) * u * u) / 2
        return np.where(w >= 0, np.where(u < 0, -u + 0j, 1j * u), np.sqrt(np.where(w < 0, -2j * w - A, 1)))

    def discs(self, a: Any, b: Any) -> tuple[Any, Any]:
        """Middles and radii in s that hold the image of the pieces."""
        A = float(self.beam[1])
        s, t = self.s(a), self.s(b)
        m = (s + t) / 2
        r = np.maximum(np.abs(s - m), np.abs(t - m))
        corner = np.copysign(np.sqrt(abs(A)), A)  # of u: beyond it Re s² is constant
        corners = [(corner, self.s(np.array(corner)))] + ([(0.0, 0j)] if A >= 0 else [])
        for u, at in corners:
            r = np.where((a < u) & (u < b), np.maximum(r, np.abs(at - m)), r)
        if A:
            low, high = (np.maximum(0, (np.sign(u) * u * u - A) / 2) for u in (a, b))
            middle, least = np.sqrt(1j * (low + high) - A), np.abs(np.sqrt(2j * low - A))
            arc = np.abs(middle - m) + (high - low) / 2 / least
            r = np.where(high > 0, np.maximum(r, arc), r)
        return m, r * _WIDER * UP + self.lost(m)

    def lost(self, s: Any) -> Any:
        return 64 * U * (np.abs(s) + abs(float(self.beam[1])) ** 0.5)

    def passed(self, a: Any, b: Any) -> Any:
        m, r = self.discs(a.real, b.real)
        with np.errstate(all="ignore"):
            return np.all([regular(half.over(m, r * self.room)).good for half in self.halves], axis=0)

    def turn(self, half: Resting, u: Any) -> tuple[float, float]:
        """The change of arg Δ̂ along the pieces, and a bound of its error; PrecisionError where it is not sharp."""
        with np.errstate(all="ignore"):
            piece, s = regular(half.over(*self.discs(u[:-1], u[1:]))), self.s(u)
            at = half.over(s, self.lost(s))
            first, lost, sharp = pivot_arguments(piece, at.take(np.arange(len(u) - 1)))
            last, lost_too, sharp_too = pivot_arguments(piece, at.take(np.arange(1, len(u))))
        if not (piece.good & sharp & sharp_too).all():
            raise PrecisionError("the pieces next to the branch points of the cuts are not told sharply enough")
        turn = (last - first).sum() - (1 if half.single else 2) * np.angle(s[-1]) - np.pi / 2  # of s and of π
        return float(turn), float((lost + lost_too).sum() + 1e-9)


def past_branch_points(line: Line, effort: Effort, room: float = ROOM) -> Rest:
    """The way past them, from as far before them as the first disc reaches; PrecisionError where none is found."""
    halves = (Resting(line.lower), *([Resting(line.upper)] if line.height else []))
    edge = Edge(halves, room)
    last = float(max(line.branch_points, key=lambda point: float(point[0]))[0])
    places = line.lower.places
    span = float(places[-1] - places[0])
    ends = [Fraction(float(np.float32(last * (1 + ahead)))) for ahead in _AHEAD]
    fitting = [z for z in ends if abs(edge.s(np.array(edge.u(z)))) * span < _SPAN]
    z = fitting[0] if fitting else ends[-1]
    far = edge.u(z)
    A = float(edge.beam[1])
    gap = min(0.0, -np.sqrt(max(0.0, -A)))
    reach = -float(np.sqrt(2 * np.sqrt(float(edge.beam[2] / edge.beam[0])) - A)) - gap  # of the gap, in u
    steps = 0.5 * reach * 0.5 ** np.arange(_LEAST)
    effort.spend(len(steps))
    good = edge.passed(gap + steps, np.minimum(gap - steps, far))
    if not good.any():
        raise PrecisionError("on one of the sheets at a branch point of the cuts a root may lie too close to it")
    first = float(steps[np.argmax(good)])
    inner = [gap + first, min(gap - first, far)]
    points = cover(np.array(sorted({*inner, far})), edge.passed, effort, _SMALLEST)
    points = joined(points, edge.passed, effort).real
    turns = tuple(edge.turn(half, points) for half in halves)
    exact = (*(edge.z(float(u)) for u in points[:-1]), z)
    return Rest(exact, line.height, points, turns, halves)
