"""Boxes that are proved to hold one zero, exactly, and in floats: rounded inward to be left out of a search.

A box about the zero that is wider than the proved one by one rounding may hold another zero.
"""

from __future__ import annotations

import math
from fractions import Fraction
from typing import Any

Interval = tuple[Fraction, Fraction]


def exact(ball: Any) -> Fraction:
    """The middle of a ball as a fraction."""
    mantissa, exponent = ball.mid().man_exp()
    power = int(exponent)
    return Fraction(int(mantissa)) * Fraction(2) ** power


def about(centre: Fraction, reach: float) -> Interval:
    """centre ± reach, exactly."""
    return centre - Fraction(reach), centre + Fraction(reach)


def inward(interval: Interval) -> tuple[float, float]:
    """The widest interval with ends in floats that lies in this one."""
    low, high = (float(end) for end in interval)
    if Fraction(low) < interval[0]:
        low = math.nextafter(low, math.inf)
    if Fraction(high) > interval[1]:
        high = math.nextafter(high, -math.inf)
    return low, high


def outward(interval: Interval) -> tuple[float, float]:
    """The narrowest interval with ends in floats that holds this one."""
    low, high = (float(end) for end in interval)
    if Fraction(low) > interval[0]:
        low = math.nextafter(low, -math.inf)
    if Fraction(high) < interval[1]:
        high = math.nextafter(high, math.inf)
    return low, high


def holds(interval: Interval, ball: Any) -> bool:
    """Whether the whole ball lies in the interior."""
    low, high = inward(interval)
    return bool(ball > low and ball < high)
