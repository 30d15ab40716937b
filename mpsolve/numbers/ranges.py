"""A range between two exact numbers, as a user gives it."""

from __future__ import annotations

from typing import Any

from mpsolve.errors import InputError
from mpsolve.numbers.exact import Exact


def checked_range(value: Any, key: str) -> tuple[Exact, Exact]:
    """Two rational ends in order."""
    try:
        low, high = value
    except (TypeError, ValueError):
        raise InputError(key, f"is {value!r}: give a range (lo, hi)") from None
    low, high = Exact.parse(low, key), Exact.parse(high, key)
    if not (low.is_rational and high.is_rational):
        raise InputError(key, "has an irrational end: give decimals or ratios p/q")
    if not low < high:
        raise InputError(key, f"ends at {high.short()}, not above its start {low.short()}: give the ends in order")
    return low, high
