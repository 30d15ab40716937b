"""Balls and exact numbers as data that JSON knows, with floats rounded outward and decimals beside them."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import fields
from enum import Enum
from fractions import Fraction
from typing import Any

from flint import acb, arb

from mpsolve.numbers.balls import precision
from mpsolve.numbers.packed import pack


def outward(ball: Any, up: bool) -> float:
    """The float next to the upper (lower) end of a ball that is not inside of it."""
    with precision(64):
        end = ball.upper() if up else ball.lower()
        x = float(end)
        toward = math.inf if up else -math.inf
        while math.isfinite(x) and not (arb(x) >= end if up else arb(x) <= end):
            x = math.nextafter(x, toward)
        return x


def float_beside(x: Fraction, up: bool) -> float:
    """The float next to an exact number that is not below (above) it; the number itself where it is one."""
    value = float(x)
    return value if value == x or (value > x) == up else math.nextafter(value, math.inf if up else -math.inf)


def disc_of(ball: Any) -> tuple[complex, float]:
    """(middle, radius) in floats of a disc that holds a complex ball."""
    with precision(64):
        middle = complex(ball.mid())
        return middle, outward(arb((ball - acb(middle.real, middle.imag)).abs_upper()), up=True)


def shown_digits(ball: Any) -> str:
    """The decimals of a ball that are sure, one digit of them within 1."""
    with precision(max(int(ball.mid().bits()), 53) + 32):
        return str(ball.str(radius=False))


def plain(value: Any) -> Any:
    """Data that JSON knows: of a ball a mapping, of a fraction its text and a decimal, of a dataclass its fields."""
    if value is None or isinstance(value, (bool, int, str)):
        return value
    if isinstance(value, float):
        return value if math.isfinite(value) else None
    if isinstance(value, arb):
        return _ball(value)
    if isinstance(value, acb):
        return {"real": plain(value.real), "imag": plain(value.imag)}
    if isinstance(value, complex):
        return {"real": value.real, "imag": value.imag}
    if isinstance(value, Fraction):
        return {"exact": str(value), "decimal": float(value)}
    if isinstance(value, Enum):
        return value.value
    if isinstance(value, Mapping):
        return {str(key): plain(one) for key, one in value.items()}
    if isinstance(value, (tuple, list)):
        return [plain(one) for one in value]
    return _object(value)


def _ball(value: Any) -> Any:
    if not value.is_finite():
        return None
    ends = {"lower": outward(value, up=False), "upper": outward(value, up=True)}
    return {"decimal": shown_digits(value), **ends, "ball": [(str(x), e) for x, e in pack(value)]}


def _object(value: Any) -> Any:
    """A result, a reason, an array or another dataclass; a text for what is none of them."""
    for name in ("to_dict", "data", "tolist"):
        if callable(getattr(value, name, None)):
            return plain(getattr(value, name)())
    if hasattr(value, "__dataclass_fields__"):
        return {one.name: plain(getattr(value, one.name)) for one in fields(value) if one.repr}
    return str(value)
