"""Questions about a motion: superposition, one merged mass, envelope, the weight of the transient part.

Each takes a Problem, or a Case or PhysicalCase of the paper, which keep their own formulas and units.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING, Any

import numpy as np

from mpsolve.errors import InputError
from mpsolve.numbers.arrays import Reals
from mpsolve.numbers.exact import Number
from mpsolve.problem.case import Case
from mpsolve.problem.load import loads_of
from mpsolve.problem.physical import PhysicalCase
from mpsolve.problem.problem import Problem
from mpsolve.spectrum.spectrum import Spectrum
from mpsolve.vehicles.load import Load
from mpsolve.vehicles.mass import Mass
from mpsolve.vehicles.vehicle import Placed
from mpsolve.vibration.case_motion import Response, units_of
from mpsolve.vibration.motion import Vibration
from mpsolve.vibration.of_case import motion_of_case, vibration_of_case
from mpsolve.vibration.vibrate import vibrate

if TYPE_CHECKING:
    from mpsolve.vibration.residues import Mode

_REAL = 1e-12
"""Im q below this part of |q| is a rounded 0."""
_MASSES = "has a meaning for masses only"


def superposition(problem: Any, loads: Any = None, *arguments: Any, **options: Any) -> tuple[Any, ...]:
    """The motion of each vehicle alone under its own loads: their sum is the superposition, which is no solution.

    problem, loads, options: as for `response`; of a Case masses at one position stay together. Without `places` the
    rail is watched under all contacts.
    """
    if isinstance(problem, (Case, PhysicalCase)):
        return _each_place(problem, loads, *arguments, **options)
    options.setdefault("places", problem.pencil.places)
    return tuple(
        vibrate(Problem(problem.track, [placed], problem.v), own, **options)
        for placed, own in zip(problem.vehicles, _own_loads(problem, loads), strict=True)
    )


def _each_place(
    case: Case | PhysicalCase, loads: Sequence[Load] | None, xi: Any = None, tau: Any = (0,)
) -> tuple[Response, ...]:
    forces, found = loads_of(case, loads), []
    whole, places = _placed(case, xi)
    for place in dict.fromkeys(whole.positions):
        chosen = [j for j, other in enumerate(whole.positions) if other == place]
        alone = replace(whole, eta_m=tuple(whole.eta_m[j] for j in chosen), positions=(place,) * len(chosen))
        found.append(motion_of_case(alone, [forces[j] for j in chosen], places, tau))
    return tuple(found)


def merged(problem: Any, loads: Sequence[Load] | None = None, *arguments: Any, **options: Any) -> Any:
    """The motion of one mass with the sum of all masses and loads at the rear one: the paper's "doubled mass".

    Without `places` the rail is watched under all contacts. InputError for vehicles that are no masses.
    """
    if isinstance(problem, (Case, PhysicalCase)):
        return _at_rear(problem, loads, *arguments, **options)
    masses = [placed.vehicle.M for placed in problem.vehicles if isinstance(placed.vehicle, Mass)]
    if len(masses) < len(problem.vehicles):
        raise InputError("problem", f"holds other vehicles than masses, and one merged mass {_MASSES}")
    if isinstance(loads, Mapping):
        raise InputError("loads", "are given by names: give one Load for each mass, or none")
    options.setdefault("places", problem.pencil.places)
    rear = min(placed.position for placed in problem.vehicles)
    together = Problem(problem.track, [Mass(mass).at(rear) for mass in masses], problem.v)
    return vibrate(together, loads, **options)


def _at_rear(case: Case | PhysicalCase, loads: Sequence[Load] | None, xi: Any = None, tau: Any = (0,)) -> Response:
    whole, places = _placed(case, xi)
    return motion_of_case(
        replace(whole, positions=(whole.positions[0],) * whole.count), loads_of(case, loads), places, tau
    )


@dataclass(frozen=True)
class Envelope:
    """The envelope ±modulus(t) of the harmonic part at one place, and the size of each pair of frequencies there.

    modulus: shape (len(times),). amplitudes by the order of `Vibration.induced`. greatest, least: of the modulus over
    all times, or None where there is none in closed form; `note` says why.
    """

    modulus: Reals
    amplitudes: tuple[float, ...]
    greatest: float | None
    least: float | None
    note: str


def envelope(
    problem: Any, loads: Any = None, xi: Any = None, tau: Any = (0,), spectrum: Spectrum | None = None
) -> Envelope:
    """The envelope of the harmonic part, which the vibration at induced frequencies never exceeds.

    problem: a Vibration, of whose first place it is; or a Problem, at the place xi and the times tau; or a Case or
    PhysicalCase, in w_st, as in Figures 3–8 of the paper. Without xi it is that of the rear contact.
    """
    found = _motion(problem, loads, xi, tau, spectrum)
    if xi is not None and len(found.places) != 1:
        stated = f"holds {len(found.places)} positions"
        raise InputError("xi", f"{stated}: the envelope is that of one, give one number")
    parts, times = found.induced, found.times
    turns = sum((part.rail[0] * np.exp(1j * part.q * times) for part in parts), np.zeros(len(times)))
    sizes = tuple(float(abs(part.rail[0])) for part in parts)
    return Envelope(np.abs(turns), sizes, *_extremes([part.q for part in parts], sizes))


def _extremes(qs: list[complex], sizes: tuple[float, ...]) -> tuple[float | None, float | None, str]:
    """|A₁| ± |A₂|: the phases of two different frequencies take every difference."""
    if any(abs(q.imag) > _REAL * abs(q) for q in qs):
        return None, None, "the amplitudes grow or decay: the extremes depend on the times"
    if len(qs) > 2:
        return sum(sizes), None, "more than two pairs: only the bound from above is known"
    first, second = (*sizes, 0.0, 0.0)[:2]
    return first + second, abs(first - second), ""


@dataclass(frozen=True)
class Importance:
    """How far steady and harmonic part alone miss the start from rest under the contacts: it vanishes with the rest.

    displacement, velocity (contacts,): at t = 0, without the transient part.
    """

    displacement: Reals
    velocity: Reals


def transient_importance(problem: Any, loads: Any = None, spectrum: Spectrum | None = None) -> Importance:
    """Displacement and velocity of the steady and harmonic part alone at t = 0 (paper, Section 4.1).

    problem: a Vibration, at its places; a Problem, at its contacts; or a Case or PhysicalCase, of each mass, in w_st.
    """
    rate = float(units_of(problem).rate) if isinstance(problem, (Case, PhysicalCase)) else 1.0
    solution = _motion(problem, loads, None, (0,), spectrum).solution
    image, first = solution.image, slice(solution.image.size + solution.image.contacts, None)
    parts = solution.parts(np.zeros(1))
    displacement = (parts.static + parts.forced + parts.free)[first, 0] - solution.held[first]
    rates = [(1j * one.frequency * one.amplitude).real for one in solution.steady]
    rates += [_rate(mode) for mode in solution.modes]
    velocity = sum(rates, np.zeros(image.channels))[first] * image.rate / rate
    return Importance(displacement, velocity)


def _motion(problem: Any, loads: Sequence[Load] | None, xi: Any, tau: Any, spectrum: Spectrum | None) -> Vibration:
    """What is asked about, computed unless it is there."""
    if isinstance(problem, (Case, PhysicalCase)):
        return vibration_of_case(units_of(problem), loads, xi, tau, spectrum)
    if isinstance(problem, Problem):
        return vibrate(problem, loads, times=tau, places=xi, spectrum=spectrum)
    if not isinstance(problem, Vibration):
        stated = f"is of type {type(problem).__name__}"
        raise InputError("problem", f"{stated}: give a Problem, a Case, or a Vibration from response(problem, …)")
    return problem


def _rate(mode: Mode) -> Any:
    """The slope of a mode at t = 0, scaled."""
    slope = mode.sigma * mode.moments[0] + (mode.moments[1] if len(mode.moments) > 1 else 0)
    return (2.0 if mode.sigma.imag > 0 else 1.0) * slope.real


def _own_loads(problem: Problem, loads: Any) -> list[Any]:
    """The loads of each vehicle."""
    placed = problem.vehicles
    if loads is None:
        return [None] * len(placed)
    if isinstance(loads, Mapping):
        return [_named(loads, k, one, len(placed)) for k, one in enumerate(placed, 1)]
    given = list(loads)
    order = sorted(
        (x + one.position, k, j) for k, one in enumerate(placed) for j, x in enumerate(one.vehicle.pencil.places)
    )
    if len(given) != len(order):
        raise InputError("loads", f"has {len(given)} loads for {len(order)} contacts: give one for each")
    return [[load for load, (_, k, _) in zip(given, order, strict=True) if k == own] for own in range(len(placed))]


def _named(loads: Mapping[str, Load], k: int, placed: Placed, count: int) -> dict[str, Load]:
    ending = "" if count == 1 else f" of vehicle {k}"
    names = placed.vehicle.pencil.names
    return {name: loads[name + ending] for name in names if name + ending in loads}


def deflection_shape(
    case: Case | PhysicalCase,
    loads: Iterable[Load] | None = None,
    xi: Iterable[Number] | None = None,
    tau: Iterable[Number] | Number = (0,),
    spectrum: Spectrum | None = None,
) -> Response:
    """The whole shape of the beam at the given times: the motion on a grid of ξ around the masses.

    Without xi: 401 points from 10 behind the rear mass to 10 before the front mass. For pictures
    mpsolve/report/figures_motion.py has draw_shape(found, ax, time) at one time, and animation(found) as it moves.
    Errors as for `motion_of_case`.
    """
    whole, _ = _placed(case, None)
    if xi is None:
        xi = np.linspace(float(whole.positions[0]) - 10, float(whole.positions[-1]) + 10, 401)
    found = motion_of_case(case, loads, xi, tau, spectrum)
    if len(found.xi) < 2:
        raise InputError("xi", "has less than two positions, which make no shape: give more")
    return found


def _placed(case: Case | PhysicalCase, xi: Any) -> tuple[Case, Any]:
    whole = case.dimensionless if isinstance(case, PhysicalCase) else case
    return whole, [float(x) for x in dict.fromkeys(whole.positions)] if xi is None else xi
