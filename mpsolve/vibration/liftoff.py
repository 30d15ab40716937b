"""When a wheel first leaves the rail: the first zero of a contact force, found on the motion and not on a grid."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass
from typing import Any

import numpy as np

from mpsolve.errors import InputError
from mpsolve.numbers.arrays import Reals
from mpsolve.numbers.float64 import lowest
from mpsolve.vibration.integral import CLEAR
from mpsolve.vibration.poles import natural
from mpsolve.vibration.solution import Solution

_PER_PERIOD, _EARLY = 16, 40
_CHUNK = 1024
_MOST = 10**7  # steps
_PRESSED = 1e-9
"""Of the largest static force: a contact with less is pressed by nothing."""
_SHARP = 1e-13
_PARTS, _ROUNDS, _ROUGH, _ZOOMS = 16, 12, 6, 3
_CALM = 0.9
"""Of the static force: once nothing swings that far any more, no wheel lifts off."""
_LOW = 0.1
"""Of the largest sample: a dip that comes lower is looked at closely."""


@dataclass(frozen=True)
class Event:
    """The contact (from rear to front, counted from 1) whose force comes to 0 first, and when.

    tolerance: by which the time may be off, an estimate: as far as the force may be off.
    """

    time: float
    contact: int
    tolerance: float


def first_lift_off(solution: Solution, last: float) -> Event | None:
    """In the problem's units, up to the time `last`; only contacts that static forces press are judged.

    At t = 0 where a force begins below 0. None where none comes lower than its own error allows.
    """
    image, (static, presses) = solution.image, _static(solution)
    pressed = image.size + np.flatnonzero(presses)
    if not len(pressed) or last <= 0:
        return None
    some = solution.only(pressed)
    noise = solution.error[pressed] + 1e-13 * static[pressed]
    above: list[float | None] = [None] * len(pressed)
    for grid in _grids(solution, last * image.rate):
        falls = []
        for j, row in enumerate(some.moved(grid) + some.held[:, None]):
            fall = first_fall(_row(some, j), grid, row, float(noise[j]), above[j])
            if fall is not None:
                falls.append((fall.time, j, fall.off))
            above[j] = last_above(grid, row, noise[j], above[j])
        if falls:
            time, j, off = min(falls)
            return Event(time / image.rate, int(pressed[j] - image.size) + 1, (off + _SHARP * time) / image.rate)
        if np.all(some.swing(grid[-1]) < _CALM * static[pressed]):
            break
    return None


def unjudged(solution: Solution) -> tuple[int, ...]:
    """The contacts that no static force presses, from rear to front, counted from 1: with them it is not told."""
    return tuple((np.flatnonzero(~_static(solution)[1]) + 1).tolist())


def _static(solution: Solution) -> tuple[Any, Any]:
    """The static part of all rows, and which contacts it presses."""
    image = solution.image
    static = solution.held + sum(
        (one.amplitude.real for one in solution.steady if not one.frequency), 0 * solution.held
    )
    force = static[image.size : image.size + image.contacts]
    return static, force > _PRESSED * np.abs(force).max()


def _row(some: Solution, j: int) -> Callable[[Any], Any]:
    return lambda times: some.moved(times)[j] + some.held[j]


def early_times(solution: Solution, last: float) -> Reals:
    """Times t̂ up to the last at which the motion must be known, and is not, for its first steps; none if it is."""
    step = _step(solution)
    if CLEAR / solution.line.omega <= step or last <= step:
        return np.zeros(0)
    return np.geomspace(step / 2, last, _EARLY)


def _step(solution: Solution) -> float:
    """Well below the fastest period."""
    fast = [one.frequency for one in solution.steady] + [abs(mode.sigma) for mode in solution.modes]
    return float(2 * np.pi / (_PER_PERIOD * max(1.0, natural(solution.image), *fast)))


def _grids(solution: Solution, last: float) -> Iterator[Any]:
    """Times in pieces that share their ends: first geometric ones, then equal steps."""
    image, step = solution.image, _step(solution)
    start = min(CLEAR / solution.line.omega, last)
    ends = np.geomspace(start, max(min(step, last), start * 1.01), 24) if start < last else np.array([start])
    if last - ends[-1] > _MOST * step:
        stated = f"end at {last / image.rate:.3g} s, after more than {_MOST:.0e} steps of the fastest vibration"
        raise InputError("times", f"{stated}: give a shorter time")
    times = np.concatenate([ends, np.arange(ends[-1], last, step)[1:], [last]])
    times = np.unique(times[times <= last])
    for k in range(0, max(1, len(times) - 1), _CHUNK):
        yield times[k : k + _CHUNK + 2]  # a dip at an end is within one of them


@dataclass(frozen=True)
class Fall:
    """The time of a zero, and by how much it may be off."""

    time: float
    off: float


def first_fall(f: Callable[[Any], Any], grid: Reals, row: Any, noise: float, above: float | None) -> Fall | None:
    """The first one on this grid, of which `row` are the values of f; None where f stays above −noise.

    above: the last time before the grid at which f was above the noise, None where there is none: then f was 0 from
    t = 0 on, as far as can be told, and falls at once. A fall by less than the noise is none.
    """
    below = np.flatnonzero(row < -noise)
    stop = int(below[0]) if len(below) else len(row)
    inner = np.arange(1, min(stop, len(row) - 1))
    low = (row[inner] < np.minimum(row[inner - 1], row[inner + 1])) & (row[inner] < _LOW * np.abs(row).max())
    for k in inner[low]:
        at, value = lowest(f, np.linspace(grid[k - 1], grid[k + 1], 2 * _PARTS + 1), 2 * _PARTS + 1, _ZOOMS)
        if value < -noise:
            return _between(f, last_above(grid[:k], row[:k], noise, above), at, noise)
    if not len(below):
        return None
    return _between(f, last_above(grid[:stop], row[:stop], noise, above), float(grid[stop]), noise)


def last_above(grid: Reals, row: Any, noise: float, before: float | None) -> float | None:
    """The last time of the grid at which the row is above the noise, else `before`."""
    pressed = np.flatnonzero(row > noise)
    return float(grid[pressed[-1]]) if len(pressed) else before


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
