"""Crossings of the real axis as an answer: each of them, and the numbers of roots that grow between them."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Any, ClassVar

from mpsolve.numbers.packed import Portable
from mpsolve.ranges.answer import Answer, AtValue
from mpsolve.ranges.left_out import LeftOut


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
