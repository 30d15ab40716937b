"""When a wheel first leaves the rail: the first zero of a contact force, found on the motion and not on a grid."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass, replace
from typing import Any

import numpy as np

from mpsolve.errors import InputError
from mpsolve.vibration.engine import Solution
from mpsolve.vibration.line import CLEAR
from mpsolve.vibration.poles import natural

_PER_PERIOD = 16
_CHUNK = 1024
_MOST = 10**7  # steps
_HALVINGS = 60
_PRESSED = 1e-9
"""Of the largest static force: a contact with less is pressed by nothing."""
_SHARP = 1e-13


@dataclass(frozen=True)
class Event:
    """The contact (from rear to front, counted from 1) whose force comes to 0 first, and when.

    tolerance: by which the time may be off, an estimate.
    """

    time: float
    contact: int
    tolerance: float


def first_lift_off(solution: Solution, last: float) -> Event | None:
    """In the problem's units, up to the time `last`; only contacts that static forces press are judged."""
    image = solution.image
    force = np.arange(image.size, image.size + image.contacts)
    static = solution.held + sum(
        (one.amplitude.real for one in solution.steady if not one.frequency), 0 * solution.held
    )
    pressed = force[static[force] > _PRESSED * np.abs(static[force]).max()]
    if not len(pressed) or last <= 0:
        return None
    some = only(solution, pressed)
    noise = solution.error[pressed] + 1e-13 * static[pressed]
    for grid in _grids(solution, last * image.rate):
        values = some(grid)
        found = [_root(some, j, grid, row, noise[j]) for j, row in enumerate(values)]
        times = [(time, j) for j, time in enumerate(found) if time is not None]
        if times:
            time, j = min(times)
            step = max(1e-9 * time, 1e-12)
            ends = some(np.array([time - step, time + step]))[j]
            slope = abs(ends[1] - ends[0]) / (2 * step)
            off = noise[j] / slope if slope else 0.0
            return Event(time / image.rate, int(pressed[j] - image.size) + 1, (off + _SHARP * time) / image.rate)
    return None


def only(solution: Solution, channels: Any) -> Callable[[Any], Any]:
    """The motion of some channels at times > 0, (channels, times), without what they do not need."""
    line = solution.line.only(channels)
    whole = [*solution.steady] if line.path.below else []
    right, _ = line.path.parted(solution.modes)

    def motion(times: Any) -> Any:
        total = line.motion(times) + solution.held[channels][:, None]
        for one in whole:
            total = total + (one.amplitude[channels][:, None] * np.exp(1j * one.frequency * times)).real
        for mode in right:
            total = total + replace(mode, moments=mode.moments[:, channels]).motion(times)
        return total

    return motion


def _grids(solution: Solution, last: float) -> Iterator[Any]:
    """Times in pieces that share their ends: first geometric ones, then equal steps well below the fastest period."""
    image = solution.image
    fast = [one.frequency for one in solution.steady] + [abs(mode.sigma) for mode in solution.modes]
    step = 2 * np.pi / (_PER_PERIOD * max(1.0, natural(image), *fast))
    start = min(CLEAR / solution.line.omega, last)
    ends = np.geomspace(start, max(min(step, last), start * 1.01), 24) if start < last else np.array([start])
    if last - ends[-1] > _MOST * step:
        stated = f"end at {last / image.rate:.3g} s, after more than {_MOST:.0e} steps of the fastest vibration"
        raise InputError("times", f"{stated}: give a shorter time")
    times = np.concatenate([ends, np.arange(ends[-1], last, step)[1:], [last]])
    times = np.unique(times[times <= last])
    for k in range(0, max(1, len(times) - 1), _CHUNK):
        yield times[k : k + _CHUNK + 1]


def _root(some: Any, j: int, grid: Any, row: Any, noise: float) -> float | None:
    """The first time at which the row comes from above the noise to below 0, or None."""
    for k in range(1, len(grid)):
        if row[k] < -noise and row[k - 1] > 0:
            return _bisected(some, j, grid[k - 1], grid[k])
        if 0 < k < len(grid) - 1 and row[k] < min(row[k - 1], row[k + 1]) and 0 <= row[k] < 0.1 * abs(row).max():
            inner = np.linspace(grid[k - 1], grid[k + 1], 33)
            values = some(inner)[j]
            low = int(np.argmin(values))
            if values[low] < -noise:
                return _bisected(some, j, grid[k - 1], inner[low])
    return None


def _bisected(some: Any, j: int, left: float, right: float) -> float:
    """Between a positive and a negative value, by the secant's point where it halves at least."""
    a, b = left, right
    fa, fb = some(np.array([a, b]))[j]
    for turn in range(_HALVINGS):
        middle = (a + b) / 2 if turn % 3 == 2 or fa == fb else a + (b - a) * fa / (fa - fb)
        value = float(some(np.array([middle]))[j, 0])
        if value > 0:
            a, fa = middle, value
        else:
            b, fb = middle, value
        if b - a <= _SHARP * b or value == 0:
            break
    return float(b)
