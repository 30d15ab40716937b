"""When a wheel first leaves the rail: the first zero of a contact force, found on the motion and not on a grid."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass, replace
from typing import Any

import numpy as np

from mpsolve.errors import InputError
from mpsolve.vibration.engine import Solution
from mpsolve.vibration.fall import first_fall, last_above
from mpsolve.vibration.integral import CLEAR
from mpsolve.vibration.poles import natural

_PER_PERIOD, _EARLY = 16, 40
_CHUNK = 1024
_MOST = 10**7  # steps
_PRESSED = 1e-9
"""Of the largest static force: a contact with less is pressed by nothing."""
_SHARP = 1e-13


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
    above: list[float | None] = [None] * len(pressed)
    for grid in _grids(solution, last * image.rate):
        falls = []
        for j, row in enumerate(some(grid)):
            fall = first_fall(_row(some, j), grid, row, float(noise[j]), above[j])
            if fall is not None:
                falls.append((fall.time, j, fall.off))
            above[j] = last_above(grid, row, noise[j], above[j])
        if falls:
            time, j, off = min(falls)
            return Event(time / image.rate, int(pressed[j] - image.size) + 1, (off + _SHARP * time) / image.rate)
    return None


def _row(some: Callable[[Any], Any], j: int) -> Callable[[Any], Any]:
    return lambda times: some(times)[j]


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


def early_times(solution: Solution, last: float) -> Any:
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
