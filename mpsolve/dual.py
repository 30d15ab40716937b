"""Dual numbers: a value and its slopes along a few directions, over any arithmetic (balls, discs)."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any


class Dual:
    """value + Σ slopes[k] ε_k with ε_k ε_l = 0. Combines with numbers of its arithmetic, which are constants."""

    __array_ufunc__ = None
    __slots__ = ("slopes", "value")

    def __init__(self, value: Any, slopes: Sequence[Any]) -> None:
        self.value, self.slopes = value, list(slopes)

    def __add__(self, other: Any) -> Dual:
        if isinstance(other, Dual):
            return Dual(self.value + other.value, [a + b for a, b in zip(self.slopes, other.slopes, strict=True)])
        return Dual(self.value + other, self.slopes)

    __radd__ = __add__

    def __neg__(self) -> Dual:
        return Dual(-self.value, [-a for a in self.slopes])

    def __sub__(self, other: Any) -> Any:
        return self + -other

    def __rsub__(self, other: Any) -> Any:
        return -self + other

    def __mul__(self, other: Any) -> Dual:
        if isinstance(other, Dual):
            a, b = self.value, other.value
            return Dual(a * b, [a * t + s * b for s, t in zip(self.slopes, other.slopes, strict=True)])
        return Dual(self.value * other, [a * other for a in self.slopes])

    __rmul__ = __mul__

    def inverse(self) -> Dual:
        u = 1 / self.value
        return Dual(u, [-(u * u * a) for a in self.slopes])

    def __truediv__(self, other: Any) -> Dual:
        if isinstance(other, Dual):
            return self * other.inverse()
        return Dual(self.value / other, [a / other for a in self.slopes])  # 1/other need not be a number of theirs

    def __rtruediv__(self, other: Any) -> Any:
        return self.inverse() * other

    def exp(self) -> Dual:
        e = self.value.exp()
        return Dual(e, [e * a for a in self.slopes])
