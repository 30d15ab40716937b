"""How many zeros a region holds: the turn of f along its boundary, in pieces over each of which it turns by less
than a half.

f is a product of parts g, and turns by the sum of their turns: below, f is one of them.

For z on a piece from a to b, f(z) = f(a) + (z − a) D with D in the ball of f′ over the piece: with
E = (b − a)D/f(a), f(z)/f(a) = 1 + tE, t from 0 to 1. If Re E > −1, or Im E ≠ 0, throughout, then f has no zero on the
piece and its argument changes by Arg(f(b)/f(a)), the principal value; so it does if the ball of f misses 0.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field, replace
from itertools import pairwise
from typing import Any

import numpy as np
from flint import acb, arb

from mpsolve.errors import EffortError, PrecisionError
from mpsolve.numbers.arrays import Complexes
from mpsolve.proof.cover import OpenPieceError, cover
from mpsolve.proof.effort import Effort
from mpsolve.proof.ladder import climb
from mpsolve.proof.winding import number_of_zeros
from mpsolve.zeros.analytic import cover_region, hull
from mpsolve.zeros.evaluate import CutError
from mpsolve.zeros.function import Function, Side
from mpsolve.zeros.geometry import Vertices
from mpsolve.zeros.path import Leg, legs_round
from mpsolve.zeros.regions import Cut

BITS, MOST_BITS = 64, 512
_FIRST = 32  # pieces of the path, at least one a leg and at most 8
_SMALLEST = 2.0**-44


@dataclass(frozen=True)
class Count:
    """The proved number of zeros in a polygon without its cuts, with all that the proof rests on.

    totals: those of each part of f, without its power. breaks: for each leg of the path the places in [0, 1] between
    which its pieces lie. trees: see `analytic`.
    """

    vertices: Vertices
    cuts: tuple[Cut, ...]
    total: int
    totals: tuple[int, ...]
    breaks: tuple[tuple[float, ...], ...]
    trees: tuple[str, ...]
    bits: int
    points: Complexes = field(repr=False)  # of the path, in floats, with f and f′ there: for candidates
    values: Any = field(repr=False)
    slopes: Complexes = field(repr=False)

    def of_part(self, k: int) -> Count:
        """The same, of one part by itself."""
        return replace(
            self,
            total=self.totals[k],
            totals=self.totals[k : k + 1],
            values=self.values[:, k : k + 1],
            slopes=self.slopes[:, k : k + 1],
        )

    @property
    def pieces(self) -> int:
        return sum(len(places) - 1 for places in self.breaks)


class ZeroOnPathError(PrecisionError):
    """The count does not pass `place`: a zero may lie there."""

    def __init__(self, place: complex) -> None:
        super().__init__(f"f may vanish on the boundary near {place:.8g}")
        self.place = place


def count_zeros(
    f: Function, vertices: Vertices, cuts: Sequence[Cut], effort: Effort, most: int = MOST_BITS, known: bool = False
) -> Count:
    """The number of zeros in the polygon; PrecisionError with its place where that stays open.

    known: f is known to be analytic there.
    """
    legs = legs_round(vertices, cuts)
    trees = () if known else climb(lambda _: cover_region(f, vertices, cuts, effort), BITS, BITS)

    def attempt(bits: int) -> Count:
        first = 2 ** min(3, max(0, (_FIRST // len(legs)).bit_length() - 1))
        walks = [Walk(f, leg, first) for leg in legs]
        breaks = [walk.broken(effort) for walk in walks]
        totals = [_zeros(sum(row, arb(0))) for row in zip(*map(Walk.turns, walks, breaks), strict=True)]
        total = sum(n * power for n, (_, power) in zip(totals, f.parts, strict=True))
        seen = zip(*map(Walk.seen, walks, breaks), strict=True)
        points, values, slopes = (np.concatenate(x) for x in seen)
        kept = tuple(map(tuple, breaks))
        return Count(vertices, tuple(cuts), total, tuple(totals), kept, trees, bits, points, values, slopes)

    return climb(attempt, BITS, most)


def _zeros(turn: arb) -> int:
    return number_of_zeros(turn / (2 * arb.pi()), "f round the region")


@dataclass
class Walk:
    """f along one leg, at the precision that is set."""

    f: Function
    leg: Leg
    first: int = 8
    ends: dict[tuple[float, int], list[Any]] = field(default_factory=dict)
    modes: dict[tuple[float, float], int] = field(default_factory=dict)

    def __post_init__(self) -> None:
        self.a, self.b = hull(self.leg.a), hull(self.leg.b)
        step = self.leg.b[0] - self.leg.a[0], self.leg.b[1] - self.leg.a[1]
        self.step = hull(step)
        self.left = hull((-step[1], step[0]))

    def at(self, t: float) -> Any:
        return self.a if t == 0 else self.b if t == 1 else self.a + self.step * arb(t)

    def broken(self, effort: Effort) -> list[float]:
        """The ends of pieces that pass."""
        first = np.linspace(0, 1, self.first + 1) + 0j
        try:
            ts = cover(first, self._pass, effort, _SMALLEST)
        except OpenPieceError as error:
            raise ZeroOnPathError(complex(self.at(error.place.real).mid())) from None
        return [float(t) for t in ts.real]

    def _pass(self, starts: Complexes, ends: Complexes) -> list[bool]:
        return [self._one(float(s.real), float(t.real)) for s, t in zip(starts, ends, strict=True)]

    def _one(self, s: float, t: float) -> bool:
        tried = (True, not self.f.entire, not self.f.entire and s == 0, not self.f.entire and t == 1)
        for mode in [k for k in range(4) if tried[k]]:
            try:
                if self._turns_little(s, t, mode):
                    self.modes[s, t] = mode
                    return True
                return False
            except EffortError:
                raise
            except CutError:
                continue
            except PrecisionError:
                return False
        return False

    def _side(self, s: float, t: float, piece: acb, mode: int) -> Side | None:
        """Straight on; or from the left of the path; or away from the start of the piece, or from its end."""
        return (None, (piece, self.left), (self.at(s), self.step), (self.at(t), -self.step))[mode]

    def _turns_little(self, s: float, t: float, mode: int) -> bool:
        piece = self.a + self.step * arb((s + t) / 2, (t - s) / 2)
        parts = self.f.part_series(piece, 2, self._side(s, t, piece, mode))
        starts = self.end(s, mode, start=True)
        self.end(t, mode, start=False)
        step = self.step * arb(t - s)
        return all(_little(step, part, start) for part, start in zip(parts, starts, strict=True))

    def end(self, t: float, mode: int, start: bool) -> list[Any]:
        """The parts of f at the end of a piece, continued to a cut as the piece is."""
        key = (t, (0, 1, 2 if start else 0, 0 if start else 3)[mode])
        if key not in self.ends:
            z = self.at(t)
            direction = (None, self.left, self.step, -self.step)[key[1]]
            self.ends[key] = self._value(z, direction)
        return self.ends[key]

    def _value(self, z: acb, direction: Any) -> list[acb]:
        try:
            parts = self.f.part_series(z, 1)
        except CutError:
            if direction is None:
                raise
            parts = self.f.part_series(z, 1, (z, direction))
        return [part[0] for part in parts]

    def turns(self, ts: Sequence[float]) -> list[arb]:
        """The changes of the arguments of the parts along the leg."""
        totals = [arb(0)] * len(self.f.parts)
        for s, t in pairwise(ts):
            mode = self.modes[s, t]
            ends = zip(self.end(t, mode, False), self.end(s, mode, True), strict=True)
            totals = [total + (y / x).log().imag for total, (y, x) in zip(totals, ends, strict=True)]
        return totals

    def seen(self, ts: Sequence[float]) -> tuple[Complexes, Complexes, Complexes]:
        """Points, and values and slopes of the parts, as floats where all are known."""
        points, rows = [], []
        for t in ts[:-1]:
            try:
                parts = self.f.part_series(self.at(t), 2)
                row = [[complex(x) for x in part] for part in parts]
            except (PrecisionError, OverflowError, ValueError):
                continue
            if np.isfinite(row).all() and all(value for value, _ in row):
                points.append(complex(self.at(t)))
                rows.append(row)
        array = np.array(rows, complex).reshape(len(rows), len(self.f.parts), 2)
        return np.array(points, complex), array[:, :, 0], array[:, :, 1]


def _little(step: Any, part: list[acb], start: Any) -> bool:
    value, slope = part
    if not start.abs_lower() > 0:
        return False
    E = step * slope / start
    return bool(E.real > -1 or E.imag > 0 or E.imag < 0 or value.abs_lower() > 0)


__all__ = ["Count", "ZeroOnPathError", "count_zeros"]
