"""The one bounded ladder of precisions: an attempt that balls cannot decide is made again with more bits."""

from __future__ import annotations

from collections.abc import Callable
from typing import TypeVar

from mpsolve.errors import EffortError, PrecisionError
from mpsolve.numbers.balls import precision

T = TypeVar("T")

MOST_BITS = 40_000
"""Enough for 10,000 digits and their guard."""


def climb(attempt: Callable[[int], T], start: int, most: int = MOST_BITS) -> T:
    """attempt(bits) at the first of start, 2·start, … ≤ most at which it does not raise `PrecisionError`.

    The precision is set while the attempt runs. The last `PrecisionError` is raised when none succeeds; an
    `EffortError`, which more bits do not help, at once.
    """
    bits = min(start, most)
    while True:
        try:
            with precision(bits):
                return attempt(bits)
        except EffortError:
            raise
        except PrecisionError:
            if bits >= most:
                raise
        bits = min(2 * bits, most)
