"""What an answer about cut points is made of."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

from flint import arb

from mpsolve.numbers.packed import Portable
from mpsolve.ranges.answer import Answer, AtValue


@dataclass(frozen=True)
class CutPoint(AtValue, Portable):
    """At the parameter `value` the roots q (Re q ≥ 0) and −q̄ are on the cut: two balls in the problem's units.

    side: "below" or "above" it, where the root is on the sheet, or "gap", at the end of the gap (without damping).
    appears: whether a line begins there as the parameter grows; else it ends.
    """

    value: arb
    q: Any
    side: str
    appears: bool


@dataclass(frozen=True)
class CutPoints(Answer):
    """The cut points in ascending order of the parameter: all of the range where the answer is proved.

    Else each of them is proved, but the list may lack some, for a `reason`. reach: the list speaks of |Re q| < reach;
    None: of all q.
    """

    digits: int = 15
    points: tuple[CutPoint, ...] = ()
    reach: float | None = None

    def rows(self) -> list[Mapping[str, Any]]:
        """The answer as a table, numbers as floats: one mapping for each row."""
        return [
            {
                "value": float(point.value.mid()),
                "re_q": float(point.q.real.mid()),
                "im_q": float(point.q.imag.mid()),
                "side": point.side,
                "appears": point.appears,
            }
            for point in self.points
        ]
