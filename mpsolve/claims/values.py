"""Balls against printed numbers, and balls as text. Nothing here rounds a ball to decide: both ends must agree."""

from __future__ import annotations

import math
from decimal import Decimal
from fractions import Fraction
from typing import Any

from mpsolve.errors import PrecisionError
from mpsolve.numbers.decimals import fixed_digits
from mpsolve.numbers.packed import exact_ends
from mpsolve.numbers.spoken import decimal as decimal


def shown(ball: Any, digits: int = 12) -> str:
    """The ball in decimals that are all proved."""
    return fixed_digits(ball, digits)


def below(x: Any, y: Any) -> bool:
    """Whether x < y, proved either way; PrecisionError where the balls leave it open."""
    if x < y:
        return True
    if x >= y:
        return False
    raise PrecisionError("two balls overlap where their order decides: ask for more digits")


def places(printed: str) -> int:
    """The number of decimals of a printed number."""
    return len(printed.partition(".")[2])


def rounds_to(ball: Any, printed: str) -> bool:
    """Whether every point of the ball, rounded to the decimals of `printed`, is `printed`.

    PrecisionError if two points of the ball round differently.
    """
    unit = Fraction(1, 10 ** places(printed))
    low, high = (math.floor(end / unit + Fraction(1, 2)) for end in exact_ends(ball))
    if low != high:
        raise PrecisionError("two points of a ball round differently: ask for more digits")
    return low * unit == Fraction(printed)


def rounded(ball: Any, decimals: int) -> str:
    """The decimal with so many places to which every point of the ball rounds."""
    low, high = (math.floor(end * 10**decimals + Fraction(1, 2)) for end in exact_ends(ball))
    if low != high:
        raise PrecisionError("two points of a ball round differently: ask for more digits")
    return _point(low, decimals)


def last_on_grid(ball: Any, step: Fraction) -> Fraction:
    """The last multiple of `step` below the ball. PrecisionError if one lies in it."""
    low, high = (math.floor(end / step) for end in exact_ends(ball))
    if low != high:
        raise PrecisionError("a value of the grid lies in a ball: ask for more digits")
    return low * step


def first_on_grid(ball: Any, step: Fraction) -> Fraction:
    """The first multiple of `step` above the ball. PrecisionError if one lies in it."""
    return last_on_grid(ball, step) + step


def grid(text: str) -> tuple[str, ...]:
    """The values first:step:last of the paper's notation as decimals.

    >>> grid("0.5:0.5:1.5")
    ('0.5', '1', '1.5')
    """
    first, step, last = (Fraction(part) for part in text.split(":"))
    count = math.floor((last - first) / step) + 1
    return tuple(decimal(first + k * step) for k in range(count))


def _point(units: int, decimals: int) -> str:
    """units·10^−decimals as a decimal."""
    return f"{Decimal(units).scaleb(-decimals):f}"
