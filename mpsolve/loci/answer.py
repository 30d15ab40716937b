"""What an answer about root loci is made of."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from fractions import Fraction
from typing import Any

from flint import arb

from mpsolve.numbers.packed import Portable
from mpsolve.ranges.answer import Answer, AtValue
from mpsolve.ranges.crossed import Crossing
from mpsolve.spectrum.regions import Below, HalfPlane, Sheet


@dataclass(frozen=True)
class LineEnd(Portable):
    """How a line ends.

    kind: "range", at an end of the range; "region", where the root leaves the region; "cut", where it is on a branch
    cut of the whole sheet, and beyond it on another sheet; "collision", where it meets its mirror image −q̄ on the
    imaginary axis; "open", where it is not proved to go on. value, q: balls, in the problem's units, where the root
    is then; a collision is within them. None at an end of the range and where it is open. side: of a cut, as in
    `CutPoint`, to which the end belongs.
    """

    kind: str
    value: Any | None = None
    q: Any | None = None
    side: str | None = None

    @property
    def said(self) -> str:
        """The kind, and the side of a cut."""
        return f"{self.kind} {self.side}" if self.side else self.kind


@dataclass(frozen=True)
class FrequencyLine(Portable):
    """One root with Re q ≥ 0, which stands for its mirror image −q̄ too, as a continuous function of the parameter.

    values: those of the points that were asked for at which the line is there, q: balls (flint.acb) of the root at
    them. ends: the first and the last. weight: how many roots it stands for: 2, and 1 on the imaginary axis.
    crossings: where it crosses the real axis.
    """

    values: tuple[Fraction, ...]
    q: tuple[Any, ...]
    ends: tuple[LineEnd, LineEnd]
    weight: int
    crossings: tuple[Crossing, ...] = ()

    @property
    def points(self) -> tuple[tuple[Fraction | float, Any, str], ...]:
        """(value, q, "") along the line, before and behind them its ends where they are known, with their `said`."""
        own = [(value, q, "") for value, q in zip(self.values, self.q, strict=True)]
        first, last = (
            [(float(end.value.mid()), end.q, end.said)] if end.value is not None else [] for end in self.ends
        )
        return (*first, *own, *last)


@dataclass(frozen=True)
class Event(AtValue, Portable):
    """At the parameter `value` a root q comes into the region (gained > 0) or leaves it (gained < 0), with −q̄.

    side: of a cut, where it does so on the whole sheet.
    """

    value: arb
    q: Any
    gained: int
    side: str | None = None


@dataclass(frozen=True)
class FrequencyLines(Answer):
    """All lines of a region, by where they begin and by Re q.

    region: in which every root is on a line, the same for all values. events: all values at which a root comes into
    it or leaves it; counts: the numbers of roots in it before, between and behind the events, q and −q̄ both counted;
    at every value but the events the weights of the lines add up to them.
    """

    digits: int = 15
    region: Below | HalfPlane | Sheet = field(default_factory=HalfPlane)
    values: tuple[Fraction, ...] = ()
    lines: tuple[FrequencyLine, ...] = ()
    events: tuple[Event, ...] = ()
    counts: tuple[int, ...] | None = None

    def rows(self) -> list[Mapping[str, Any]]:
        """The answer as a table, numbers as floats: one mapping for each point of each line, and for its ends.

        end: "" at a point, else how the line ends there: "region", "collision", or the side of a cut, as "cut below".
        """
        return [
            {"line": k, "value": float(value), "re_q": float(q.real.mid()), "im_q": float(q.imag.mid()), "end": end}
            for k, line in enumerate(self.lines, 1)
            for value, q, end in line.points
        ]
