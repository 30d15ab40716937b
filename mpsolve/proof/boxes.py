"""Covering a region of several real variables by boxes that each pass a test; those that fail are halved."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np

from mpsolve.errors import PrecisionError
from mpsolve.proof.effort import Effort

Test = Callable[[Any, Any], tuple[Any, Any]]
"""(lower ends, upper ends), shape (boxes, variables) → (which boxes pass, the variable along which to halve them)."""

_BATCH = 4096


class OpenBoxError(PrecisionError):
    """A box passes its test at no size; `place` is its middle."""

    def __init__(self, place: tuple[float, ...]) -> None:
        super().__init__(f"the smallest boxes do not pass near {', '.join(f'{x:.6g}' for x in place)}")
        self.place = place


def cover_boxes(low: Any, high: Any, test: Test, effort: Effort, smallest: float = 2.0**-22) -> int:
    """The number of boxes that passed, and that together are the union of the given ones, shape (boxes, variables).

    A box is halved at a float between its ends, so that its halves are the whole of it. Boxes narrower than
    `smallest` of the whole along the variable to be halved raise OpenBoxError; a spent effort raises EffortError.
    """
    low, high = np.atleast_2d(np.asarray(low, float)), np.atleast_2d(np.asarray(high, float))
    least = smallest * (high.max(0) - low.min(0))
    count = 0
    while len(low):
        a, b, low, high = low[-_BATCH:], high[-_BATCH:], low[:-_BATCH], high[:-_BATCH]
        effort.spend(len(a))
        passed, axis = test(a, b)
        count += int(passed.sum())
        a, b, axis = a[~passed], b[~passed], axis[~passed]
        if not len(a):
            continue
        rows = np.arange(len(a))
        middle = (a[rows, axis] + b[rows, axis]) / 2
        short = (b[rows, axis] - a[rows, axis] <= least[axis]) | (middle <= a[rows, axis]) | (middle >= b[rows, axis])
        if short.any():
            k = int(np.flatnonzero(short)[0])
            raise OpenBoxError(tuple(float(x) for x in (a[k] + b[k]) / 2))
        upper, lower = b.copy(), a.copy()
        upper[rows, axis], lower[rows, axis] = middle, middle
        low, high = np.concatenate([low, a, lower]), np.concatenate([high, upper, b])
    return count
