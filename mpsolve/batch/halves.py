"""A beam whose cuts lie on one line, in float64: the two halves of its whole sheet as one group.

As in problem/line.py: z = q − iη, η = c/2m, and on both sides of the line Im z = 0 the track is undamped. Below it
run the vehicles S(τ − η), above it, mirrored to z̄, the vehicles S(−τ − η) transposed.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, replace
from functools import cached_property
from typing import Any

import numpy as np

from mpsolve.batch.entries import Entries
from mpsolve.batch.groups import Group, groups_of
from mpsolve.numbers.arrays import Integers, Reals

_NAMES = ("EI", "m", "k", "c", "kp", "N", "eta")


@dataclass(frozen=True)
class Halves:
    """K entries: row j of `group` is the lower half of entry j, row j + K the upper one. height: η, scaled."""

    group: Group
    height: Reals

    def __len__(self) -> int:
        return len(self.height)

    def __getitem__(self, rows: Any) -> Halves:
        chosen = np.arange(len(self))[rows]
        return Halves(self.group[np.concatenate([chosen, chosen + len(self)])], self.height[chosen])

    @property
    def index(self) -> Integers:
        """The entries in their batch."""
        return self.group.index[: len(self)]

    @property
    def unit(self) -> Reals:
        return self.group.unit[: len(self)]

    @cached_property
    def beam(self) -> tuple[Reals, Reals, Reals, Reals, Reals]:
        """EI, T − mv², k, m and v of D = EI p⁴ + T p² + k − m Ω², undamped and scaled."""
        D = self.group.D[: len(self)]
        return D[:, 4, 0], -D[:, 2, 0], D[:, 0, 0], D[:, 0, 2], self.group.v[: len(self)]

    @cached_property
    def limit(self) -> Reals:
        """The tip of the right cut; zero or negative where the cuts of both sides are joined.

        The least Ω(p) − vp: with y = p², y (2EI y + T)² = v²m (EI y² + T y + k).
        """
        EI, c2, k, m, v = self.beam
        push = m * v * v
        T = c2 + push
        y = largest_real_root((4 * EI * T - push * EI) / (4 * EI * EI), T * (T - push) / (4 * EI * EI),
                              -push * k / (4 * EI * EI))  # fmt: skip
        y = np.maximum(y, np.maximum(-T / (2 * EI), 0))
        return np.sqrt(((EI * y + T) * y + k) / m) - v * np.sqrt(y)

    @cached_property
    def far(self) -> Any:
        """A z from where on waves are short beside the gaps, and masses reflect them as rigid ends do."""
        EI, c2, k, m, v = self.beam
        push = m * v * v
        size = np.maximum(np.sqrt((k + m * self.height**2) / (4 * EI)), (np.abs(c2 + push) + push) / (4 * EI))
        gaps = np.diff(self.group.x[: len(self)])
        nearest = np.where(gaps > 0, gaps, np.inf).min(1, initial=np.inf)
        return np.maximum(2.5 / nearest, 4 * np.sqrt(size)) ** 2 * np.sqrt(EI / m)


def largest_real_root(a2: Reals, a1: Reals, a0: Reals) -> Reals:
    """The largest real root of y³ + a2 y² + a1 y + a0, real arrays, by Cardano's and Viète's formulas."""
    p, q = a1 - a2 * a2 / 3, a2 * (2 * a2 * a2 / 27 - a1 / 3) + a0
    square = q * q / 4 + p * p * p / 27
    root = np.sqrt(np.maximum(square, 0))
    cube = np.cbrt(-q / 2 - np.copysign(root, q))
    one = cube - p / (3 * np.where(cube == 0, 1, cube))
    size = np.sqrt(np.maximum(-p / 3, 0))
    size3 = size * size * size
    cosine = np.clip(-q / 2 / np.where(size3 == 0, 1, size3), -1, 1)
    y = np.where(square > 0, one, 2 * size * np.cos(np.arccos(cosine) / 3)) - a2 / 3
    for _ in range(2):
        slope = (3 * y + 2 * a2) * y + a1
        y = y - np.where(slope > 0, ((y + a2) * y + a1) * y + a0, 0) / np.where(slope > 0, slope, 1)
    return y


def on_line(entries: Entries) -> Any:
    """Which entries have their cuts on one line: no damping of the rail, less than critical, and no buckling."""
    EI, m, k, c, kp, N, eta = (np.broadcast_to(entries.track[name], len(entries)) for name in _NAMES)
    with np.errstate(all="ignore"):
        rest = k - c * c / (4 * m)
        return (eta == 0) & (rest > 0) & (N - kp < 2 * np.sqrt(EI * np.maximum(rest, 0)))


def halves_of(entries: Entries, rows: Any) -> Iterator[Halves]:
    """The entries `rows`, whose cuts lie on one line, in groups."""
    m, k, c = (np.broadcast_to(entries.track[name], len(entries)) for name in ("m", "k", "c"))
    undamped = {**entries.track, "c": np.zeros(len(entries)), "k": k - c * c / (4 * m)}
    for group in groups_of(replace(entries, track=undamped), rows)[0]:
        height = c[group.index] / (2 * m[group.index]) / group.unit
        eta = height[:, None, None]
        S0, S1 = group.S0 - eta * group.S1 + eta**2 * group.S2, group.S1 - 2 * eta * group.S2
        both = group[np.tile(np.arange(len(group)), 2)]
        yield Halves(replace(both, S0=np.concatenate([S0, S0]), S1=np.concatenate([S1, -S1])), height)
