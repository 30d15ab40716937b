"""Every real zero on an interval: tiles on which f has none, or one where its slope does not vanish.

f is taken by its factors, as its outer steps show them: a zero of g in f = g³h counts three times. Zeros of one
factor that meet are not told apart, and are refused by name. As g is monotone on the tile of a zero, signs of g close
about it bracket it as narrowly as one likes.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from fractions import Fraction
from typing import Any

from flint import acb, arb

from mpsolve.errors import PrecisionError
from mpsolve.numbers.balls import rational_ball
from mpsolve.numbers.realroots import end_of
from mpsolve.proof.effort import Effort
from mpsolve.proof.ladder import climb
from mpsolve.zeros.analytic import hull
from mpsolve.zeros.function import Function

BITS, _MOST_BITS = 64, 1024
_SMALLEST = Fraction(1, 1 << 40)
_PARTS = (Fraction(1, 2), Fraction(17, 32), Fraction(15, 32), Fraction(37, 64))


class OpenTileError(PrecisionError):
    """No tile near `place` is decided."""

    def __init__(self, place: float, cause: str) -> None:
        super().__init__(f"zeros near z = {place:.8g} are not told apart, or f is not smooth there ({cause})")
        self.place = place


@dataclass(frozen=True)
class Tiling:
    """Tiles between `places` for one factor; kinds: "." for none, "1" for one zero; so often do its zeros count."""

    function: Function
    power: int
    places: tuple[Fraction, ...]
    kinds: str
    bits: int

    @property
    def with_zeros(self) -> list[tuple[Fraction, Fraction]]:
        """The tiles with a zero."""
        pairs = zip(self.places[:-1], self.places[1:], strict=True)
        return [pair for pair, kind in zip(pairs, self.kinds, strict=True) if kind == "1"]


def tile(f: Function, power: int, a: Fraction, b: Fraction, effort: Effort) -> Tiling:
    """The tiles of a factor; PrecisionError where zeros meet, or where f is not smooth."""
    return climb(lambda bits: _tiled(f, power, a, b, effort, bits), BITS, _MOST_BITS)


def _tiled(f: Function, power: int, a: Fraction, b: Fraction, effort: Effort, bits: int) -> Tiling:
    places, kinds = [a], []
    stack = [(a, b)]
    while stack:
        low, high = stack.pop()
        effort.spend(1)
        try:
            kind = _kind(f, low, high, low == a, high == b)
            cause = "its slope may vanish"
        except PrecisionError as error:
            kind, cause = None, str(error)
        if kind is None:
            if high - low < (b - a) * _SMALLEST:
                raise OpenTileError(float((low + high) / 2), cause)
            middle = _division(f, low, high)
            stack += [(middle, high), (low, middle)]
            continue
        places.append(high)
        kinds.append(kind)
    return Tiling(f, power, tuple(places), "".join(kinds), bits)


def _kind(f: Function, low: Fraction, high: Fraction, first: bool, last: bool) -> str | None:
    value, slope = f.series(acb(hull((low, low), (high, high)).real), 2)
    if value.abs_lower() > 0:
        return "."
    if not slope.is_finite():
        return None
    half = arb(0, rational_ball((high - low) / 2).upper())
    middle = f.series(acb(rational_ball((low + high) / 2)), 1)[0]
    if (middle + slope * acb(half)).abs_lower() > 0:
        return "."
    if not (slope.real > 0 or slope.real < 0):
        return None
    ends = [f.series(acb(rational_ball(x)), 1)[0].real for x in (low, high)]
    if (ends[0] < 0 and ends[1] > 0) or (ends[0] > 0 and ends[1] < 0):
        return "1"
    if (first and ends[0] == 0) or (last and ends[1] == 0):
        return "1"
    if (ends[0] < 0 and ends[1] < 0) or (ends[0] > 0 and ends[1] > 0):
        return None  # monotone without a change of sign: halves show it by their values
    return None


def _division(f: Function, low: Fraction, high: Fraction) -> Fraction:
    """A short place near the middle at which f has a sign, if there is one."""
    for part in _PARTS:
        place = low + (high - low) * part
        if _signed(lambda z: f.series(z, 1)[0], place):
            return place
    return low + (high - low) * _PARTS[0]


def _signed(f: Callable[[Any], Any], place: Fraction) -> bool:
    try:
        return bool(f(acb(rational_ball(place))).abs_lower() > 0)
    except PrecisionError:
        return False


def bracket(f: Function, low: Fraction, high: Fraction, ball: Any) -> tuple[Fraction, Fraction]:
    """Ends inside the tile, close to the ball of its zero, at which f has two signs; the tile itself where none are.

    The precision that is set must tell the signs.
    """
    middle = end_of(ball, 0)
    for widening in range(1, 60, 8):
        reach = (end_of(ball, 1) - middle) * (1 << widening)
        ends = max(low, middle - reach), min(high, middle + reach)
        signs = [_sign(f, x) for x in ends]
        if signs in ([-1, 1], [1, -1]):
            return ends
        if 0 in signs and ends[signs.index(0)] in (low, high):  # an exact zero at an end of the interval
            return ends[signs.index(0)], ends[signs.index(0)]
    return low, high


def _sign(f: Function, x: Fraction) -> int | None:
    try:
        value = f.series(acb(rational_ball(x)), 1)[0].real
    except PrecisionError:
        return None
    return 1 if value > 0 else -1 if value < 0 else 0 if value == 0 else None
