"""Decimals of which every digit is proved, from balls."""

from __future__ import annotations

import math
from decimal import ROUND_CEILING, ROUND_FLOOR, localcontext
from decimal import Decimal as Exactly
from typing import Any

from flint import arb, fmpq, fmpz

from mpsolve.errors import PrecisionError
from mpsolve.frozen import frozen

_GUARD_BITS = 64
_FIXED = range(-5, 16)  # decimal exponents of numbers that are written without an exponent


@frozen
class Decimal:
    """The decimal `digits`·10^`place`; every point of its ball is within `radius` ≤ 10^`place` of it.

    digits is a flint.fmpz and radius a flint.fmpq. An exact number has radius 0.
    """

    digits: fmpz
    place: int
    radius: fmpq

    @property
    def text(self) -> str:
        """The decimal, with as many places as it has digits: trailing zeros count."""
        size = str(abs(self.digits))
        sign = "-" if self.digits < 0 else ""
        exponent = len(size) - 1 + self.place
        if not self.digits:
            return f"0e{self.place}" if self.place else "0"
        if self.place > 0 or exponent not in _FIXED:
            fraction = f".{size[1:]}" if len(size) > 1 else ""
            return f"{sign}{size[0]}{fraction}e{exponent}"
        if not self.place:
            return sign + size
        padded = size.rjust(1 - self.place, "0")
        return f"{sign}{padded[: self.place]}.{padded[self.place :]}"

    @property
    def radius_text(self) -> str:
        """An upper bound of the radius in three digits; "0" if the decimal is exact."""
        if not self.radius:
            return "0"
        place = _exponent(self.radius) - 2
        scaled = self.radius / _power(place)
        return Decimal(-(-scaled.p // scaled.q), place, self.radius).text


def proved_digits(ball: Any, limit: int) -> str:
    """A decimal that differs from every point of `ball` by at most one unit in its last place.

    ball: a finite flint.arb, of any precision. The text has at most `limit` ≥ 1 digits, and as many as that
    promise leaves; an exact number that has fewer ends without zeros. "0e-7" says that the number lies within
    10^−7 of 0, and nothing of its sign. Raises PrecisionError for a ball that is not finite.

    >>> from flint import arb
    >>> proved_digits(arb(2.5, 0.0009), 10), proved_digits(arb(1) / 4, 10)
    ('2.500', '0.25')
    """
    return decimal(ball, limit).text


def fixed_digits(ball: Any, limit: int) -> str:
    """The correctly rounded decimal of every point of `ball`: no digit that the ball does not fix.

    ball: a finite flint.arb, of any precision. The text has `limit` ≥ 1 digits, or fewer where two points of the
    ball round differently; it is within half a unit in its last place of them all (a half is rounded up). An exact
    number that has fewer digits ends without zeros. Raises PrecisionError if not even one digit is fixed.

    >>> from flint import arb
    >>> fixed_digits(arb(2.5, 0.0009), 10), fixed_digits(arb(1) / 4, 10)
    ('2.50', '0.25')
    """
    if not ball.is_finite():
        raise PrecisionError("a number that is to be printed is not bounded: raise the precision")
    middle, spread = _ratio(ball.mid()), _ratio(ball.rad())
    if not spread and not middle:
        return "0"
    place = _exponent(abs(middle) + spread) + 1 - limit
    if spread:
        place = max(place, _exponent(2 * spread))  # below that, the ends are more than a unit apart
    while True:  # ends: from 10^place ≥ 20·(|middle| + spread) on, both ends round to 0
        low, high = _rounded(middle - spread, place), _rounded(middle + spread, place)
        if low.digits == high.digits and len(str(abs(low.digits))) <= limit:
            break
        place += 1
    if not low.digits:
        raise PrecisionError("no digit of a number that is to be printed is proved: raise the precision")
    return (_without_zeros(low) if not spread and not low.radius else low).text


def outward(x: float, limit: int, up: bool) -> str:
    """The decimal of at most `limit` digits next to the finite float x that is not below it (up), or not above it.

    >>> outward(0.123456, 3, up=True), outward(0.123456, 3, up=False)
    ('0.124', '0.123')
    """
    rounding = ROUND_CEILING if up else ROUND_FLOOR
    with localcontext(prec=limit, rounding=rounding):
        rounded = +Exactly(x)
    text = f"{rounded:f}"
    return text.rstrip("0").rstrip(".") if "." in text else text


def decimal(ball: Any, limit: int) -> Decimal:
    """The decimal of `proved_digits`, with its distance from the ball's farthest point."""
    if not ball.is_finite():
        raise PrecisionError("a number that is to be printed is not bounded: raise the precision")
    middle, spread = _ratio(ball.mid()), _ratio(ball.rad())
    places = []
    if middle:
        places.append(_exponent(middle) + 1 - limit)
    if spread:
        places.append(_exponent(spread))
    place = max(places, default=0)
    while True:  # ends: from 10^place ≥ 10·spread on, half a unit and the spread are below one unit
        rounded = _rounded(middle, place)
        if rounded.radius + spread <= _power(place) and len(str(abs(rounded.digits))) <= limit:
            break
        place += 1
    if not spread and not rounded.radius:
        return _without_zeros(rounded)
    return Decimal(rounded.digits, place, rounded.radius + spread)


def working_bits(digits: int) -> int:
    """The precision at which values of `digits` digits lose nothing that is printed."""
    return math.ceil(digits * math.log2(10)) + _GUARD_BITS


def _rounded(x: fmpq, place: int) -> Decimal:
    """The decimal nearest to the rational x, in units of 10^place."""
    unit = _power(place)
    digits = (x / unit + fmpq(1, 2)).floor()
    return Decimal(digits, place, abs(x - digits * unit))


def _without_zeros(exact: Decimal) -> Decimal:
    digits, place = exact.digits, exact.place
    while place < 0 and digits % 10 == 0:
        digits, place = digits // 10, place + 1
    return Decimal(digits, place, exact.radius)


def _ratio(x: arb) -> fmpq:
    """An exact flint.arb as a flint.fmpq."""
    mantissa, exponent = x.man_exp()
    shift = int(exponent)
    return fmpq(mantissa << shift) if shift >= 0 else fmpq(mantissa, fmpz(1) << -shift)


def _power(exponent: int) -> fmpq:
    """10^exponent as a flint.fmpq."""
    power = fmpz(10) ** abs(exponent)
    return fmpq(power) if exponent >= 0 else fmpq(1, power)


def _exponent(x: fmpq) -> int:
    """The integer e with 10^e ≤ |x| < 10^(e+1), x a rational that is not 0."""
    size = abs(x)
    guess: int = math.floor((size.p.bit_length() - size.q.bit_length()) * math.log10(2))
    while _power(guess) > size:
        guess -= 1
    while _power(guess + 1) <= size:
        guess += 1
    return guess
