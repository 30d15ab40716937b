"""Questions about the motion of a case of the paper: superposition, one doubled mass, shapes."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import replace
from typing import Any

import numpy as np

from mpsolve.errors import InputError
from mpsolve.numbers.exact import Number
from mpsolve.problem.case import Case
from mpsolve.problem.load import loads_of
from mpsolve.problem.physical import PhysicalCase
from mpsolve.spectrum.spectrum import Spectrum
from mpsolve.vehicles.load import Load
from mpsolve.vibration.case_motion import Response
from mpsolve.vibration.of_case import motion_of_case


def superposition(
    case: Case | PhysicalCase,
    loads: Iterable[Load] | None = None,
    xi: Iterable[Number] | Number | None = None,
    tau: Iterable[Number] | Number = (0,),
) -> tuple[Response, ...]:
    """The response to each mass alone, with its own load, at the same ξ and τ: their sum is the superposition.

    One response for each position with its masses together; add their `w`. Errors as for `motion_of_case`.
    """
    forces = loads_of(case, loads)
    whole, places = _placed(case, xi)
    found = []
    for place in dict.fromkeys(whole.positions):
        chosen = [j for j, other in enumerate(whole.positions) if other == place]
        alone = replace(whole, eta_m=tuple(whole.eta_m[j] for j in chosen), positions=(place,) * len(chosen))
        found.append(motion_of_case(alone, [forces[j] for j in chosen], places, tau))
    return tuple(found)


def merged(
    case: Case | PhysicalCase,
    loads: Iterable[Load] | None = None,
    xi: Iterable[Number] | Number | None = None,
    tau: Iterable[Number] | Number = (0,),
) -> Response:
    """The response to one mass with the sum of all masses and loads, at the position of the rear mass (the first).

    This is the paper's "one doubled mass" for two equal ones. Errors as for `motion_of_case`.
    """
    forces = loads_of(case, loads)
    whole, places = _placed(case, xi)
    return motion_of_case(replace(whole, positions=(whole.positions[0],) * whole.count), forces, places, tau)


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
