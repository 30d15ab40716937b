"""The public verb: the motion of any problem from rest in balls that are proved to hold it.

u(t) = Σ residues to the right of the path + (1/π) Im ∫ û e^{σt} dσ along its upper half. What is proved on the way:

    that the path may leave the physical region   work.py near, far.py far out
    the steady part                               work.py, as the image at the loads' frequencies
    the residues                                  residues.py, from the certified induced frequencies
    the integral                                  integral.py
    what is cut off                               far.py
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass
from fractions import Fraction
from functools import partial
from math import ceil, inf, log, log2, log10
from typing import Any

import numpy as np

from mpsolve.certificate.certify import certify
from mpsolve.errors import EffortError, InputError, PrecisionError
from mpsolve.numbers.balls import acb, arb, precision, rational_ball
from mpsolve.numbers.exact import Exact
from mpsolve.numbers.model import whole
from mpsolve.numbers.result import Result
from mpsolve.outcome import Reason, Status
from mpsolve.problem.problem import Problem, require_problem
from mpsolve.problem.reduced import reduce_problem
from mpsolve.progress import Progress, silent
from mpsolve.proof.effort import Effort, begun
from mpsolve.spectrum.regions import Below, HalfPlane, Sheet
from mpsolve.spectrum.spectrum import Spectrum
from mpsolve.spectrum.unfelt import unfelt_frequencies
from mpsolve.vehicles.loads import Term, exact_forces
from mpsolve.vibration.balls.image import BallImage
from mpsolve.vibration.balls.work import Work
from mpsolve.vibration.image import Image
from mpsolve.vibration.motion import fields_of
from mpsolve.vibration.path import above_growth
from mpsolve.vibration.poles import certified, require_own
from mpsolve.vibration.vibrate import checked_places, times_above_0

MOST = 100
_GUARD, _SPARE, _MOST_LOST = 20, 3, 400
_LATE = 2.0
"""Scaled: a path for earlier times lies no farther right."""


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
    the largest one rises. digits: 1 to 100; the balls are worked for to a radius of 10^−digits of the static motion,
    and are returned whatever their radius is. spectrum: of `certify(problem, digits=digits + 10)` at least, with all
    roots that grow; without it that is computed.

    Proved are paths for one contact on any track whose waves far out are known (beams, layers, strings, Timoshenko),
    at any place from the time on at which waves of finite speed have reached it; for more contacts on beams on
    foundations. InputError for what cannot be used;
    where a step of the proof fails the answer is undecided, with the reason.
    """
    digits = whole(digits, "digits", 1, MOST)
    require_problem(problem)
    require_own(problem, spectrum)
    exact = times_above_0(times)
    work = begun(effort)
    image = Image(problem, checked_places(problem, places))
    terms = exact_forces(image.pencil, loads)
    found = partial(certify, problem, check=False) if spectrum is None else spectrum
    try:
        asked = Asked(image, terms, [Exact(t) for t in exact], digits)
        parts = proved_parts(asked, found, work, progress or silent)
    except (EffortError, PrecisionError) as error:
        infinite = np.full((image.channels, len(exact)), arb(0, float("inf")), object)
        return _told(image, exact, [infinite] * 4, work.spent, _reason(error))
    return _told(image, exact, parts, work.spent, None)


@dataclass(frozen=True)
class Asked:
    """A problem with its places, what acts on it, the times, and to how many digits.

    exact: the places where they are irrational; the image then has them in float64.
    """

    image: Image
    terms: list[Term]
    times: list[Exact]
    digits: int
    exact: tuple[Exact, ...] = ()


def proved_parts(
    asked: Asked, spectrum: Spectrum | Callable[..., Spectrum], work: Effort, said: Progress
) -> tuple[Any, Any, Any, Any]:
    """The motion and its steady, harmonic and transient part, (channels, times) each; PrecisionError without a proof.

    spectrum: or what makes one of so many digits. InputError where more than 400 digits cancel.
    """
    said("frequencies", 0.0)
    least = max(asked.digits + 12, 20)
    found = spectrum(digits=least) if callable(spectrum) else spectrum
    lost = _lost(asked, found)
    if callable(spectrum) and lost > _SPARE:
        found = spectrum(digits=least + ceil(min(lost, _MOST_LOST)))
        lost = _lost(asked, found)
    if lost > _MOST_LOST:
        raise InputError(
            "loads",
            f"make parts of the motion that exceed their sum, or it the unit, by more than {_MOST_LOST} digits: "
            "change the frequency of a load that meets an induced frequency, or end earlier",
        )
    lost = max(0, ceil(lost))
    balls = BallImage(asked.image, asked.terms, asked.digits + lost + _GUARD, asked.exact)
    with precision(balls.bits):
        poles, floor = _poles(asked.image, found)
        at = [t.ball() * balls.rate_ball for t in asked.times]
        growth = max((float(z.real.upper()) for z in poles), default=0.0)
        line = above_growth(growth, max(_LATE, *(float(t) for t in at)))
        if not line.alpha > floor:
            raise PrecisionError("not all roots above the path are certified: certify a larger region")
        return Work(balls, poles, line, at, (asked.digits, lost), work, said, _alone(asked.image, found)).parts(
            _sizes(balls)
        )


def _lost(asked: Asked, spectrum: Spectrum) -> float:
    """Decimal digits to which the motion grows, and which cancel near a resonance: twice those of |q − ω|/|q|."""
    last, nearest, growth = max(map(float, asked.times)), 1.0, 0.0
    with precision(ceil((spectrum.digits + _GUARD) * log2(10))):
        for root in spectrum.roots:
            growth = max(growth, -float(root.q.imag.mid()))
            for _, load in asked.terms:
                if load.amplitude and load.frequency:
                    gap = abs(1 - abs(load.frequency).ball() / root.q)
                    nearest = min(nearest, max(float(gap.lower()), 0.0))
    return last * growth / log(10) - 2 * log10(nearest) if nearest else inf


def _reason(error: Exception) -> Reason:
    given = error.args[0] if error.args else ""
    if isinstance(given, Reason):
        return given
    message, _, remedy = str(error).partition(": ")
    return Reason("motion-path", message, {}, remedy)


def _poles(image: Image, spectrum: Spectrum) -> tuple[list[acb], float]:
    """σ̂ of all proved roots with Re q ≥ 0 or open, and the scaled Re σ̂ above which there is no other."""
    region = spectrum.region
    whole = isinstance(region, Sheet) or (isinstance(region, (HalfPlane, Below)) and region.radius is None)
    if not (whole and spectrum.proved):
        raise PrecisionError("the induced frequencies are undecided: certify with more effort")
    reduced = reduce_problem(image.problem)
    qs = [root.q for root in spectrum.roots] + list(unfelt_frequencies(reduced.parts))
    qs += [acb(0)] * bool(reduced.neutral)
    return [acb(0, 1) * q / rational_ball(Fraction(image.rate)) for q in qs], certified(image, spectrum).floor


def _alone(image: Image, spectrum: Spectrum) -> Callable[[complex], float]:
    """How far round a σ̂ all roots are certified: as far as the region of the spectrum reaches."""
    region = spectrum.region
    if isinstance(region, Sheet):
        return lambda _: inf
    height, reach = 0.0, inf
    if isinstance(region, Below):
        height, reach = float(region.height) / image.rate, float(region.reach or 0) / image.rate
    return lambda z: min(z.real + height, max(reach - abs(z.imag), z.real))


def _sizes(balls: BallImage) -> list[float]:
    """About the size of each kind of channel: what the digits are relative to."""
    image, values = balls.image, np.zeros(balls.image.channels)
    for at in (1.0, 0.1):
        sizes = [float(abs(x).mid()) for x in balls.values(balls.start(acb(at)))]
        values = np.maximum(values, np.array(sizes) * at)
    n, m = image.size, image.contacts
    for kind in (slice(0, n), slice(n, n + m), slice(n + m, None)):
        values[kind] = values[kind].max(initial=1e-300)
    return [float(x) for x in values]


def _told(
    image: Image, times: tuple[Fraction, ...], parts: Sequence[Any], count: int, reason: Reason | None
) -> ProvedVibration:
    total, steady, harmonic, transient = parts
    return ProvedVibration(
        times=times,
        places=image.places,
        **fields_of(image, total, steady=steady, harmonic=harmonic, transient=transient),
        status=Status.UNDECIDED if reason else Status.UNVERIFIED,
        reason=reason,
        evaluations=count,
    )
