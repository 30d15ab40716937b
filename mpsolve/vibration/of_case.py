"""The motion of a case of the paper, in its own units: the general response at τ and ξ, displacements in w_st."""

from __future__ import annotations

from collections.abc import Iterable
from fractions import Fraction
from typing import Any

import numpy as np

from mpsolve.certificate.certify import certify
from mpsolve.errors import EffortError, InputError, PrecisionError
from mpsolve.numbers.exact import Exact, Number
from mpsolve.numbers.grid import checked_places, checked_times
from mpsolve.problem.case import Case
from mpsolve.problem.load import loads_of
from mpsolve.problem.physical import PhysicalCase
from mpsolve.problem.problem import Problem
from mpsolve.progress import Progress
from mpsolve.proof.effort import Effort
from mpsolve.spectrum.spectrum import Spectrum
from mpsolve.tracks.euler_bernoulli import EulerBernoulli
from mpsolve.vehicles.load import Load
from mpsolve.vehicles.mass import Mass
from mpsolve.vibration.case_motion import HarmonicPair, Response
from mpsolve.vibration.contact_loss import applied, contact_loss
from mpsolve.vibration.motion import Vibration
from mpsolve.vibration.vibrate import vibrate

W_ST = 0.5
"""χ/(2k) of a unit force, in the units of the beam with EI = 1/4, m = k = 1."""


def motion_of_case(
    case: Case | PhysicalCase,
    loads: Iterable[Load] | None = None,
    xi: Iterable[Number] | Number | None = None,
    tau: Iterable[Number] | Number = (0,),
    spectrum: Spectrum | None = None,
    *,
    effort: Effort | None = None,
    progress: Progress | None = None,
) -> Response:
    """The motion of an infinite beam from rest under moving masses and forces, (20)–(36); float64.

    loads: one for each mass, by default those of `loads_of`. xi: positions in the moving frame, by default the
    positions of the masses. tau ≥ 0: the times. spectrum: `certify(case)`, if it is known already. Irrational ratios
    are taken to float64. effort and progress as for a Problem, and so what comes back where effort runs out, with its
    `reason`; frequencies that it does not certify are searched for in float64.

    InputError for input that has no meaning, PrecisionError where the induced frequencies are undecided or the motion
    cannot be computed; both say what helps.
    """
    forces = loads_of(case, loads)
    whole = case.dimensionless if isinstance(case, PhysicalCase) else case
    positions = [float(x) for x in dict.fromkeys(whole.positions)]
    places, times = checked_places(xi, positions), checked_times(tau)
    try:
        found = certified_of(whole, beam_problem(whole), spectrum, effort=effort, progress=progress)
    except EffortError:
        found = None
    # the start is always computed, so that times may be none
    at, watched = np.concatenate([[0.0], times]), np.concatenate([positions, places])
    motion = _moved(whole, forces, at, watched, found, effort, progress)
    return _told(whole, forces, motion, len(positions))


def vibration_of_case(case: Any, loads: Any, xi: Any, tau: Any, spectrum: Any) -> Vibration:
    """The same as the general response has it, with loads such that deflections come in w_st; forces are twice."""
    whole = case.dimensionless if isinstance(case, PhysicalCase) else case
    two, given = Exact(2), loads_of(case, loads)
    forces = [Load(two * one.constant, two * one.amplitude, one.frequency, one.phase) for one in given]
    places = checked_places(xi, [float(x) for x in whole.positions])
    found = certified_of(whole, beam_problem(whole), spectrum)
    return _moved(whole, forces, checked_times(tau), places, found)


def _moved(
    case: Case, loads: Any, tau: Any, xi: Any, spectrum: Spectrum | None, effort: Any = None, progress: Any = None
) -> Vibration:
    """The general response; what is wrong with it is said of τ and ξ."""
    try:
        given: dict[str, Any] = {"effort": effort, "progress": progress}
        return vibrate(beam_problem(case), loads, times=tau, places=xi, spectrum=spectrum, **given)
    except InputError as error:
        key = {"times": "tau", "places": "xi"}.get(error.key, error.key)
        raise InputError(key, str(error).removeprefix(f"{error.key}: ")) from None


def beam_problem(case: Case) -> Problem:
    """EI = 1/4, m = k = 1, c = 2 η_b, kp = η_S, N = η_N, masses η_M, v = α; irrational ratios as float64 has them."""
    eta_b, eta_s, eta_n, alpha = (_near(getattr(case, key)) for key in ("eta_b", "eta_s", "eta_n", "alpha"))
    track = EulerBernoulli(EI=Fraction(1, 4), m=1, k=1, c=2 * eta_b, kp=eta_s, N=eta_n)
    masses = zip(case.eta_m, case.positions, strict=True)
    return Problem(track, [Mass(_near(mass)).at(_near(place)) for mass, place in masses], v=alpha)


def _near(value: Any) -> Fraction:
    return value.as_fraction() if value.is_rational else Fraction(float(value))


def certified_of(case: Case, problem: Problem, spectrum: Any, digits: int = 30, **work: Any) -> Spectrum:
    """All induced frequencies of the sheet, or, where the cuts are no line, of what `certify` answers."""
    if spectrum is None:
        spectrum = _of_sheet(problem, digits, work)
        if spectrum is None:
            spectrum = certify(problem, check=False, digits=digits, **work)
    if not isinstance(spectrum, Spectrum):
        raise InputError("spectrum", f"is of type {type(spectrum).__name__}: give certify(case)")
    if spectrum.problem not in (case, problem):
        raise InputError("spectrum", "is not that of this case: give certify(case)")
    if not spectrum.proved and spectrum.reason is not None and spectrum.reason.code in ("effort", "interrupted"):
        raise EffortError(spectrum.reason)
    if not spectrum.proved:
        message = spectrum.reason.message if spectrum.reason else ""
        raise PrecisionError(f"the induced frequencies are undecided: {message}; change a parameter a little")
    return spectrum


def _of_sheet(problem: Problem, digits: int, work: dict[str, Any]) -> Spectrum | None:
    try:
        return certify(problem, region="sheet", check=False, digits=digits, **work)
    except InputError:  # the cuts are no line
        return None


def _told(case: Case, loads: tuple[Load, ...], motion: Vibration, own: int) -> Response:
    """What was computed, without the first time and the first places, which are the masses' own."""
    tau = motion.times[1:]
    rows, unit = slice(own, None), 1 / W_ST
    shown = [unit * part[rows, 1:] for part in (motion.steady, motion.steady_harmonic, motion.harmonic)]
    rate, watched = motion.solution.image.rate, slice(-len(motion.places), None)
    scaled = tau * rate
    force, acceleration = _forces(case, loads, motion.contact_force[:, 1:], tau)
    pairs = tuple(
        HarmonicPair(part.q, part.multiplicity, unit * part.rail[rows], unit * mode.motion(scaled)[watched][rows])
        for part, mode in zip(motion.induced, motion.solution.modes, strict=True)
    )
    group = [list(dict.fromkeys(case.positions)).index(place) for place in case.positions]
    lost = contact_loss(loads, force, tau)
    unknown = motion.reason.message if motion.reason is not None and not np.isfinite(force).all() else ""
    size = max(float(np.abs(part).max(initial=0.0)) for part in (motion.steady, motion.harmonic, motion.transient))
    return Response(
        case=case,
        loads=loads,
        xi=motion.places[rows],
        tau=tau,
        steady=shown[0],
        steady_harmonic=shown[1],
        harmonic=shown[2],
        transient=unit * motion.transient[rows, 1:],
        harmonic_pairs=pairs,
        velocity=unit * rate * motion.solution.rates(scaled)[watched][group],
        acceleration=acceleration,
        contact_forces=force,
        contact_loss=tuple(time for time, _ in lost),
        contact_note=tuple(note or unknown for _, note in lost),
        error=motion.error.rail / size if size else 0.0,
        reason=motion.reason,
        motion=motion,
    )


def _forces(case: Case, loads: tuple[Load, ...], force: Any, tau: Any) -> tuple[Any, Any]:
    """Contact forces and accelerations of the single masses; at τ = 0 the beam gives way, and there is no force yet.

    Masses at one position move as one: by (2), in w_st, ΣP − Σf = (Ση_M/2) w_ττ.
    """
    outer, eta = np.array([applied(load, tau) for load in loads]), np.array([float(x) for x in case.eta_m])
    contact, acceleration = np.empty((2, *outer.shape))
    for place in dict.fromkeys(case.positions):
        own = [j for j, other in enumerate(case.positions) if other == place]
        whole = np.where(tau == 0, 0.0, force[own].sum(0))
        acceleration[own] = 2 * (outer[own].sum(0) - whole) / eta[own].sum()
        contact[own] = whole if len(own) == 1 else outer[own] - eta[own, None] / 2 * acceleration[own]
    return contact, acceleration
