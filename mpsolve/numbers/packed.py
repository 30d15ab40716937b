"""Balls in exact integers, which travel between processes: flint's own do not."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import fields
from fractions import Fraction
from typing import Any

from flint import acb, arb

from mpsolve.frozen import frozen

PackedBall = tuple[tuple[int, int], tuple[int, int]]
"""(mantissa, exponent) of the midpoint and of the radius."""


def pack(ball: Any) -> PackedBall:
    """A finite flint.arb in exact integers."""
    middle, middle_exponent = ball.mid().man_exp()
    radius, radius_exponent = ball.rad().man_exp()
    return (int(middle), int(middle_exponent)), (int(radius), int(radius_exponent))


def unpack(packed: PackedBall) -> arb:
    """The flint.arb with the same midpoint, and the same radius up to its rounding upward, at any precision."""
    return arb(*packed)


def dyadic(x: arb) -> Fraction:
    """An exact flint.arb, such as a middle or a radius."""
    mantissa, exponent = x.man_exp()
    return Fraction(int(mantissa)) * Fraction(2) ** int(exponent)


def exponent_of(x: arb) -> int:
    """e with 2^(e−1) ≤ |x| < 2^e, for an exact flint.arb that is not 0."""
    mantissa, exponent = x.man_exp()
    return int(exponent) + int(abs(mantissa)).bit_length()


def exact_ends(ball: Any) -> tuple[Fraction, Fraction]:
    """The ends of a real ball."""
    middle, radius = dyadic(ball.mid()), dyadic(ball.rad())
    return middle - radius, middle + radius


@frozen
class _Ball:
    """A real ball (one part) or a complex one (two); None is the ball of all numbers, for one that is not finite."""

    parts: tuple[PackedBall | None, ...]


@frozen
class _Array:
    """A numpy array of objects."""

    shape: tuple[int, ...]
    values: tuple[Any, ...]


class Portable:
    """Base of frozen dataclasses that hold balls, so that they can be pickled and copied."""

    def __reduce__(self) -> tuple[Any, ...]:
        values = {one.name: _packed(getattr(self, one.name)) for one in fields(self)}  # type: ignore[arg-type]
        return _restored, (type(self), values)


def _part(ball: Any) -> PackedBall | None:
    return pack(ball) if ball.is_finite() else None


def _restored(kind: type[Any], values: Mapping[str, Any]) -> Any:
    out = object.__new__(kind)
    for name, value in values.items():
        object.__setattr__(out, name, _unpacked(value))
    return out


def _packed(value: Any) -> Any:
    if isinstance(value, arb):
        return _Ball((_part(value),))
    if isinstance(value, acb):
        return _Ball((_part(value.real), _part(value.imag)))
    if getattr(getattr(value, "dtype", None), "hasobject", False):
        return _Array(value.shape, tuple(map(_packed, value.ravel().tolist())))
    if type(value) is tuple:
        return tuple(map(_packed, value))
    return {key: _packed(one) for key, one in value.items()} if type(value) is dict else value


def _unpacked(value: Any) -> Any:
    if isinstance(value, _Ball):
        parts = [arb(0, float("inf")) if one is None else unpack(one) for one in value.parts]
        return parts[0] if len(parts) == 1 else acb(*parts)
    if isinstance(value, _Array):
        return _object_array(value)
    if type(value) is tuple:
        return tuple(map(_unpacked, value))
    return {key: _unpacked(one) for key, one in value.items()} if type(value) is dict else value


def _object_array(packed: _Array) -> Any:
    import numpy as np  # only who has made such an array needs it

    out = np.empty(len(packed.values), object)
    for k, value in enumerate(packed.values):
        out[k] = _unpacked(value)
    return out.reshape(packed.shape)
