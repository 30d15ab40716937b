"""When a function first falls from above 0 to below it, by as much as its error: sampled, and refined at each dip."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

import numpy as np

_PARTS, _ROUNDS, _ROUGH, _ZOOMS = 16, 12, 6, 3
_LOW = 0.1
"""Of the largest sample: a dip that comes lower is looked at closely."""


@dataclass(frozen=True)
class Fall:
    """The time of a zero, and by how much it may be off."""

    time: float
    off: float


def first_fall(f: Callable[[Any], Any], grid: Any, row: Any, noise: float, above: float | None) -> Fall | None:
    """The first one on this grid, of which `row` are the values of f; None where f stays above −noise.

    above: the last time before the grid at which f was above the noise, None where there is none: then f was 0 from
    t = 0 on, as far as can be told, and falls at once. A fall by less than the noise is none.
    """
    below = np.flatnonzero(row < -noise)
    stop = int(below[0]) if len(below) else len(row)
    inner = np.arange(1, min(stop, len(row) - 1))
    low = (row[inner] < np.minimum(row[inner - 1], row[inner + 1])) & (row[inner] < _LOW * np.abs(row).max())
    for k in inner[low]:
        at, value = _lowest(f, grid[k - 1], grid[k + 1])
        if value < -noise:
            return _between(f, last_above(grid[:k], row[:k], noise, above), at, noise)
    if not len(below):
        return None
    return _between(f, last_above(grid[:stop], row[:stop], noise, above), float(grid[stop]), noise)


def last_above(grid: Any, row: Any, noise: float, before: float | None) -> float | None:
    """The last time of the grid at which the row is above the noise, else `before`."""
    pressed = np.flatnonzero(row > noise)
    return float(grid[pressed[-1]]) if len(pressed) else before


def _lowest(f: Callable[[Any], Any], left: float, right: float) -> tuple[float, float]:
    """The least value between, and its time."""
    for _ in range(_ZOOMS):
        inner = np.linspace(left, right, 2 * _PARTS + 1)
        values = f(inner)
        k = int(np.argmin(values))
        left, right = inner[max(0, k - 1)], inner[min(len(inner) - 1, k + 1)]
    return float(inner[k]), float(values[k])


def _between(f: Callable[[Any], Any], left: float | None, right: float, noise: float) -> Fall:
    """The zero between a time above the noise and one below it, and how far off it is where f is off by the noise."""
    if left is None:
        return Fall(0.0, right)
    time = _crossing(f, left, right, 0.0, _ROUNDS)
    early, late = (_crossing(f, left, right, level, _ROUGH) for level in (noise, -noise))
    return Fall(time, max(time - early, late - time) + (right - left) * _PARTS**-_ROUGH)


def _crossing(f: Callable[[Any], Any], left: float, right: float, level: float, rounds: int) -> float:
    """The first time at which f is at the level or below, as it is at the right end."""
    for _ in range(rounds):
        inner = np.linspace(left, right, _PARTS + 1)
        reached = f(inner)[1:] <= level
        k = int(np.argmax(reached)) if reached.any() else _PARTS - 1
        left, right = float(inner[k]), float(inner[k + 1])
    return right
