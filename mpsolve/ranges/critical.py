"""Where the imaginary part of a root is stationary in the parameter: sought by Newton's method, enclosed by signs."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

from mpsolve.characteristic.free_proved import FreeProved
from mpsolve.errors import PrecisionError
from mpsolve.numbers.balls import acb, arb, precision
from mpsolve.proof import newton
from mpsolve.ranges.branch import AtPoint, root_at

_BITS = 80
_STEPS = 40
_NEAR = 2.0**-16  # of the range: how far off slopes are compared
_GUARD = 40


@dataclass(frozen=True)
class Candidate:
    """A point without proof. where: "inside", "start" or "end"; first, second: the derivatives of q̂ by x̂ there."""

    x: Any
    q: Any
    where: str
    first: complex
    second: complex

    @property
    def slope(self) -> float:
        """Of Im q̂."""
        return self.first.imag

    @property
    def bend(self) -> float:
        """The second derivative of Im q̂."""
        return self.second.imag

    def beside(self, step: float) -> tuple[float, complex]:
        """(x̂, about the root there), so far off."""
        return float(self.x) + step, complex(self.q) + self.first * step + self.second * step**2 / 2


def lowest_near(proved: FreeProved, q: complex, x: float, ends: tuple[Any, Any], step: float) -> Candidate:
    """The lowest point of the branch of q̂ near x̂, within the ends (balls); no step is longer than `step`."""
    with precision(_BITS):
        low, high = (arb(end.mid()) for end in ends)
        at, root = _within(arb(x), low, high), acb(q)
        near = (high - low) * arb(_NEAR)
        for _ in range(_STEPS):
            root, first = _moved(proved, root, at)
            aside = near if at + near <= high else -near
            second = (_moved(proved, root + first * aside, at + aside)[1] - first) / aside
            slope, bend = float(first.imag), float(second.imag)
            wanted = -slope / bend if bend > 0 else -step if slope > 0 else step
            new = _within(at + arb(max(-step, min(step, wanted))), low, high)
            moved = new - at
            where = "start" if new == low and slope > 0 else "end" if new == high and slope < 0 else "inside"
            if abs(float(moved)) <= 2.0**-30 * float(high - low):
                return Candidate(at, root, where, complex(first), complex(second))
            root, at = (root + first * moved).mid(), arb(new.mid())
    raise PrecisionError("no lowest point of a root is found near where one seems to be")


def _within(x: Any, low: Any, high: Any) -> Any:
    return low if x <= low else high if x >= high else arb(x.mid())


def _moved(proved: FreeProved, q: Any, x: Any) -> tuple[Any, Any]:
    """(the root near q at x, how it moves with x), middles."""
    f, root = root_at(proved, q, x)
    return root, f.motion(root).mid()


@dataclass(frozen=True)
class Lowest:
    """x̂ and q̂ in balls; beside: exact points and roots in balls between which the slope changes its sign."""

    x: Any
    q: Any
    beside: tuple[tuple[Any, Any], ...]


def sharpened(proved: FreeProved, found: Candidate, goal: int) -> Lowest:
    """x̂ within 2^−goal of its modulus: d Im q̂/dx̂ changes its sign from − to + there, proved.

    `PrecisionError` where no change of sign is proved.
    """
    x, root, bend = found.x, found.q, arb(found.bend)
    bits, before = _BITS, None
    while True:
        with precision(bits + _GUARD):
            root, first = _moved(proved, root, x)
            if before is not None and before[0] != x:
                rate = (first.imag - before[1].imag) / (x - before[0])
                bend = rate if rate > 0 else bend
            before = (x, first)
            step = -first.imag / bend
            x, root = arb((x + step).mid()), (root + first * step).mid()
            done = bits >= goal + _GUARD
            small = abs(step).upper() <= abs(x).upper() * arb(2) ** (-bits // 2)
        if done and abs(step).upper() <= abs(x).upper() * arb(2) ** (-goal - 4):
            break
        if small:
            bits = min(2 * bits - 16, goal + _GUARD)
        if not step.is_finite():
            raise PrecisionError("the lowest point of a root could not be sharpened")
    return _enclosed(proved, x, root, goal)


def _enclosed(proved: FreeProved, x: Any, root: Any, goal: int) -> Lowest:
    with precision(goal + 2 * _GUARD):
        reach = arb((abs(x).upper() * arb(2) ** -goal).mid())
        signs, beside = [], []
        for at in (x - reach, x + reach):
            at = arb(at.mid())
            f = AtPoint.near(proved, root, at)
            ball = newton.sharpened(f, newton.isolated(f, newton.polished(f, root), abs(root)).image, goal + _GUARD)
            signs.append(f.motion(ball).imag)
            beside.append((at, ball))
        if not (signs[0] < 0 and signs[1] > 0):
            raise PrecisionError("the sign of the slope is open next to the lowest point")
        between = x + arb(0, (reach * (1 + arb(2) ** -20)).upper())
        return Lowest(between, root_over(proved, root, between), tuple(beside))


def root_over(proved: FreeProved, root: Any, x: Any) -> Any:
    """The root near an exact point for all x̂ in a ball, the only one in a box; at the precision that is set."""
    f = AtPoint.near(proved, root, arb(x.mid()))
    over = AtPoint(proved, x, f.reduction)
    return newton.isolated(over, newton.polished(f, root), abs(root)).image


def at_end(proved: FreeProved, found: Candidate, x: Any, goal: int) -> Lowest:
    """The root at an end x̂ of the range, given by a ball for the exact number."""
    with precision(goal + 2 * _GUARD):
        q = root_over(proved, found.q, x())
        return Lowest(x(), q, ((x(), q),))
