"""The motion of a case of the paper, in τ, ξ and w_st: the general response of the problem that it is."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from typing import Any

import numpy as np

from mpsolve.certificate.certify import certify
from mpsolve.errors import EffortError, InputError, PrecisionError
from mpsolve.numbers.arrays import Reals
from mpsolve.numbers.exact import Number
from mpsolve.numbers.float_list import checked_places, checked_times
from mpsolve.problem.case import Case
from mpsolve.problem.load import loads_of
from mpsolve.problem.physical import PhysicalCase
from mpsolve.problem.problem import Problem
from mpsolve.progress import Progress
from mpsolve.proof.effort import Effort
from mpsolve.spectrum.spectrum import Spectrum
from mpsolve.vehicles.load import Load
from mpsolve.vibration.case_motion import CaseUnits, HarmonicPair, Response, units_of
from mpsolve.vibration.motion import Vibration
from mpsolve.vibration.vibrate import vibrate

_NOISE = 1e-6  # of the largest force: what float64 leaves of a contact force that is 0


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
    forces, units = loads_of(case, loads), units_of(case)
    positions = [float(x) for x in dict.fromkeys(units.case.positions)]
    places, times = checked_places(xi, positions), checked_times(tau)
    try:
        found = certified_of(units, spectrum, effort=effort, progress=progress)
    except EffortError:
        found = None
    # the start is always computed, so that times may be none
    at, own = np.concatenate([[0.0], times]), list(dict.fromkeys(units.problem.pencil.places))
    motion = _moved(
        units, units.loads(forces), at, [*own, *units.places(places)], found, effort=effort, progress=progress
    )
    return _told(units, forces, motion, places, times)


def vibration_of_case(
    units: CaseUnits, loads: Sequence[Load] | None, xi: Any, tau: Any, spectrum: Spectrum | None
) -> Vibration:
    """The same as the general response has it, with loads such that deflections come in w_st; τ and ξ are given."""
    forces = units.loads(loads_of(units.given, loads), 1 / units.w_st)
    places = checked_places(xi, [float(x) for x in units.case.positions])
    found = certified_of(units, spectrum)
    return _moved(units, forces, checked_times(tau), units.places(places), found)


def _moved(
    units: CaseUnits, loads: Sequence[Load], tau: Reals, x: Any, spectrum: Spectrum | None, **work: Any
) -> Vibration:
    """The general response; what is wrong with it is said of τ and ξ."""
    try:
        return vibrate(units.problem, loads, times=units.times(tau), places=x, spectrum=spectrum, **work)
    except InputError as error:
        raise error.under({"times": "tau", "places": "xi"}.get(error.key, error.key)) from None


def certified_of(units: CaseUnits, spectrum: Spectrum | None, digits: int = 30, **work: Any) -> Spectrum:
    """All induced frequencies of the sheet, or, where the cuts are no line, of what `certify` answers."""
    problem = units.problem
    if spectrum is None:
        spectrum = _of_sheet(problem, digits, work)
        if spectrum is None:
            spectrum = certify(problem, check=False, digits=digits, **work)
    if not isinstance(spectrum, Spectrum):
        raise InputError("spectrum", f"is of type {type(spectrum).__name__}: give certify(case)")
    if spectrum.problem not in (units.given, problem):
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


def _told(units: CaseUnits, loads: tuple[Load, ...], motion: Vibration, xi: Any, tau: Any) -> Response:
    """What was computed, without the first time and the first places, which are the masses' own."""
    case, unit, rate = units.case, 1 / float(units.w_st), float(units.rate)
    rows = slice(len(motion.places) - len(xi), None)
    shown = [unit * part[rows, 1:] for part in (motion.steady, motion.steady_harmonic, motion.harmonic)]
    watched, scaled = slice(-len(motion.places), None), motion.times[1:] * motion.solution.image.rate
    force, acceleration = _forces(case, loads, motion.contact_force[:, 1:], tau)
    pairs = tuple(
        HarmonicPair(
            part.q / rate, part.multiplicity, unit * part.rail[rows], unit * mode.motion(scaled)[watched][rows]
        )
        for part, mode in zip(motion.induced, motion.solution.modes, strict=True)
    )
    group = [list(dict.fromkeys(case.positions)).index(place) for place in case.positions]
    lost = contact_loss(loads, force, tau)
    unknown = motion.reason.message if motion.reason is not None and not np.isfinite(force).all() else ""
    size = max(float(np.abs(part).max(initial=0.0)) for part in (motion.steady, motion.harmonic, motion.transient))
    velocity = unit * motion.solution.image.rate / rate * motion.solution.rates(scaled)[watched][group]
    return Response(
        case=case,
        loads=loads,
        xi=xi,
        tau=tau,
        steady=shown[0],
        steady_harmonic=shown[1],
        harmonic=shown[2],
        transient=unit * motion.transient[rows, 1:],
        harmonic_pairs=pairs,
        velocity=velocity,
        acceleration=acceleration,
        contact_forces=force,
        contact_loss=tuple(time for time, _ in lost),
        contact_note=tuple(note or unknown for _, note in lost),
        error=motion.error.rail / size if size else 0.0,
        reason=motion.reason,
        motion=motion,
    )


def _forces(case: Case, loads: tuple[Load, ...], force: Reals, tau: Reals) -> tuple[Reals, Reals]:
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


def applied(load: Load, tau: Any) -> Any:
    """The force of the load at the times τ, P_j(τ) of (2); float64."""
    constant, amplitude, omega, phase = map(float, (load.constant, load.amplitude, load.frequency, load.phase))
    return constant + amplitude * np.sin(omega * tau + phase)


def contact_loss(loads: Sequence[Load], force: Reals, tau: Reals) -> tuple[tuple[float | None, str], ...]:
    """For each mass the first time at which its contact force falls below zero, and what is to be said of it.

    The time is linear between the given ones; None where the force never falls, or cannot be judged.
    """
    size = sum(abs(float(load.constant)) + abs(float(load.amplitude)) for load in loads)
    order = np.argsort(tau)
    return tuple(
        _first_loss(load, row[order], tau[order], _NOISE * size) for load, row in zip(loads, force, strict=True)
    )


def _first_loss(load: Load, force: Reals, tau: Reals, noise: float) -> tuple[float | None, str]:
    pressing = float(load.constant) if load.frequency else float(applied(load, 0.0))
    if pressing <= 0:
        return None, "no constant force presses this mass on the beam, so its contact cannot be judged"
    lifted = np.flatnonzero(force < -noise)
    if not len(lifted):
        return None, ""
    k = int(lifted[0])
    pressed = np.flatnonzero(force[:k] > noise)
    if len(pressed):
        j = int(pressed[-1])
        return float(tau[j] + (tau[k] - tau[j]) * force[j] / (force[j] - force[k])), ""
    if tau[k] == 0:
        return 0.0, ""
    return float(
        tau[k]
    ), f"contact is lost before τ = {tau[k]:.6g}, the first given time that tells: give earlier ones"
