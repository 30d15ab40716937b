"""The motion of a case of the paper in proved balls, or in numbers right to so many decimals; in w_st."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass, replace
from fractions import Fraction
from functools import partial
from typing import Any

import mpmath
import numpy as np

from mpsolve.errors import InputError, PrecisionError
from mpsolve.numbers.balls import arb, greatest
from mpsolve.numbers.exact import Exact, Number, exact_list
from mpsolve.numbers.model import whole
from mpsolve.numbers.multiprecision import middle
from mpsolve.problem.case import Case
from mpsolve.problem.load import loads_of
from mpsolve.problem.physical import PhysicalCase
from mpsolve.problem.problem import Problem
from mpsolve.progress import Progress, silent
from mpsolve.proof.effort import Effort, begun
from mpsolve.spectrum.spectrum import Spectrum
from mpsolve.vehicles.load import Load
from mpsolve.vehicles.mass import Mass
from mpsolve.vibration.balls.enclosure import MOST, Asked, proved_parts
from mpsolve.vibration.case_motion import rounded, units_of
from mpsolve.vibration.image import Image
from mpsolve.vibration.of_case import certified_of

_SLOW = "the truly transient part decays slowly near τ = 0; ask for later times, nearer positions or fewer digits"


@dataclass(frozen=True)
class CaseMotion:
    """The motion from rest, of shape (len(xi), len(tau)) each, as for `Response`."""

    case: Case
    loads: tuple[Load, ...]
    xi: tuple[Exact, ...]
    tau: tuple[Exact, ...]
    w: Any
    steady: Any
    harmonic: Any
    transient: Any


@dataclass(frozen=True)
class ProvedMotion(CaseMotion):
    """In balls (flint.arb): w is proved to hold steady + harmonic + transient.

    evaluations: how often the equations were solved.
    """

    evaluations: int


@dataclass(frozen=True)
class PreciseMotion(CaseMotion):
    """In mpmath numbers, each within 10^−digits of the truth, in units of w_st: a proved bound."""

    digits: int


def balls_of_case(
    case: Case | PhysicalCase,
    loads: Iterable[Load] | None = None,
    xi: Iterable[Number] | Number | None = None,
    tau: Iterable[Number] | Number = (0,),
    spectrum: Spectrum | None = None,
    *,
    digits: int = 15,
    effort: Effort | None = None,
    progress: Progress | None = None,
) -> ProvedMotion:
    """The motion in balls proved to hold it, of a beam from rest under moving masses.

    loads, xi, tau, spectrum as for `response`; a PhysicalCase is done in SI, the ratios of a Case are rational.
    digits: the balls aim at a radius of 10^−digits times the displacement of a unit force; they are returned whatever
    their radius is, which grows towards τ = 0, where the transient part decays with an algebraic tail only. Digits
    that a growing motion, or a force near an induced frequency, costs are added to the work.

    InputError for input that has no meaning, PrecisionError where a step of the proof fails, EffortError where the
    effort runs out; all say what helps.
    """
    digits = whole(digits, "digits", 1, MOST)
    forces, units = loads_of(case, loads), units_of(case, exact=True)
    ratios, problem = units.case, _merged(units.problem)
    places = tuple(dict.fromkeys(ratios.positions)) if xi is None else tuple(exact_list(xi, "xi"))
    times = tuple(exact_list(tau, "tau"))
    if any(t.sign < 0 for t in times):
        raise InputError("tau", "holds a time before 0, where the motion starts: give no earlier time")
    work = begun(effort)
    if not places or not times:
        w, steady, harmonic, transient = np.full((4, len(places), len(times)), arb(0), object)
        return ProvedMotion(ratios, forces, places, times, w, steady, harmonic, transient, 0)
    group = list(dict.fromkeys(ratios.positions))
    terms = [
        (problem.pencil.B[group.index(place)], load)
        for place, load in zip(ratios.positions, units.loads(forces, 1 / units.w_st), strict=True)
    ]
    at = tuple(x / units.chi for x in places)
    image = Image(problem, tuple(rounded(x) for x in at))

    def found(digits: int) -> Spectrum:
        return certified_of(replace(units, problem=problem), spectrum, digits)

    known: Any = found if spectrum is None else found(digits)
    asked = Asked(image, terms, [t / units.rate for t in times], digits, at)
    parts = proved_parts(asked, known, work, progress or silent)
    w, steady, harmonic, transient = (part[image.channels - len(places) :] for part in parts)
    return ProvedMotion(ratios, forces, places, times, w, steady, harmonic, transient, work.spent)


def _merged(problem: Problem) -> Problem:
    """With masses at one position as one."""
    total: dict[Fraction, Fraction] = {}
    for one in problem.vehicles:
        total[one.position] = total.get(one.position, Fraction(0)) + one.vehicle.pencil.M[0][0]
    return Problem(problem.track, [Mass(mass).at(place) for place, mass in total.items()], problem.v)


def numbers_of_case(*arguments: Any, digits: int = 15, **options: Any) -> PreciseMotion:
    """The middles of the balls of `balls_of_case`; PrecisionError if a ball is wider than 10^−digits."""
    digits = whole(digits, "digits", 1, MOST)
    found = balls_of_case(*arguments, digits=min(digits + 3, MOST), **options)
    parts = found.w, found.steady, found.harmonic, found.transient
    limit = arb(10) ** -digits
    for k, time in enumerate(found.tau):
        worst = greatest([arb(0), *(ball.rad() for part in parts for ball in part[:, k])])
        if not worst < limit:
            stated = f"at τ = {time.short()} the motion is known to {float(worst):.1e} only, not to {digits} decimals"
            raise PrecisionError(f"{stated}: {_SLOW}")
    middles = np.vectorize(partial(middle, mpmath.mp), otypes=[object])
    w, steady, harmonic, transient = (middles(part) for part in parts)
    return PreciseMotion(found.case, found.loads, found.xi, found.tau, w, steady, harmonic, transient, digits)
