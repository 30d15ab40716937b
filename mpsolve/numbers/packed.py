"""Balls in exact integers, which travel between processes: flint's own do not."""

from __future__ import annotations

from typing import Any

from flint import arb

PackedBall = tuple[tuple[int, int], tuple[int, int]]
"""(mantissa, exponent) of the midpoint and of the radius."""


def pack(ball: Any) -> PackedBall:
    """A finite flint.arb in exact integers."""
    middle, middle_exponent = ball.mid().man_exp()
    radius, radius_exponent = ball.rad().man_exp()
    return (int(middle), int(middle_exponent)), (int(radius), int(radius_exponent))


def unpack(packed: PackedBall) -> Any:
    """The flint.arb with the same midpoint, and the same radius up to its rounding upward, at any precision."""
    return arb(*packed)
