"""The public verb: the motion of any problem from rest in balls that are proved to hold it.

u(t) = Σ residues to the right of the path + (1/π) Im ∫ û e^{σt} dσ along its upper half. What is proved on the way:

    the residues                                  circles.py, from the certified induced frequencies
    that the path may leave the physical region   path.py near, far.py far out
    the integral                                  panels.py
    what is cut off                               far.py
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from fractions import Fraction
from typing import Any

import numpy as np

from mpsolve.certificate.certify import certify
from mpsolve.errors import EffortError, InputError, PrecisionError
from mpsolve.numbers.balls import acb, arb, precision, rational_ball
from mpsolve.numbers.model import rational
from mpsolve.numbers.multiprecision import Multiprecision
from mpsolve.numbers.result import Result
from mpsolve.outcome import Reason, Status
from mpsolve.problem.problem import Problem
from mpsolve.problem.reduced import reduce_problem
from mpsolve.progress import Progress, silent
from mpsolve.proof.effort import Effort, begun
from mpsolve.spectrum.regions import Below, HalfPlane, Sheet
from mpsolve.spectrum.spectrum import Spectrum
from mpsolve.spectrum.unfelt import unfelt_frequencies
from mpsolve.vehicles.loads import outer_forces
from mpsolve.vibration.balls.image import BallImage
from mpsolve.vibration.balls.work import Work
from mpsolve.vibration.engine import Engine
from mpsolve.vibration.forcing import tones
from mpsolve.vibration.image import Image
from mpsolve.vibration.poles import certified
from mpsolve.vibration.precise_image import exact_terms
from mpsolve.vibration.vibrate import checked_places

_LATE = 8.0
"""Scaled: a path for earlier times lies no farther right.""" 
MOST = 100
_GUARD = 15
_RISE = 8.0
"""What a motion that neither grows nor decays grows by along the path, as an exponent: far from cuts and roots."""


@dataclass(frozen=True)
class ProvedVibration(Result):
    """The motion from rest in balls (flint.arb, dtype object), in the units of the problem.

    Where `status` is UNVERIFIED each ball holds the truth, by a proof that no other program has checked; else
    `reason` says why nothing is known, and all balls are infinite. rail (places, times) is the sum of steady,
    harmonic and transient, which are infinite balls where they are not proved apart; vehicle by coordinates;
    contact_force (contacts, times). evaluations: how often the equations were solved.
    """

    times: tuple[Fraction, ...]
    places: tuple[Fraction, ...]
    rail: Any
    steady: Any
    harmonic: Any
    transient: Any
    vehicle: dict[str, Any]
    contact_force: Any
    status: Status
    reason: Reason | None
    evaluations: int


def response_balls(
    problem: Problem,
    loads: Any = None,
    *,
    times: Iterable[Any],
    digits: int = 15,
    places: Any = None,
    spectrum: Spectrum | None = None,
    effort: Effort | None = None,
    progress: Progress | None = None,
) -> ProvedVibration:
    """The motion from rest in proved balls; seconds, some thousand evaluations that serve all places and times.

    problem, loads, places: as for `response`. times > 0, exact numbers: work grows as the smallest one falls and as
    the largest one rises. digits: 3 to 100; the balls are worked for to a radius of 10^−digits of the static motion,
    and are returned whatever their radius is. spectrum: of `certify(problem, digits=digits + 10)` at least, with all
    roots that grow; without it that is computed.

    Proved are paths for one contact on any track whose waves far out are known (beams, layers, strings, Timoshenko);
    for more contacts, or places away from a single one, on beams on foundations. InputError for what cannot be used;
    where a step of the proof fails the answer is undecided, with the reason.
    """
    _check(problem, digits)
    if spectrum is not None and spectrum.problem != problem:
        raise InputError("spectrum", "is that of another problem: give certify(problem)")
    exact = tuple(rational(t, "times") for t in times)
    if not exact or min(exact) <= 0:
        raise InputError("times", "hold none, or one that is not above 0: give times above 0")
    work, said = begun(effort), progress or silent
    image = Image(problem, checked_places(problem, places))
    outer = outer_forces(image.pencil, loads)
    K = Multiprecision(digits + _GUARD)
    balls = BallImage(K.mp, image, exact_terms(image.pencil, loads), digits + _GUARD)
    try:
        said("frequencies", 0.0)
        found = certify(problem, digits=max(digits + 12, 20), check=False) if spectrum is None else spectrum
        with precision(balls.bits):
            poles, floor = _poles(image, found)
            engine = Engine(image, tones(image, outer, ()), (), certified(image, found))
            at = [rational_ball(t) * balls.rate_ball for t in exact]
            alpha = engine.above(max(_LATE, *(float(t) for t in at)), _RISE)
            if not alpha > floor:
                raise PrecisionError("not all roots above the path are certified: certify a larger region")
            parts = Work(balls, poles, alpha, at, digits, work, said).parts(_sizes(engine))
        return _told(image, exact, parts, work.spent, None)
    except (EffortError, PrecisionError) as error:
        infinite = np.full((image.channels, len(exact)), arb(0, float("inf")), object)
        return _told(image, exact, [infinite] * 4, work.spent, _reason(error))


def _check(problem: Any, digits: Any) -> None:
    if not isinstance(problem, Problem):
        raise InputError("problem", f"is of type {type(problem).__name__}: give a Problem")
    if isinstance(digits, bool) or not isinstance(digits, int) or not 3 <= digits <= MOST:
        raise InputError("digits", f"is {digits!r}: give a whole number from 3 to {MOST}")


def _reason(error: Exception) -> Reason:
    given = error.args[0] if error.args else ""
    if isinstance(given, Reason):
        return given
    message, _, remedy = str(error).partition(": ")
    return Reason("motion-path", message, {}, remedy)


def _poles(image: Image, spectrum: Spectrum) -> tuple[list[Any], float]:
    """σ̂ of all proved roots with Re q ≥ 0 or open, and the scaled Re σ̂ above which there is no other."""
    region = spectrum.region
    whole = isinstance(region, Sheet) or (isinstance(region, (HalfPlane, Below)) and region.radius is None)
    if not (whole and spectrum.proved):
        raise PrecisionError("the induced frequencies are undecided: certify with more effort")
    reduced = reduce_problem(image.problem)
    qs = [root.q for root in spectrum.roots] + list(unfelt_frequencies(reduced.parts))
    qs += [acb(0)] * bool(reduced.neutral)
    return [acb(0, 1) * q / rational_ball(Fraction(image.rate)) for q in qs], certified(image, spectrum).floor


def _sizes(engine: Engine) -> list[float]:
    """About the size of each kind of channel, in float64: what the digits are relative to."""
    values = np.abs(engine.transformed(np.array([1.0 + 0j, 0.1 + 0j])) * np.array([[1.0], [0.1]])).max(0)
    image = engine.image
    kinds = (
        slice(0, image.size),
        slice(image.size, image.size + image.contacts),
        slice(image.size + image.contacts, None),
    )
    for kind in kinds:
        values[kind] = values[kind].max(initial=1e-300)
    return [float(x) for x in values]


def _told(
    image: Image, times: tuple[Fraction, ...], parts: Sequence[Any], count: int, reason: Reason | None
) -> ProvedVibration:
    n, m = image.size, image.contacts
    total, *rows = parts
    steady, harmonic, transient = (row[n + m :] for row in rows)
    return ProvedVibration(
        times=times,
        places=image.places,
        rail=total[n + m :],
        steady=steady,
        harmonic=harmonic,
        transient=transient,
        vehicle=dict(zip(image.pencil.names, total[:n], strict=True)),
        contact_force=total[n : n + m],
        status=Status.UNDECIDED if reason else Status.UNVERIFIED,
        reason=reason,
        evaluations=count,
    )
