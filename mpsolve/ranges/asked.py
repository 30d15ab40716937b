"""Boxes in (q̂, x̂, ŷ) of which only some slices are asked: ŷ = y_j, x̂ up to an end of its own, but not in its room.

A box is judged over the hull of what is asked of it: the y_j in it whose ends it reaches, up to the largest of these
ends. What is proved of the hull holds on each slice.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np

from mpsolve.numbers.arrays import Reals, Truths
from mpsolve.ranges.judge import NOT_ASKED, Judge


@dataclass(frozen=True)
class Asked:
    """What is asked of boxes in (q̂, x̂, ŷ): at y in [low_j, high_j], x up to end_j, without the room (q̂, x̂) of j."""

    low: Reals
    high: Reals
    ends: Reals
    room_low: Reals
    room_high: Reals

    def needed(self, low: Any, high: Any) -> Any:
        """Of each box (rows) and each j, whether it is asked of the box."""
        at = (low[2][:, None] <= self.high) & (high[2][:, None] >= self.low) & (low[1][:, None] <= self.ends)
        inside = np.ones(at.shape, bool)
        for k in range(2):
            inside &= (low[k][:, None] >= self.room_low[k]) & (high[k][:, None] <= self.room_high[k])
        return at & ~inside

    def clipped(self, low: Reals, high: Any, needed: Truths) -> tuple[Reals, Any]:
        """The least boxes that hold what is needed."""
        low, high = low.copy(), high.copy()
        low[2] = np.maximum(low[2], np.where(needed, self.low, np.inf).min(1))
        high[2] = np.minimum(high[2], np.where(needed, self.high, -np.inf).max(1))
        high[1] = np.minimum(high[1], np.where(needed, self.ends, -np.inf).max(1))
        return low, high


@dataclass(frozen=True)
class AskedJudge:
    """Judges boxes as another one does, of what is asked."""

    judge: Judge
    asked: Asked

    def __call__(self, low: Any, high: Any) -> tuple[Any, Any]:
        needed = self.asked.needed(low, high)
        kind, axis = np.full(low.shape[1], NOT_ASKED, np.int8), np.zeros(low.shape[1], np.int8)
        rest = np.flatnonzero(needed.any(1))
        if len(rest):
            clipped = self.asked.clipped(low[:, rest], high[:, rest], needed[rest])
            kind[rest], axis[rest] = self.judge(*clipped)
        return kind, axis
