"""Boxes laid along a slope: parallelograms (t, x) with q = t + slope·x, where what happens in a box follows a line.

Next to a curve q = b(x) boxes must be as thin as what happens there is thick, but they may be as long as the curve
is straight. The last row of corners is the slope, the same in both.
"""

from __future__ import annotations

from typing import Any

import numpy as np

from mpsolve.numbers.arrays import Reals
from mpsolve.numbers.jets import U

SLOPED = 127
"""In place of an axis, of a box that was halved along x, and its halves laid along a new slope."""
_FINE = 64  # of how thick a box is: so much the slope may be off at its ends, with numbers of few digits
_TINY = 2.0**-1000


def sheared(low: Reals, high: Reals, slope: Reals) -> tuple[Reals, Reals]:
    """Parallelograms with other slopes that hold the given ones, between the same x."""
    more = slope - low[-1]
    one, other = more * low[1], more * high[1]
    a = low[0] - np.maximum(one, other)
    b = high[0] - np.minimum(one, other)
    lost = (np.abs(low[0]) + np.abs(high[0]) + np.abs(one) + np.abs(other)) * 8 * U + _TINY
    first, second = low.copy(), high.copy()
    first[0], second[0] = a - lost, b + lost
    first[-1] = second[-1] = slope
    return first, second


def upright(low: Reals, high: Reals) -> tuple[Reals, Reals]:
    """The boxes (q, x) round parallelograms, without the row of slopes; upright ones as they are."""
    flat, (a, b) = low[-1] == 0, sheared(low, high, 0 * low[-1])
    return np.where(flat, low, a)[:-1], np.where(flat, high, b)[:-1]


def rounded(slope: Reals, low: Any, high: Any) -> Any:
    """Slopes with few digits, near enough for boxes of this size."""
    with np.errstate(all="ignore"):
        step = np.exp2(np.floor(np.log2((high[0] - low[0]) / (high[1] - low[1]) / _FINE)))
        return np.round(slope / step) * step
