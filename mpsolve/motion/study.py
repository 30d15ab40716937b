"""Questions about a response: envelopes, superposition, one doubled mass, the weight of the transient part."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass, replace
from typing import Any

import numpy as np

from mpsolve.certificate.on_sheet import AnySpectrum
from mpsolve.errors import InputError
from mpsolve.model.load import Load, loads_of
from mpsolve.model.parameters import Case, PhysicalCase
from mpsolve.motion.grid import checked_places, checked_times
from mpsolve.motion.solution import Response
from mpsolve.motion.solve import prepare, response
from mpsolve.motion.waves import modulus
from mpsolve.numbers.exact import Number

_REAL = 1e-12  # Im q below this part of |q| is a rounded 0


@dataclass(frozen=True)
class Envelope:
    """The envelope ±modulus(τ) of the unsteady harmonic part at one position.

    modulus: shape (len(tau),). amplitudes: |A_k| of each pair of induced frequencies. greatest, least: the maximum
    and minimum of the modulus over all τ ≥ 0, or None where there is none in closed form; `note` says why.
    """

    modulus: Any
    amplitudes: tuple[float, ...]
    greatest: float | None
    least: float | None
    note: str


def envelope(
    case: Case | PhysicalCase,
    loads: Iterable[Load] | None = None,
    xi: Number | None = None,
    tau: Iterable[Number] | Number = (0,),
    spectrum: AnySpectrum | None = None,
) -> Envelope:
    """The envelope of the unsteady harmonic part (36) at ξ, by default that of the rear mass, as in Figures 3–8.

    With one wave Re(A_k e^{iq_kτ}) for each pair of induced frequencies it is |Σ A_k e^{iq_kτ}|, which the vibration
    never exceeds. For at most two pairs without damping its extremes are |A₁| ± |A₂| (Figure 7): the
    phases of two different frequencies take every difference. Errors as for `response`.
    """
    problem = prepare(case, loads, spectrum)
    place, times = checked_places(xi, problem.model.positions[:1]), checked_times(tau)
    if len(place) != 1:
        raise InputError("xi", f"holds {len(place)} positions: the envelope is that of one, give one number")
    terms = [(wave.q, complex(wave.amplitude(problem.model, place)[0])) for wave in problem.induced]
    size = modulus([(q, [a]) for q, a in terms], times)[0] if terms else np.zeros(len(times))
    sizes = tuple(abs(a) for _, a in terms)
    if any(abs(q.imag) > _REAL * abs(q) for q, _ in terms):
        return Envelope(size, sizes, None, None, "the amplitudes grow or decay: the extremes depend on the times")
    if len(terms) > 2:
        return Envelope(size, sizes, sum(sizes), None, "more than two pairs: only the bound from above is known")
    padded = (*sizes, 0.0, 0.0)[:2]
    return Envelope(size, sizes, sum(padded), abs(padded[0] - padded[1]), "")


def superposition(
    case: Case | PhysicalCase,
    loads: Iterable[Load] | None = None,
    xi: Iterable[Number] | Number | None = None,
    tau: Iterable[Number] | Number = (0,),
) -> tuple[Response, ...]:
    """The response to each mass alone, with its own load, at the same ξ and τ: their sum is the superposition.

    One response for each position with its masses merged; add their `w`. Errors as for `response`.
    """
    forces = loads_of(case, loads)
    whole = case.dimensionless if isinstance(case, PhysicalCase) else case
    places = [float(x) for x in whole.merged.positions] if xi is None else xi
    found = []
    for place in whole.merged.positions:
        chosen = [j for j, other in enumerate(whole.positions) if other == place]
        alone = replace(whole, eta_m=tuple(whole.eta_m[j] for j in chosen), positions=(place,) * len(chosen))
        found.append(response(alone, [forces[j] for j in chosen], places, tau))
    return tuple(found)


def merged(
    case: Case | PhysicalCase,
    loads: Iterable[Load] | None = None,
    xi: Iterable[Number] | Number | None = None,
    tau: Iterable[Number] | Number = (0,),
) -> Response:
    """The response to one mass with the sum of all masses and loads, at the position of the rear mass (the first).

    This is the paper's "one doubled mass" for two equal ones. Errors as for `response`.
    """
    forces = loads_of(case, loads)
    whole = case.dimensionless if isinstance(case, PhysicalCase) else case
    places = [float(x) for x in whole.merged.positions] if xi is None else xi
    return response(replace(whole, positions=(whole.positions[0],) * whole.count), forces, places, tau)


@dataclass(frozen=True)
class Importance:
    """How far the harmonic solution misses the initial conditions at the contact points (paper, Section 4.1).

    displacement, velocity: of each mass at τ = 0 without the truly transient part. They vanish with it.
    """

    displacement: tuple[float, ...]
    velocity: tuple[float, ...]


def transient_importance(
    case: Case | PhysicalCase, loads: Iterable[Load] | None = None, spectrum: AnySpectrum | None = None
) -> Importance:
    """Displacement and velocity of the steady and harmonic part alone at τ = 0; errors as for `response`."""
    problem = prepare(case, loads, spectrum)
    start = problem.harmonic(checked_places(None, problem.model.positions), np.zeros(1))
    group = problem.group
    return Importance(tuple(float(start.w[k, 0]) for k in group), tuple(float(start.velocity[k, 0]) for k in group))


def deflection_shape(
    case: Case | PhysicalCase,
    loads: Iterable[Load] | None = None,
    xi: Iterable[Number] | None = None,
    tau: Iterable[Number] | Number = (0,),
    spectrum: AnySpectrum | None = None,
) -> Response:
    """The whole shape of the beam at the given times: `response` on a grid of ξ around the masses.

    Without xi: 401 points from 10 behind the rear mass to 10 before the front mass. For pictures
    mpsolve/report/figures_motion.py has draw_shape(found, ax, time) at one time, and animation(found) as it moves.
    Errors as for `response`.
    """
    whole = case.dimensionless if isinstance(case, PhysicalCase) else case
    if xi is None:
        xi = np.linspace(float(whole.positions[0]) - 10, float(whole.positions[-1]) + 10, 401)
    found = response(case, loads, xi, tau, spectrum)
    if len(found.xi) < 2:
        raise InputError("xi", "has less than two positions, which make no shape: give more")
    return found
