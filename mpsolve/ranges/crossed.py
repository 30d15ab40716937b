"""Crossings of the real axis as an answer: each of them, and the numbers of roots that grow between them.

Speeds of short waves in a range of velocities are left out, with what is not proved round them, by name.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from fractions import Fraction
from math import isqrt
from typing import Any, ClassVar

from flint import arb

from mpsolve.numbers.balls import rational_ball
from mpsolve.numbers.packed import Portable
from mpsolve.outcome import Reason
from mpsolve.problem.family import Interval
from mpsolve.problem.problem import Problem
from mpsolve.ranges.answer import Answer, AtValue
from mpsolve.waves.speeds import wave_speeds

_PLACES = 10**6


@dataclass(frozen=True)
class LeftOut(Portable):
    """A speed of short waves, a ball, and the ends of what is not proved round it; both are the speed itself where
    only that is left out. name: of the waves.
    """

    name: str
    value: arb
    start: Any
    end: Any

    @property
    def is_point(self) -> bool:
        """Whether the speed alone is left out."""
        return bool(self.start.overlaps(self.value) and self.end.overlaps(self.value))


def not_whole(left_out: tuple[LeftOut, ...]) -> Reason | None:
    """Why an answer that leaves out these speeds does not speak of its whole range; None where there are none."""
    stated = f"nothing is proved of a part of the range: {'; '.join(map(shown, left_out))}"
    return Reason("left-out", stated, {}, "give ranges beside that speed") if left_out else None


def shown(one: LeftOut) -> str:
    """In words."""
    if one.is_point:
        return f"v = {float(one.value):.9g} m/s itself ({one.name})"
    return f"v from {float(one.start):.9g} to {float(one.end):.9g} m/s ({one.name}: {float(one.value):.9g} m/s)"


@dataclass(frozen=True)
class Speed:
    """The square of a speed, its name, and rationals below and above it."""

    square: Fraction
    name: str

    @property
    def ball(self) -> Any:
        return rational_ball(self.square).sqrt()

    def beside(self, sign: int) -> Fraction:
        scaled = isqrt(self.square.numerator * _PLACES**2 // self.square.denominator)
        return Fraction(scaled + (2 if sign > 0 else -1), _PLACES)


def speeds_within(problem: Problem, over: Mapping[str, Interval]) -> list[Speed]:
    """The known speeds in a range of v, ascending; none for other paths."""
    low, high = over.get("v", (Fraction(0), Fraction(0)))
    if len(over) != 1 or "v" not in over or low < 0:
        return []
    each = {square: name for name, square in wave_speeds(problem.track).items() if low**2 <= square <= high**2}
    return [Speed(square, each[square]) for square in sorted(each) if square > 0]


@dataclass(frozen=True)
class Crossing(AtValue, Portable):
    """A root q that is real at the parameter `value`: two balls in the problem's units.

    lower, upper: floats that hold `value` between them. direction: by how much the number of unstable roots grows
    there with the parameter: ±2, and ±1 where q = 0 (2 at the velocity at which the cuts of an undamped beam join).
    """

    value: Any
    q: Any
    direction: int | None


@dataclass(frozen=True)
class Crossings(Answer):
    """All crossings of a range, in ascending order, and the numbers of unstable roots before, between and behind.

    left_out: speeds of short waves in a range of velocities, each with what is not proved round it; where that is
    more than the speed itself the answer is undecided. parts: the answers between them, whose crossings and, if
    proved, counts stand here one after the other: one count more for each part.
    """

    a_list: ClassVar[bool] = True
    digits: int = 15
    crossings: tuple[Crossing, ...] = ()
    counts: tuple[int, ...] | None = None
    left_out: tuple[LeftOut, ...] = ()
    parts: tuple[Crossings, ...] = field(default=(), repr=False)

    def rows(self) -> list[Mapping[str, Any]]:
        """The answer as a table, numbers as floats: one mapping for each row."""
        return [
            {"value": float(c.value.mid()), "q": float(c.q.mid()), "direction": c.direction} for c in self.crossings
        ]
