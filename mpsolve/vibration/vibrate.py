"""The motion of any vehicles on any track from the time on at which loads act."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import replace
from fractions import Fraction
from functools import partial
from typing import Any

import numpy as np

from mpsolve.errors import EffortError, InputError, PrecisionError
from mpsolve.numbers.arrays import Reals
from mpsolve.numbers.float_list import float_list
from mpsolve.numbers.model import rational
from mpsolve.parallel.threads import one_thread
from mpsolve.problem.problem import Problem, require_problem
from mpsolve.progress import Progress, silent
from mpsolve.proof.effort import Effort, begun
from mpsolve.spectrum.spectrum import Spectrum
from mpsolve.tracks.at_rest import require_stable
from mpsolve.vehicles.loads import Outer, outer_forces
from mpsolve.vibration.engine import Engine
from mpsolve.vibration.forcing import Irregularity, Tone, checked_irregularities, tones
from mpsolve.vibration.image import Image
from mpsolve.vibration.motion import Vibration, vibration
from mpsolve.vibration.poles import certified, require_own, searched
from mpsolve.vibration.solution import Parts, Solution, unknown_parts, unknown_solution

STARTS = ("rest", "steady")
_CHUNK = 4096
"""Times that are read off together; for the first ones the effort is not asked."""


def vibrate(
    problem: Problem,
    loads: Any = None,
    *,
    times: Any,
    places: Any = None,
    irregularities: Iterable[Irregularity] | None = None,
    initial: str = "rest",
    spectrum: Spectrum | None = None,
    effort: Effort | None = None,
    progress: Progress | None = None,
) -> Vibration:
    """The motion of the vehicles and the rail under them; float64, with an error that is estimated and kept.

    loads: one `Load` for each contact from rear to front, or a dict of Loads by names of coordinates, in units of the
    problem (SI: N, rad/s); without them the weights act. irregularities: one `Irregularity` for each contact. times
    ≥ 0. places: of the moving frame, by default the contacts. initial: "rest", where everything acts suddenly from
    t = 0 on, or "steady", where constant loads have acted for ever and the rest sets in at t = 0. spectrum: of
    `certify(problem)`, whose roots then are the induced frequencies; without it they are searched for in float64.

    effort: an evaluation is one set-up of the equations. Where it is spent `reason` says so: the motion is the best
    so far with its own `error`, times that were not reached are NaN, and all are where none was found.
    progress hears of the stages frequencies, integral and times.

    The error of deflections is below 1e-8 of the largest wherever `error` says so. InputError names the argument that
    cannot be used, as loads at a frequency at which the vehicle moves by itself; PrecisionError where a root lies on
    the path of integration.
    """
    work, said, poles = begun(effort), progress or silent, None
    image, acting, held, at = _checked(problem, loads, times, places, irregularities, initial)
    require_own(problem, spectrum)
    own = replace(image, effort=work)
    with one_thread():
        try:
            said("frequencies", 0.0)
            poles = searched(problem, work) if spectrum is None else certified(image, spectrum)
            said("integral", 0.0)
            solution = Engine(own, acting, held, poles).solve(at * image.rate)
            solution, parts = _read_off(replace(solution, image=image), at * image.rate, work, said)
        except EffortError as error:
            solution, parts = unknown_solution(image, error.reason), unknown_parts(image, at)
        except np.linalg.LinAlgError:
            stated = (
                "the equations of the motion are singular, as those of a track without stiffness under constant loads"
            )
            raise PrecisionError(f"{stated}: change a parameter") from None
    again = partial(_again, image, acting, held, poles)
    return vibration(problem, solution, at, parts, again)


def _again(image: Image, acting: Any, held: Any, poles: Any, times: Any) -> Solution:
    """The motion for other times t̂."""
    with one_thread():
        return Engine(image, acting, held, poles).solve(times)


def _checked(
    problem: Problem, loads: Any, times: Any, places: Any, irregularities: Any, initial: str
) -> tuple[Image, tuple[Tone, ...], tuple[Tone, ...], Reals]:
    """What is watched, what acts from t = 0 on, what has acted for ever, and the times."""
    require_problem(problem)
    require_stable(problem.track)
    if initial not in STARTS:
        raise InputError("initial", f"is {initial!r}: give one of {', '.join(STARTS)}")
    at = _times(times)
    image = Image(problem, checked_places(problem, places))
    outer = outer_forces(image.pencil, loads)
    rough = checked_irregularities(irregularities, image.contacts)
    if initial == "rest":
        return image, tones(image, outer, rough), (), at
    held = tones(image, _only(outer, constant=True), ())
    return image, tones(image, _only(outer, constant=False), rough), held, at


def _only(outer: Outer, constant: bool) -> Outer:
    zero = np.zeros_like(outer.constant)
    return Outer(
        outer.direction,
        outer.constant if constant else zero,
        zero if constant else outer.amplitude,
        outer.frequency,
        outer.phase,
    )


def _read_off(solution: Solution, times: Any, work: Effort, said: Progress) -> tuple[Solution, Parts]:
    """The parts at these times; NaN from where the effort is spent, which the solution then tells."""
    table = np.full((4, solution.image.channels, len(times)), np.nan)
    for k in range(0, len(times), _CHUNK):
        try:
            if k:
                work.spend(0)
        except EffortError as error:
            return replace(solution, reason=error.reason), Parts(*table)
        one = _from_start(solution, times[k : k + _CHUNK])
        table[..., k : k + _CHUNK] = one.static, one.forced, one.free, one.transient
        said("times", min(1.0, (k + _CHUNK) / len(times)))
    return solution, Parts(*table)


def _from_start(solution: Solution, times: Any) -> Parts:
    """The parts; at t = 0 the transient part is what makes the sum right at once after the start."""
    parts = solution.parts(times)
    first = times == 0
    if first.any():
        transient = parts.transient.copy()
        rest = (parts.static + parts.forced + parts.free)[:, first]
        transient[:, first] = (solution.held + solution.first)[:, None] - rest
        parts = Parts(parts.static, parts.forced, parts.free, transient)
    return parts


def _times(times: Any) -> Reals:
    at = float_list(times, "times")
    if not at.size or np.any(at < 0):
        raise InputError("times", "hold none, or one below 0, where nothing acts yet: give times from 0 on")
    return at


def times_above_0(times: Iterable[Any]) -> tuple[Fraction, ...]:
    """In exact numbers."""
    exact = tuple(rational(t, "times") for t in times)
    if not exact or min(exact) <= 0:
        raise InputError("times", "hold none, or one that is not above 0: give times above 0")
    return exact


def checked_places(problem: Problem, places: Any) -> tuple[Fraction, ...]:
    """The places in exact numbers, the contacts where none are given."""
    if places is None:
        return problem.pencil.places
    listed = [places] if isinstance(places, (str, int, float, Fraction)) else list(places)
    return tuple(rational(x.item() if isinstance(x, np.generic) else x, "places", "m", "place") for x in listed)
