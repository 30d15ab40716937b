"""Affine forms in float64 arrays: rigorous first-order enclosures over boxes of many real variables.

An `Affine` stands for functions f(ε) of variables |ε_k| ≤ 1, one function for each index: |f − a − Σ b_k ε_k| ≤ e.
The variables have names, and two forms with one name mean the same variable. +, −, ×, ÷ of real floats are correctly
rounded; what they lose is added to e with a wide margin. What cannot be bounded has e = ∞ or nan, and no comparison
with it proves anything.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from fractions import Fraction
from typing import Any

import numpy as np

from mpsolve.numbers.arrays import Reals
from mpsolve.numbers.jets import TINY, UP, U, nearest


@dataclass(frozen=True)
class Affine:
    """a: real array; b: by name the array of one slope; e ≥ 0: real array. All are broadcast against each other."""

    a: Any
    b: Mapping[str, Reals] = field(default_factory=dict)
    e: Any = 0.0

    __array_ufunc__ = None

    @property
    def spread(self) -> Any:
        """Σ |b_k|, rounded up."""
        return sum((np.abs(x) for x in self.b.values()), np.zeros_like(self.a)) * UP

    @property
    def low(self) -> Any:
        """A lower bound."""
        radius = (self.spread + self.e) * UP
        return self.a - radius - 4 * U * (np.abs(self.a) + radius)

    @property
    def high(self) -> Any:
        """An upper bound."""
        radius = (self.spread + self.e) * UP
        return self.a + radius + 4 * U * (np.abs(self.a) + radius)

    def take(self, rows: Any) -> Affine:
        """The functions with these leading indices."""
        return Affine(self.a[rows], {name: x[rows] for name, x in self.b.items()}, self.e[rows])

    def __neg__(self) -> Affine:
        return Affine(-self.a, {name: -x for name, x in self.b.items()}, self.e)

    def __add__(self, other: Affine) -> Affine:
        if not isinstance(other, Affine):
            other = Affine(np.asarray(other, float))
        a = self.a + other.a
        b = dict(self.b)
        for name, x in other.b.items():
            b[name] = b[name] + x if name in b else x
        size = np.abs(a) + sum(np.abs(x) for x in b.values())
        return Affine(a, b, (self.e + other.e + 2 * U * size) * UP + TINY)

    def __sub__(self, other: Affine) -> Affine:
        return self.__add__(-other)

    def times(self, factor: float) -> Affine:
        """The product with floats that are meant exactly."""
        a, b = self.a * factor, {name: x * factor for name, x in self.b.items()}
        size = np.abs(a) + sum(np.abs(x) for x in b.values())
        return Affine(a, b, (self.e * np.abs(factor) + 2 * U * size) * UP + TINY)

    def __mul__(self, other: Affine) -> Affine:
        a, s, t = self.a * other.a, self.spread, other.spread
        b = {name: x * other.a for name, x in self.b.items()}
        diagonal: Any = 0.0
        for name, x in other.b.items():
            b[name] = b[name] + self.a * x if name in b else self.a * x
            if name in self.b:  # the square of a variable lies in [0, 1]
                half = self.b[name] * x / 2
                a, diagonal = a + half, diagonal + np.abs(half)
        one, two = np.abs(self.a) + s, np.abs(other.a) + t
        lost = 8 * (len(b) + 4) * U * one * two
        e = np.maximum(s * t - diagonal, 0) + one * other.e + (two + other.e) * self.e + lost
        return Affine(a, b, e * UP + TINY)

    def square(self) -> Affine:
        """f²."""
        return self * self

    def inverse(self) -> Affine:
        """1/f where f is proved positive; elsewhere not bounded."""
        with np.errstate(all="ignore"):
            d = (self.spread + self.e) * UP
            c = 1 / self.a  # 1/(a + δ) = c − δc² + ρ, 0 ≤ ρ ≤ d²c²/(a − d)
            bend = d * d * c * c / (self.a * (1 - 4 * U) - d) / 2
            size = c * (1 + d * c)
            e = (bend + self.e * c * c + 16 * (len(self.b) + 4) * U * (size + bend)) * UP + TINY
            good = self.a * (1 - 2.0**-30) > d
            return Affine(c + bend, {name: -x * c * c for name, x in self.b.items()}, np.where(good, e, np.inf))


def constant(x: Fraction) -> Affine:
    """An exact number, to nearest."""
    value = nearest(x) if isinstance(x, Fraction) else float(x)
    return Affine(np.asarray(value), {}, np.asarray(U * abs(value)))


def between(low: Reals, high: Reals, name: str) -> Affine:
    """The variable that runs from low to high (floats, arrays of one shape)."""
    low, high = np.asarray(low, float), np.asarray(high, float)
    middle = low / 2 + high / 2
    radius = np.maximum(high - middle, middle - low) * UP
    radius = np.where(low == high, 0.0, radius)
    return Affine(middle, {name: radius} if (radius > 0).any() else {}, 4 * U * np.abs(middle) * (low != high))


def horner(coefficients: list[Affine | None], x: Affine) -> Affine:
    """Σ c_k x^k; None stands for 0."""
    total: Affine | None = None
    for c in reversed(coefficients):
        total = total * x if total is not None else None
        total = c if total is None else total if c is None else total + c
    return Affine(np.zeros(())) if total is None else total
