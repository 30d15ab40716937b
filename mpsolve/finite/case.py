"""A finite track with its loads, times and places, checked; its motion read at the times, for any modes and steps."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import replace
from functools import cached_property
from typing import TYPE_CHECKING, Any

import numpy as np

from mpsolve.errors import InputError
from mpsolve.finite.answer import Answer, hermite, slopes
from mpsolve.finite.carriage import Carriage, carriage
from mpsolve.finite.discretization import compliance_beyond, discretized
from mpsolve.finite.exponentials import exponentials
from mpsolve.finite.march import Motion, Setting, march
from mpsolve.numbers.arrays import Integers, Reals
from mpsolve.numbers.float_list import float_list
from mpsolve.parallel.threads import one_thread
from mpsolve.problem.problem import Problem, require_problem
from mpsolve.proof.effort import Effort
from mpsolve.tracks.at_rest import require_stable
from mpsolve.vehicles.loads import outer_forces
from mpsolve.vibration.forcing import checked_irregularities

if TYPE_CHECKING:
    from mpsolve.vehicles.load import Load

FEWEST_STEPS = 16
MOST_STEPS = 1_000_000
MOST_WORK = 1e9
"""Most modes times steps of one march: some minutes."""
ENOUGH = 16
"""Times that see the largest error; a change at fewer ones may be small by chance."""
MOST_INTERVALS = 4000
"""Of times at equal distances, of which every one is made the end of a step."""
_GAUSS = np.array([-1, 1]) / math.sqrt(3)


class Case:
    """A problem with its loads and the times and places asked for, checked; float64."""

    def __init__(
        self,
        problem: Problem,
        loads: Sequence[Load],
        length: float,
        times: Reals,
        places: Reals,
        start: Any,
        tolerance: float,
        steady: bool = False,
        unilateral: bool = False,
        irregularities: Any = None,
    ) -> None:
        require_problem(problem)
        self.pencil = problem.pencil
        self.waveguide = problem.track.waveguide
        require_stable(problem.track)
        self.outer = outer_forces(self.pencil, loads)
        self.times = _ascending(times)
        self.contacts = np.array(self.pencil.places, float)
        self.places = self.contacts if places is None else float_list(places, "places")
        self.velocity = float(problem.v)
        self.tolerance = share(tolerance, "tolerance")
        self.length = positive(length, "length")
        self.origin = self._placed(start)
        self.carriage: Carriage = carriage(self.pencil)
        self.carriage.force(self.outer.direction)  # refused before any work
        self.steady, self.unilateral = steady, unilateral
        self.rough = checked_irregularities(irregularities, len(self.contacts))
        if unilateral and not all(self.pencil.h):
            raise InputError("unilateral", "asks for contacts that open, but one is tight: give every k_contact")

    @cached_property
    def watched(self) -> Reals:
        """The times, and where they are few some more before the last one."""
        more = self.duration * np.arange(ENOUGH // 2, ENOUGH) / ENOUGH
        return np.union1d(self.times, more if len(self.times) < ENOUGH else [])

    @property
    def asked(self) -> Integers:
        """Where the times are among those watched."""
        return np.searchsorted(self.watched, self.times)

    @property
    def duration(self) -> float:
        return float(self.times[-1])

    def _placed(self, start: Any) -> float:
        """The origin at t = 0; InputError where contacts or places would not stay on the track."""
        every = np.concatenate([self.contacts, self.places])
        low, high = float(every.min()), float(every.max())
        reach = high - low + self.velocity * self.duration
        margin = (self.length - reach) / 2 if start is None else positive(start, "start") + low
        if margin <= 0 and start is not None:
            raise InputError("start", f"is {margin - low:g}, but the rearmost point is {-low:g} behind it: raise it")
        needed = reach + max(margin, 0.0)
        if self.length <= needed:
            stated = f"is {self.length:g}, but contacts and places cover {needed:g} from the left support"
            raise InputError("length", f"{stated} by the last time: give more than {needed:g}, or end times earlier")
        return margin - low

    @property
    def first_steps(self) -> int:
        """Few, and so that times at equal distances are ends of steps, where nothing is interpolated."""
        fastest = max([self.outer.fastest, *(abs(one.frequency) for one in self.rough if one.amplitude)])
        least, every = max(FEWEST_STEPS, math.ceil(self.duration * fastest)), _intervals(self.times)
        return math.ceil(least / every) * every

    def solve(
        self, modes: int, steps: int, effort: Effort | None = None, guided: bool = False, beyond: bool = False
    ) -> Answer:
        """The answer with these figures, or between guided ends; InputError where they are too many.

        beyond: the modes beyond these give way, too, as if the contact forces were constant.
        """
        if modes * steps > MOST_WORK or steps > MOST_STEPS:
            stated = f"needs {steps} steps or more of {modes} modes for its tolerance, beyond what is computed"
            raise InputError("times", f"{stated}: end earlier, raise tolerance, or lower modes or steps")
        track, vehicle = discretized(self.waveguide, self.length, modes, guided), self.carriage
        if beyond:
            away = np.concatenate([self.contacts, self.places])[:, None] - self.contacts
            give = compliance_beyond(track, self.velocity, away)
            vehicle = replace(vehicle, H=vehicle.H + give[: len(self.contacts)])
        setting = Setting(
            exponentials(track), self.length, vehicle, self.outer, self.contacts, self.places, self.origin,
            self.velocity, self.duration, self.steady, self.unilateral, self.rough,
        )  # fmt: skip
        with np.errstate(over="ignore", invalid="ignore"), one_thread():
            try:
                found = self._read(march(setting, steps, effort))
            except np.linalg.LinAlgError:
                stated = (
                    "have contact forces that are not determined, such as two tight contacts of one body at a place"
                )
                raise InputError("vehicles", f"{stated}: move a contact, or give k_contact") from None
        if not all(np.isfinite(rows).all() for rows in (found.rail, found.vehicle, found.force)):
            raise InputError("times", f"reaches {self.duration:g}, where the motion overflows: end earlier")
        return replace(found, rail=found.rail + give[len(self.contacts) :] @ found.force) if beyond else found

    def unknown(self) -> Answer:
        """No number of it is one."""
        rows = (len(self.places), len(self.pencil.names), len(self.contacts))
        rail, vehicle, force = (np.full((n, len(self.watched)), np.nan) for n in rows)
        return Answer(rail, vehicle, force, np.zeros(0), np.zeros((len(self.contacts), 0)))

    def _read(self, motion: Motion) -> Answer:
        """The motion at the times watched; forces by their values at the Gauss points of the steps."""
        h = motion.times[1]
        nodes = ((motion.times[:-1] + h / 2)[:, None] + h / 2 * _GAUSS).ravel()
        values = motion.force[:, 0, :, None] + motion.force[:, 1, :, None] * _GAUSS
        values = values.reshape(len(self.contacts), -1)
        first = 0 * values[:, :1]
        if self.carriage.first or self.steady:  # a massless wheel is pressed on the rail at once
            first = values[:, :1] - (values[:, 1:2] - values[:, :1]) * (nodes[0] / (nodes[1] - nodes[0]))
        last = values[:, -1:] + (values[:, -1:] - values[:, -2:-1]) * (nodes[0] / (nodes[1] - nodes[0]))
        nodes = np.concatenate([[0.0], nodes, motion.times[-1:]])
        values = np.concatenate([first, values, last], axis=1)
        force = hermite(nodes, values, np.gradient(values, nodes, axis=1), self.watched)
        if self.unilateral:
            force = np.maximum(force, 0.0)  # between steps at which the force jumps, interpolation overshoots
        kept = hermite(motion.times, motion.state, motion.state_rate, self.watched)
        rail = hermite(motion.times, motion.rail, slopes(motion.rail, h), self.watched)
        return Answer(rail, self.carriage.motion @ kept - self.carriage.give @ force, force, nodes, values)


def _intervals(times: Reals) -> int:
    """Of how many equal parts of 0 to the last time every time is an end; 1 where of none, or of too many."""
    shares = times / times[-1]
    count = max(1, round(1 / np.diff(shares, prepend=0.0)[shares > 0].min()))
    places = shares * count
    return count if count <= MOST_INTERVALS and np.abs(places - np.round(places)).max() < 1e-9 * count else 1


def _ascending(times: Reals) -> Reals:
    found = float_list(times, "times")
    if not found.size or found[0] < 0 or found[-1] <= 0 or np.any(np.diff(found) <= 0):
        raise InputError("times", "is not an ascending list of times from 0 on: give at least one time above 0")
    return found


def share(value: Any, key: str) -> float:
    """An error that is accepted, above 0 and below 1."""
    number = positive(value, key)
    if number >= 1:
        raise InputError(key, f"is {number:g}, not below 1: give the error accepted, as a share")
    return number


def positive(value: Any, key: str) -> float:
    number = float(float_list([value], key)[0])
    if number <= 0:
        raise InputError(key, f"is {number:g}, not above 0: give a positive one")
    return number
