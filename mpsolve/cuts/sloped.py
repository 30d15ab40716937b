"""Balls with their slopes in some real unknowns, and (eʷ − 1)/w, which is entire."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

from mpsolve.numbers.balls import acb, arb, bits_now, square


@dataclass(frozen=True)
class Sloped:
    """A ball of a function and balls of its slopes."""

    value: acb
    slopes: tuple[acb, ...]

    def __neg__(self) -> Sloped:
        return Sloped(-self.value, tuple(-d for d in self.slopes))

    def __add__(self, other: Sloped) -> Sloped:
        return Sloped(self.value + other.value, tuple(a + b for a, b in zip(self.slopes, other.slopes, strict=True)))

    def __mul__(self, other: Sloped) -> Sloped:
        pairs = zip(self.slopes, other.slopes, strict=True)
        return Sloped(self.value * other.value, tuple(self.value * b + a * other.value for a, b in pairs))

    def _through(self, value: Any, rate: acb) -> Sloped:
        return Sloped(value, tuple(rate * d for d in self.slopes))

    def times(self, factor: complex) -> Sloped:
        """Times an exact number."""
        return self._through(self.value * acb(factor), acb(factor))

    def inverse(self) -> Sloped:
        """1/f; not finite where f may vanish."""
        value = 1 / self.value
        return self._through(value, -value * value)

    def exp(self) -> Sloped:
        """e^f."""
        value = self.value.exp()
        return self._through(value, value)

    def quotient(self) -> Sloped:
        """(e^f − 1)/f."""
        return self._through(*quotient(self.value))


def quotient(w: acb) -> tuple[acb, acb]:
    """Balls of E(w) = (eʷ − 1)/w and of E′(w); by Taylor's series next to 0, where |remainder| ≤ |w|ⁿ e^|w|/n!."""
    size = arb(w.abs_upper())
    if not size < 1:
        value = (w.exp() - 1) / w
        if value.is_finite():
            return value, (w.exp() - value) / w
    value, rate, power, factor, n = acb(0), acb(0), acb(1), arb(1), 0
    while n < 4 or not (factor * size.exp() * size**n).upper() < arb(2) ** -bits_now():
        factor = factor / (n + 1)  # 1/(n + 1)!
        value += power * factor
        rate += (n + 1) * power * factor / (n + 2)
        power, n = power * w, n + 1
    lost = square((factor * size.exp() * size**n).upper())
    return value + lost, rate + lost
