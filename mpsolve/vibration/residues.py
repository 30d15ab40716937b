"""Residues of the image at its poles, by small circles round them: of any multiplicity, without derivatives."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from mpsolve.numbers.arrays import Complexes

_POINTS = 32
_SHARE = 0.3
_WIDE = 10.0
_TOGETHER = 1e-5
"""Relative: poles that are nearer have one circle, as their single residues would cancel."""
_LEFT = 1e-13
_LEAST = 1e-6


@dataclass(frozen=True)
class Mode:
    """Σ_m moments[m] t^m/m! e^{σt}: the part of a motion that a pole σ (scaled) contributes, with its mirror image.

    moments: (terms, channels).
    """

    sigma: complex
    multiplicity: int
    moments: Complexes

    def motion(self, times: Any) -> Any:
        """(channels, times), real."""
        total, power = 0, np.ones(len(times))
        for m, row in enumerate(self.moments):
            power = power * times / m if m else power
            total = total + np.multiply.outer(row, power)
        twice = 2.0 if self.sigma.imag > 0 else 1.0
        return twice * (total * np.exp(self.sigma * times)).real

    def most(self, time: float) -> Any:
        """By channels, no less than the size of the motion from this time ≥ 0 on; infinite where it grows."""
        decay, total = -self.sigma.real, 0 * np.abs(self.moments[0])
        for m, row in enumerate(self.moments):
            if decay < 0 or (m and decay == 0):
                return total + np.inf
            at = max(time, m / decay) if m else time  # t^m e^{σt} falls from m/|Re σ| on
            total = total + np.abs(row) * at**m / math.factorial(m) * math.exp(-decay * at)
        return 2 * total

    def rate(self, times: Any) -> Any:
        """d/dt of it."""
        later = np.concatenate([self.moments[1:], 0 * self.moments[:1]])
        return Mode(self.sigma, self.multiplicity, self.sigma * self.moments + later).motion(times)


@dataclass(frozen=True)
class Pole:
    """So many roots within `spread` of σ (scaled), Im σ ≥ 0. room: to the nearest cut; None: as far as to `floor`."""

    sigma: complex
    multiplicity: int = 1
    spread: float = 0.0
    room: float | None = None


def clustered(poles: Sequence[Pole]) -> list[Pole]:
    """Poles that are too near for residues of their own are taken together."""
    left, out = sorted(poles, key=lambda pole: (pole.sigma.imag, pole.sigma.real)), []
    while left:
        group = [left.pop(0)]
        near = _TOGETHER * abs(group[0].sigma)
        group += [pole for pole in left if abs(pole.sigma - group[0].sigma) < near]
        left = [pole for pole in left if pole not in group]
        number = sum(pole.multiplicity for pole in group)
        middle = sum(pole.multiplicity * pole.sigma for pole in group) / number
        spread = max(abs(pole.sigma - middle) + (pole.spread if pole.multiplicity > 1 else 0.0) for pole in group)
        rooms = [pole.room for pole in group if pole.room is not None]
        middle = middle if len(group) > 1 else group[0].sigma
        out.append(Pole(middle, number, spread if number > 1 else 0.0, min(rooms, default=None)))
    return out


def modes(
    image: Callable[[Any], Any], poles: Sequence[Pole], others: Any, floor: float, last: float
) -> tuple[Mode, ...]:
    """The residues of `image`, (len(σ), channels), at the poles, for times up to `last`.

    others: further poles, on the axis; floor: the image is analytic in Re σ > floor but for poles and others, and
    round a pole with a room as far as that. Other roots are at least _LEAST of |σ| away from a pole.
    """
    groups = clustered(poles)
    if not groups:
        return ()
    middles = np.array([pole.sigma for pole in groups])
    spreads = np.array([pole.spread for pole in groups])
    known = np.concatenate([middles, middles.conj(), np.asarray(others, complex), np.conj(others)])
    apart = np.abs(middles[:, None] - known)
    apart[apart <= 1e-13 * np.abs(middles)[:, None]] = np.inf
    free = [pole.sigma.real - floor if pole.room is None else pole.room for pole in groups]
    rooms = np.maximum(free, _LEAST * np.abs(middles))
    radius = _SHARE * np.minimum(apart.min(1), rooms)
    radius = np.where(spreads > 0, np.minimum(radius, np.maximum(_WIDE * spreads, 1e-2 * radius)), radius)
    turn = np.exp(2j * np.pi * (np.arange(_POINTS) + 0.5) / _POINTS)
    circle = radius[:, None] * turn
    values = image((middles[:, None] + circle).ravel()).reshape(len(groups), _POINTS, -1)
    out = []
    for k, pole in enumerate(groups):
        powers = [circle[k] ** (m + 1) for m in range(_terms(pole, last))]
        out.append(Mode(pole.sigma, pole.multiplicity, np.array([power @ values[k] / _POINTS for power in powers])))
    return tuple(out)


def _terms(pole: Pole, last: float) -> int:
    """How many powers of t tell the roots of a cluster from one multiple root at its middle."""
    size, n = 1.0, 0
    while n < pole.multiplicity or (size > _LEFT and n < _POINTS - 4):
        n += 1
        size *= pole.spread * last / n
    return n
