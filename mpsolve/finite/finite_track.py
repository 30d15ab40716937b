"""The motion of any vehicle on a finite, simply supported piece of any track, with its errors estimated."""

from __future__ import annotations

import math
from collections.abc import Iterable
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

from mpsolve.errors import EffortError, InputError
from mpsolve.finite.answer import Answer
from mpsolve.finite.case import FEWEST_STEPS, MOST_STEPS, Case
from mpsolve.numbers.model import whole
from mpsolve.outcome import Reason
from mpsolve.problem.problem import Problem
from mpsolve.progress import Progress, silent
from mpsolve.proof.effort import Effort, begun
from mpsolve.vibration.forcing import Irregularity
from mpsolve.vibration.liftoff import Event
from mpsolve.vibration.rows import Rows

if TYPE_CHECKING:
    from mpsolve.numbers.arrays import Reals

FEWEST_MODES, MOST_MODES = 8, 40_000
_OPEN = (math.inf, math.inf, math.inf)
_HELD, _HELD_FORCE, _HELD_FAST = 1.3, 2.0, 3.0
"""Where an error halves with twice as many modes, the change is the error itself; it is not always so even, least so
for forces in steps that a vibration is too fast for."""


@dataclass(frozen=True)
class FiniteTrackError:
    """Estimates of errors, none of them a bound, as the largest changes against the endless track.

    time, modes: from half as many steps and modes; supports: half of what guided ends in place of supports change,
    for they send every wave back with the other sign. All three are of the deflections of the rail, in units of
    length; vehicle and force are the sums of the same three for the coordinates of the vehicles, each in its own
    unit, and for the contact forces.
    """

    time: float
    modes: float
    supports: float
    vehicle: float
    force: float

    @property
    def total(self) -> float:
        """The sum of the three errors of the rail."""
        return self.time + self.modes + self.supports


@dataclass(frozen=True)
class FiniteTrackMotion(Rows):
    """Float64 results on a finite track, not proved, in the units of the problem.

    times (t,). rail (p, t): deflections under the `places` of the moving frame. vehicle: for each coordinate by name
    (t,). contact_force (n, t): from rear to front, compression positive. start: the origin of the moving frame at
    t = 0, from the left support; length, modes, steps: the figures used. lift_off: when a contact
    force first comes to 0, between steps; without `unilateral` what comes later is beyond the model.
    """

    times: Reals
    places: Reals
    rail: Reals
    vehicle: dict[str, Reals]
    contact_force: Reals
    error: FiniteTrackError
    start: float
    length: float
    modes: int
    steps: int
    lift_off: Event | None = None
    reason: Reason | None = None

    @property
    def rail_error(self) -> float:
        """The sum of the estimated errors of the rail."""
        return self.error.total


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
    irregularities: Iterable[Irregularity] | None = None,
    effort: Effort | None = None,
    progress: Progress | None = None,
) -> FiniteTrackMotion:
    """The motion from rest of the vehicles on a simply supported track of this length; float64, errors estimated.

    loads: one `Load` for each contact from rear to front, or a dict of Loads by names of coordinates, in units of the
    problem (SI: N, rad/s); without them the weights act, suddenly from t = 0 on. times ≥ 0, ascending. places: of the
    moving frame, by default the contacts. start: of the origin of the moving frame from the left support; without it
    the load begins and ends equally far from the supports. steps: equal ones up to the last time; without them they
    are doubled until the error that they cause is below `tolerance` of the largest deflection. initial: "rest", or
    "steady", where constant loads have acted for ever. unilateral: contacts push only, so that wheels may leave the
    rail and come back; each needs a Hertz spring k_contact. Events are then met to a step: look at `error`.
    irregularities: one for each contact from rear to front, as for `response`. effort: an evaluation is one step;
    where it is spent `reason` says so, and the best motion so far comes back with its errors, infinite where they are
    not known, or NaN where there is none. progress hears of the stages steps, modes and
    supports.

    InputError names the argument that cannot be used: for a track that the load would leave, the length needed.

    >>> from mpsolve import Problem, tracks, vehicles
    >>> beam = tracks.EulerBernoulli(EI="6.4e6", m=60, k="1e6", c="2e4")
    >>> found = finite_track(Problem(beam, vehicles.Mass(1000), v=30), length=60, modes=100, times=[0, "0.5"])
    >>> found.rail.round(4)
    array([[0.    , 0.0021]])
    """
    if initial not in ("rest", "steady"):
        raise InputError("initial", f"is {initial!r}: give 'rest' or 'steady'")
    case = Case(
        problem, loads, length, times, places, start, tolerance, initial == "steady", bool(unilateral), irregularities
    )
    count = whole(modes, "modes", FEWEST_MODES, MOST_MODES)
    used = None if steps is None else whole(steps, "steps", FEWEST_STEPS, MOST_STEPS)
    best = _best(case, count, used, begun(effort), progress or silent)
    found, late, cut, felt = best.found, best.late, best.cut, best.felt
    names, asked = case.pencil.names, case.asked
    return FiniteTrackMotion(
        times=case.times,
        places=case.places,
        rail=found.rail[:, asked],
        vehicle=dict(zip(names, found.vehicle[:, asked], strict=True)),
        contact_force=found.force[:, asked],
        error=FiniteTrackError(
            time=_HELD * late[0],
            modes=_HELD * cut[0],
            supports=_HELD * felt[0],
            vehicle=_HELD * (late[1] + cut[1] + felt[1]),
            force=_HELD_FAST * late[2] + _HELD_FORCE * cut[2] + _HELD * felt[2],
        ),
        start=case.origin,
        length=case.length,
        modes=count,
        steps=best.steps,
        lift_off=best.lift_off(case.duration),
        reason=best.reason,
    )


@dataclass
class _Best:
    """What is known so far: an answer and its number of steps, one with half as many, one with half as many modes.

    guided: as thin, but between guided ends.
    """

    found: Answer
    steps: int
    coarse: Answer | None = None
    thin: Answer | None = None
    guided: Answer | None = None
    reason: Reason | None = None

    @property
    def late(self) -> tuple[float, float, float]:
        if self.coarse is None:
            return _OPEN
        rail, vehicle, _ = self.found.change(self.coarse)
        return rail, vehicle, self.found.unresolved(self.coarse)

    @property
    def cut(self) -> tuple[float, float, float]:
        return self.found.change(self.thin) if self.thin else _OPEN

    @property
    def felt(self) -> tuple[float, float, float]:
        if self.thin is None or self.guided is None:
            return _OPEN
        rail, vehicle, force = self.thin.change(self.guided)
        return rail / 2, vehicle / 2, force / 2

    def lift_off(self, duration: float) -> Event | None:
        """The first fall of a force, off by as much as errors move it, and a step."""
        fall = self.found.first_fall()
        if fall is None:
            return None
        off = duration / self.steps
        for one, other, share in (
            (self.found, self.coarse, 1),
            (self.found, self.thin, 1),
            (self.thin, self.guided, 0.5),
        ):
            after, before = one and one.first_fall(), other and other.first_fall()
            off += share * _HELD * abs(after[0] - before[0]) if after and before else duration
        return Event(fall[0], fall[1], off)


def _best(case: Case, modes: int, steps: int | None, work: Effort, said: Progress) -> _Best:
    """With as many steps as are asked for, or as make the change to half as many small; as far as the effort goes."""
    best = _Best(case.unknown(), steps or case.first_steps)
    try:
        said("steps", 0.0)
        best.found = case.solve(modes, best.steps, work)
        if steps is not None:
            best.coarse = case.solve(modes, steps // 2, work)
        while steps is None:
            now = case.solve(modes, 2 * best.steps, work)
            best.found, best.steps, best.coarse = now, 2 * best.steps, best.found
            if now.near(best.coarse, case.tolerance):
                break
        said("modes", 0.5)
        best.thin = case.solve(modes // 2, best.steps, work)
        said("modes", 1.0)
        said("supports", 0.8)
        best.guided = case.solve(modes // 2, best.steps, work, guided=True)
        said("supports", 1.0)
    except EffortError as error:
        best.reason = error.reason
    return best
