"""Designs as functions of an index: entry number k has its values without any other entry being made.

Random and quasi-random numbers are whole multiples of 10^−9, so that a value between two decimals is itself a short
decimal, the same in exact and in float64 work.
"""

from __future__ import annotations

import hashlib
from dataclasses import dataclass
from fractions import Fraction
from functools import cached_property, lru_cache
from math import lcm
from typing import Any, TypeAlias

Value: TypeAlias = Fraction

FINE = 10**9
"""Random and quasi-random numbers are k/FINE, 0 ≤ k < FINE."""
_PRIMES = (2, 3, 5, 7, 11, 13, 17)
STREAMS = len(_PRIMES)
"""Most numbers that are drawn for one case."""


@dataclass(frozen=True)
class Listed:
    """The values of a list, or a single value."""

    values: tuple[Value, ...]

    @property
    def count(self) -> int:
        return len(self.values)

    def at(self, k: int) -> Value:
        return self.values[k]

    @property
    def extremes(self) -> tuple[Value, ...]:
        """Values between which all others lie."""
        return self.values

    @property
    def canonical(self) -> Any:
        return str(self.values[0]) if len(self.values) == 1 else [str(value) for value in self.values]


@dataclass(frozen=True)
class Steps:
    """start, start + step, …: `count` values."""

    start: Fraction
    step: Fraction
    count: int

    def at(self, k: int) -> Value:
        return self.start + k * self.step

    @property
    def extremes(self) -> tuple[Value, ...]:
        return self.start, self.at(self.count - 1)

    @property
    def canonical(self) -> dict[str, str]:
        return {"start": str(self.start), "stop": str(self.at(self.count - 1)), "step": str(self.step)}


@dataclass(frozen=True)
class Span:
    """Values drawn from low ≤ value < high."""

    low: Fraction
    high: Fraction

    def at(self, k: int) -> Value:
        """The value for the drawn number k/FINE."""
        first, step, scale = self._integers
        return Fraction(first + k * step, scale)

    @cached_property
    def _integers(self) -> tuple[int, int, int]:
        """low and (high − low)/FINE over one denominator: a entry costs one division."""
        scale = FINE * lcm(self.low.denominator, self.high.denominator)
        first, last = int(self.low * scale), int(self.high * scale)
        return first, (last - first) // FINE, scale

    @property
    def extremes(self) -> tuple[Value, ...]:
        return self.low, self.high

    @property
    def canonical(self) -> dict[str, str]:
        return {"low": str(self.low), "high": str(self.high)}


@dataclass(frozen=True)
class Parts:
    """`count` equal parts of the range from low to high; an entry of a study is one of them."""

    low: Fraction
    high: Fraction
    count: int

    def at(self, k: int) -> Value:
        """The middle of part number k."""
        return sum(self.ends(k), Fraction(0)) / 2

    def ends(self, k: int) -> tuple[Fraction, Fraction]:
        """Of part number k."""
        step = (self.high - self.low) / self.count
        return self.low + k * step, self.low + (k + 1) * step

    @property
    def extremes(self) -> tuple[Value, ...]:
        return self.low, self.high

    @property
    def canonical(self) -> Any:
        return {"low": str(self.low), "high": str(self.high), "parts": self.count}


Axis: TypeAlias = Listed | Steps | Span | Parts


def draws(kind: str, seed: int, index: int, number: int) -> list[int]:
    """`number` ≤ STREAMS whole numbers from 0 to FINE − 1 for the entry `index` of a design."""
    return random_draws(seed, index, number) if kind == "random" else quasi_random_draws(seed, index, number)


def random_draws(seed: int, index: int, number: int) -> list[int]:
    """Independent and uniform: the words of SHA-512 of seed and index, a counter-based generator without state."""
    words = hashlib.sha512(f"{seed}/{index}".encode("ascii")).digest()
    return [(int.from_bytes(words[8 * j : 8 * j + 8], "big") * FINE) >> 64 for j in range(number)]


def quasi_random_draws(seed: int, index: int, number: int) -> list[int]:
    """Halton's sequence in the first primes, rounded down, and shifted modulo 1 by a random vector of the seed."""
    return [
        (radical_inverse(index, base) + shift) % FINE
        for base, shift in zip(_PRIMES[:number], _shifts(seed), strict=False)
    ]


@lru_cache(maxsize=4)  # the same for all entries of a design
def _shifts(seed: int) -> list[int]:
    return random_draws(seed, -1, STREAMS)


def radical_inverse(index: int, base: int) -> int:
    """⌊FINE·0.d₀d₁d₂…⌋, in `base`, where … d₂d₁d₀ are the digits of `index`."""
    mirrored, power = 0, 1
    while index:
        index, digit = divmod(index, base)
        mirrored, power = mirrored * base + digit, power * base
    return mirrored * FINE // power
