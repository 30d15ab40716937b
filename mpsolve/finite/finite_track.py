"""The motion of any vehicle on a finite, simply supported piece of any track, with its errors estimated."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Any

import numpy as np

from mpsolve.errors import InputError
from mpsolve.finite.carriage import Carriage, carriage
from mpsolve.finite.discretization import discretized
from mpsolve.finite.exponentials import exponentials
from mpsolve.finite.march import Motion, Setting, march
from mpsolve.motion.beam_figures import hermite
from mpsolve.motion.grid import float_list
from mpsolve.parallel.threads import one_thread
from mpsolve.problem.problem import Problem
from mpsolve.tracks.at_rest import Status, at_rest
from mpsolve.vehicles.loads import outer_forces
from mpsolve.vibration.liftoff import Event

FEWEST_STEPS, FEWEST_MODES = 16, 8
MOST_STEPS, MOST_MODES = 1_000_000, 40_000
MOST_WORK = 1e9
"""Most modes times steps of one march: some minutes."""
_HELD = 1.1
"""Where an error halves with twice as many modes, the change is the error itself; it is not always so even."""
_GAUSS = np.array([-1, 1]) / math.sqrt(3)


@dataclass(frozen=True)
class FiniteTrackError:
    """Estimates of errors, none of them a bound: the largest changes from half as many steps, and half as many modes.

    time, modes: of the deflections of the rail, in units of length; vehicle: of the coordinates of the vehicles, the
    sum of both, each in its own unit; force: of the contact forces, the sum of both. They tell of the finite track:
    another length shows how much its supports are felt.
    """

    time: float
    modes: float
    vehicle: float
    force: float

    @property
    def total(self) -> float:
        """The sum of the two errors of the rail."""
        return self.time + self.modes


@dataclass(frozen=True)
class FiniteTrackMotion:
    """Float64 results on a finite track, not proved, in the units of the problem.

    times (t,). rail (p, t): deflections under the `places` of the moving frame. vehicle: for each coordinate by name
    (t,). contact_force (n, t): from rear to front, compression positive. start: the origin of the moving frame at
    t = 0, from the left support; length, modes, steps: the figures used. lift_off: when a contact
    force first comes to 0, between steps; without `unilateral` what comes later is beyond the model.
    """

    times: Any
    places: Any
    rail: Any
    vehicle: dict[str, Any]
    contact_force: Any
    error: FiniteTrackError
    start: float
    length: float
    modes: int
    steps: int
    lift_off: Event | None = None


def finite_track(
    problem: Problem,
    loads: Any = None,
    *,
    length: Any,
    modes: int,
    times: Any,
    places: Any = None,
    start: Any = None,
    steps: int | None = None,
    tolerance: float = 1e-4,
    initial: str = "rest",
    unilateral: bool = False,
) -> FiniteTrackMotion:
    """The motion from rest of the vehicles on a simply supported track of this length; float64, errors estimated.

    loads: one `Load` for each contact from rear to front, or a dict of Loads by names of coordinates, in units of the
    problem (SI: N, rad/s); without them the weights act, suddenly from t = 0 on. times ≥ 0, ascending. places: of the
    moving frame, by default the contacts. start: of the origin of the moving frame from the left support; without it
    the load begins and ends equally far from the supports. steps: equal ones up to the last time; without them they
    are doubled until the error that they cause is below `tolerance` of the largest deflection. initial: "rest", or
    "steady", where constant loads have acted for ever. unilateral: contacts push only, so that wheels may leave the
    rail and come back; each needs a Hertz spring k_contact. Events are then met to a step: look at `error`.

    InputError names the argument that cannot be used: for a track that the load would leave, the length needed.

    >>> from mpsolve import Problem, tracks, vehicles
    >>> beam = tracks.EulerBernoulli(EI="6.4e6", m=60, k="1e6", c="2e4")
    >>> found = finite_track(Problem(beam, vehicles.Mass(1000), v=30), length=60, modes=100, times=[0, "0.5"])
    >>> found.rail.round(4)
    array([[0.    , 0.0021]])
    """
    if initial not in ("rest", "steady"):
        raise InputError("initial", f"is {initial!r}: give 'rest' or 'steady'")
    case = _Case(problem, loads, length, times, places, start, tolerance, initial == "steady", bool(unilateral))
    count = _count(modes, "modes", FEWEST_MODES, MOST_MODES)
    if steps is None:
        used, found, late = _settled(case, count)
    else:
        used = _count(steps, "steps", FEWEST_STEPS, MOST_STEPS)
        found = case.solve(count, used)
        late = found.change(case.solve(count, used // 2))
    cut = found.change(case.solve(count // 2, used))
    names = case.pencil.names
    return FiniteTrackMotion(
        times=case.times,
        places=case.places,
        rail=found.rail,
        vehicle=dict(zip(names, found.vehicle, strict=True)),
        contact_force=found.force,
        error=FiniteTrackError(*(_HELD * x for x in (late[0], cut[0], late[1] + cut[1], late[2] + cut[2]))),
        start=case.origin,
        length=case.length,
        modes=count,
        steps=used,
        lift_off=_event(found, _HELD * (late[2] + cut[2]), case.duration / used),
    )


@dataclass(frozen=True)
class _Answer:
    """At the times: rail (p, t), vehicle (size, t), force (n, t); forces (n, nodes) at the nodes of the steps."""

    rail: Any
    vehicle: Any
    force: Any
    nodes: Any
    forces: Any

    def change(self, other: _Answer) -> tuple[float, float, float]:
        pairs = ((self.rail, other.rail), (self.vehicle, other.vehicle), (self.force, other.force))
        a, b, c = (float(np.max(np.abs(one - two), initial=0.0)) for one, two in pairs)
        return a, b, c

    def near(self, other: _Answer, tolerance: float) -> bool:
        rail, vehicle, _ = self.change(other)
        return rail <= tolerance * _largest(self.rail) and vehicle <= tolerance * _largest(self.vehicle)


def _largest(rows: Any) -> float:
    return float(np.max(np.abs(rows), initial=0.0))


def _settled(case: _Case, modes: int) -> tuple[int, _Answer, tuple[float, float, float]]:
    """Steps, answer and change to half as many, once this change is small."""
    steps = case.first_steps
    now = case.solve(modes, steps)
    while True:
        steps *= 2
        before, now = now, case.solve(modes, steps)
        if now.near(before, case.tolerance):
            return steps, now, now.change(before)


class _Case:
    """A problem with its loads and the times and places asked for, checked; float64."""

    def __init__(
        self,
        problem: Any,
        loads: Any,
        length: Any,
        times: Any,
        places: Any,
        start: Any,
        tolerance: Any,
        steady: bool = False,
        unilateral: bool = False,
    ) -> None:
        if not isinstance(problem, Problem):
            raise InputError("problem", f"is of type {type(problem).__name__}: give a Problem")
        self.pencil = problem.pencil
        self.waveguide = problem.track.waveguide
        resting = at_rest(problem.track)
        if resting.status is Status.UNSTABLE:
            raise InputError("track", f"is unstable without any force: {resting.sentence}; lower the axial force N")
        self.outer = outer_forces(self.pencil, loads)
        self.times = _ascending(times)
        self.contacts = np.array([float(x) for x in self.pencil.places])
        self.places = self.contacts if places is None else float_list(places, "places")
        self.velocity = float(problem.v)
        self.tolerance = _positive(tolerance, "tolerance")
        if self.tolerance >= 1:
            raise InputError("tolerance", f"is {self.tolerance:g}, not below 1: give the error accepted, as a share")
        self.length = _positive(length, "length")
        self.origin = self._placed(start)
        self.carriage: Carriage = carriage(self.pencil)
        self.carriage.force(self.outer.direction)  # refused before any work
        self.steady, self.unilateral = steady, unilateral
        if unilateral and not all(self.pencil.h):
            raise InputError("unilateral", "asks for contacts that open, but one is tight: give every k_contact")

    @property
    def duration(self) -> float:
        return float(self.times[-1])

    def _placed(self, start: Any) -> float:
        """The origin at t = 0; InputError where contacts or places would not stay on the track."""
        every = np.concatenate([self.contacts, self.places])
        low, high = float(every.min()), float(every.max())
        reach = high - low + self.velocity * self.duration
        margin = (self.length - reach) / 2 if start is None else _positive(start, "start") + low
        if margin <= 0 and start is not None:
            raise InputError("start", f"is {margin - low:g}, but the rearmost point is {-low:g} behind it: raise it")
        needed = reach + max(margin, 0.0)
        if self.length <= needed:
            stated = f"is {self.length:g}, but contacts and places cover {needed:g} from the left support"
            raise InputError("length", f"{stated} by the last time: give more than {needed:g}, or end times earlier")
        return margin - low

    @property
    def first_steps(self) -> int:
        return max(FEWEST_STEPS, math.ceil(self.duration * self.outer.fastest))

    def solve(self, modes: int, steps: int) -> _Answer:
        """The answer with these figures; InputError where they are beyond what can be computed."""
        if modes * steps > MOST_WORK or steps > MOST_STEPS:
            stated = f"needs {steps} steps or more of {modes} modes for its tolerance, beyond what is computed"
            raise InputError("times", f"{stated}: end earlier, raise tolerance, or lower modes or steps")
        track = exponentials(discretized(self.waveguide, self.length, modes))
        setting = Setting(
            track, self.length, self.carriage, self.outer, self.contacts, self.places, self.origin, self.velocity,
            self.duration, self.steady, self.unilateral,
        )  # fmt: skip
        with np.errstate(over="ignore", invalid="ignore"), one_thread():
            try:
                found = self._read(march(setting, steps))
            except np.linalg.LinAlgError:
                stated = (
                    "have contact forces that are not determined, such as two tight contacts of one body at a place"
                )
                raise InputError("vehicles", f"{stated}: move a contact, or give k_contact") from None
        if not all(np.isfinite(rows).all() for rows in (found.rail, found.vehicle, found.force)):
            raise InputError("times", f"reaches {self.duration:g}, where the motion overflows: end earlier")
        return found

    def _read(self, motion: Motion) -> _Answer:
        """The motion at the times asked for; forces by their values at the Gauss points of the steps."""
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
        force = hermite(nodes, values, np.gradient(values, nodes, axis=1), self.times)
        if self.unilateral:
            force = np.maximum(force, 0.0)  # between steps at which the force jumps, interpolation overshoots
        kept = hermite(motion.times, motion.state, motion.state_rate, self.times)
        rail = hermite(motion.times, motion.rail, _slopes(motion.rail, h), self.times)
        return _Answer(rail, self.carriage.motion @ kept - self.carriage.give @ force, force, nodes, values)


def _event(found: _Answer, error: float, step: float) -> Event | None:
    """The first time at which a force that pressed comes to 0 or below, between the nodes."""
    noise = 1e-6 * np.abs(found.forces).max(initial=0.0)
    out = []
    for j, row in enumerate(found.forces):
        for k in np.flatnonzero((row[:-1] > noise) & (row[1:] <= 0))[:1]:
            a, b = row[k], row[k + 1]
            gap = found.nodes[k + 1] - found.nodes[k]
            off = step + error * gap / max(a - b, noise)
            out.append(Event(float(found.nodes[k] + gap * a / (a - b)), j + 1, float(off)))
    return min(out, key=lambda event: event.time, default=None)


def _slopes(values: Any, h: float) -> Any:
    """The slopes of equidistant values (rows, nodes), of the fourth order within.

    The rail's own rates would not do: they hold waves that turn many times in a step.
    """
    out = np.gradient(values, h, axis=1, edge_order=2)
    out[:, 2:-2] = (8 * (values[:, 3:-1] - values[:, 1:-3]) - (values[:, 4:] - values[:, :-4])) / (12 * h)
    return out


def _ascending(times: Any) -> Any:
    found = float_list(times, "times")
    if not found.size or found[0] < 0 or found[-1] <= 0 or np.any(np.diff(found) <= 0):
        raise InputError("times", "is not an ascending list of times from 0 on: give at least one time above 0")
    return found


def _positive(value: Any, key: str) -> float:
    number = float(float_list([value], key)[0])
    if number <= 0:
        raise InputError(key, f"is {number:g}, not above 0: give a positive one")
    return number


def _count(value: Any, key: str, least: int, most: int) -> int:
    if isinstance(value, bool) or not isinstance(value, (int, np.integer)) or not least <= value <= most:
        raise InputError(key, f"is {value!r}: give a whole number from {least} to {most}")
    return int(value)
