"""Where a height along a curve over one parameter is lowest: by Newton's method, enclosed by its slope's signs.

Nothing here knows what the curve is: a root over a parameter, with −growth as its height, or a crossing of the real
axis over a second parameter, with the first one as its height.
"""

from __future__ import annotations

from dataclasses import dataclass
from fractions import Fraction
from typing import Any, Protocol

from mpsolve.errors import PrecisionError
from mpsolve.numbers.balls import arb, precision, rational_ball

State = tuple[Any, ...]
"""Numbers of a point of the curve."""
_BITS = 80
_STEPS = 40
_MOST = 120  # steps that sharpen
_NEAR = 2.0**-16  # of the range: how far off slopes are compared
GUARD = 40


class Curve(Protocol):
    """Points over x; all at the precision that is set, `PrecisionError` where balls cannot decide."""

    def near(self, state: State, x: Any) -> tuple[State, State]:
        """(the point over the exact x near a state, its rates), middles without proof."""

    def rise(self, rates: State) -> Any:
        """The rate of the height."""

    def enclosed(self, state: State, x: Any, goal: int) -> tuple[State, Any]:
        """(the point over x in balls, of about `goal` bits, the rate of the height in a ball)."""

    def over(self, state: State, x: Any) -> State:
        """The points over all x in a ball, in balls."""


@dataclass(frozen=True)
class Candidate:
    """A point without proof. where: "inside", "start" or "end"; first, second: its derivatives by x̂.

    slope, bend: those of the height.
    """

    x: arb
    state: State
    where: str
    first: tuple[complex, ...]
    second: tuple[complex, ...]
    slope: float
    bend: float

    def beside(self, step: Any) -> list[Any]:
        """About the state so far off, floats or arrays of them."""
        return [
            complex(s) + a * step + b * step**2 / 2
            for s, a, b in zip(self.state, self.first, self.second, strict=True)
        ]


def lowest_near(curve: Curve, state: State, x: float, ends: tuple[arb, arb], step: float) -> Candidate:
    """The lowest point near x̂, within the ends (balls); no step is longer than `step`."""
    with precision(_BITS):
        low, high = (arb(end.mid()) for end in ends)
        at = _within(arb(x), low, high)
        near = (high - low) * arb(_NEAR)
        for _ in range(_STEPS):
            state, first = curve.near(state, at)
            aside = near if at + near <= high else -near
            other = curve.near(_moved(state, first, aside), at + aside)[1]
            second = tuple((b - a) / aside for a, b in zip(first, other, strict=True))
            slope, bend = float(curve.rise(first)), float((curve.rise(other) - curve.rise(first)) / aside)
            wanted = -slope / bend if bend > 0 else -step if slope > 0 else step
            new = _within(at + arb(max(-step, min(step, wanted))), low, high)
            moved = new - at
            where = "start" if new == low and slope > 0 else "end" if new == high and slope < 0 else "inside"
            if abs(float(moved)) <= 2.0**-30 * float(high - low):
                rates = (tuple(map(complex, first)), tuple(map(complex, second)))
                return Candidate(at, state, where, *rates, slope, bend)
            state, at = _moved(state, first, moved), arb(new.mid())
    raise PrecisionError("no lowest point is found near where one seems to be")


def _within(x: arb, low: arb, high: arb) -> arb:
    return low if x <= low else high if x >= high else arb(x.mid())


def _moved(state: State, rates: State, step: Any) -> State:
    return tuple((s + rate * step).mid() for s, rate in zip(state, rates, strict=True))


@dataclass(frozen=True)
class Lowest:
    """x̂ and the state there in balls; beside: exact x̂, and states in balls, where the slopes differ in sign."""

    x: arb
    state: State
    beside: tuple[tuple[Any, State], ...]


def sharpened(curve: Curve, found: Candidate, goal: int) -> Lowest:
    """x̂ within 2^−goal of its modulus: the height falls before and rises behind, proved.

    `PrecisionError` where no change of sign is proved.
    """
    x, state, bend = found.x, found.state, arb(found.bend)
    bits, before = _BITS, None
    for _ in range(_MOST):
        with precision(bits + GUARD):
            state, first = curve.near(state, x)
            rise = curve.rise(first)
            if before is not None and before[0] != x:
                rate = (rise - before[1]) / (x - before[0])
                bend = rate if rate > 0 else bend
            before = (x, rise)
            step = -rise / bend
            x, state = arb((x + step).mid()), _moved(state, first, step)
            size = abs(x).upper()
            small = abs(step).upper() <= size * arb(2) ** (-bits // 2)
        if not step.is_finite():
            break
        if bits >= goal + GUARD and abs(step).upper() <= size * arb(2) ** (-goal - 4):
            return _enclosed(curve, x, state, goal)
        if small:
            bits = min(2 * bits - 16, goal + GUARD)
    raise PrecisionError("the lowest point could not be sharpened")


def _enclosed(curve: Curve, x: arb, state: State, goal: int) -> Lowest:
    with precision(goal + 2 * GUARD):
        reach = arb((abs(x).upper() * arb(2) ** -goal).mid())
        slopes, beside = [], []
        for at in (arb((x - reach).mid()), arb((x + reach).mid())):
            balls, rise = curve.enclosed(state, at, goal + GUARD)
            slopes.append(rise)
            beside.append((at, balls))
        if not (slopes[0] < 0 and slopes[1] > 0):
            raise PrecisionError("the sign of the slope is open next to the lowest point")
        between = x + arb(0, (reach * (1 + arb(2) ** -20)).upper())
        return Lowest(between, curve.over(state, between), tuple(beside))


def proved_lowest(curve: Curve, found: Candidate, ends: tuple[Fraction, Fraction], goal: int) -> Lowest:
    """The lowest point in balls: inside of the range, or over one of its exact ends."""
    if found.where == "inside":
        return sharpened(curve, found, goal)
    with precision(goal + 2 * GUARD):
        x = rational_ball(ends[found.where == "end"])
        state = curve.over(found.state, x)
        return Lowest(x, state, ((x, state),))
