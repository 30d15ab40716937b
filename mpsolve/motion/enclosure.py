"""The motion in time in proved balls: steady, unsteady harmonic and truly transient part, (20)–(36).

The transient part is the integral of W̃ over a contour that is lifted across the cuts, less the poles above it that
belong to the other parts. What is proved on the way:

    which poles the contour passes       rigorous_path.py, from the certified induced frequencies
    that nothing else is passed          rigorous_sheet.py near, rigorous_tail.py far out
    the integral                         rigorous_quadrature.py
    what is cut off                      rigorous_tail.py
"""

from __future__ import annotations

import math
from collections.abc import Iterable
from dataclasses import dataclass
from typing import Any

import flint
import mpmath
import numpy as np

from mpsolve.certificate.on_sheet import AnySpectrum
from mpsolve.certificate.sheet import SheetSpectrum
from mpsolve.discs import DiscField
from mpsolve.errors import InputError, PrecisionError
from mpsolve.fields import ball_arithmetic
from mpsolve.model.branch import Track, track
from mpsolve.model.limits import require_cuts_on_line
from mpsolve.motion.certified import proved_spectrum
from mpsolve.motion.rigorous_forces import Setting, setting
from mpsolve.motion.rigorous_path import Guide, Route, float_track, guide, route
from mpsolve.motion.rigorous_quadrature import panels
from mpsolve.motion.rigorous_sheet import prove_clear
from mpsolve.motion.rigorous_sum import Samples, physical_start
from mpsolve.motion.rigorous_tail import far_start, tail
from mpsolve.motion.rigorous_waves import BallWave, induced, steady
from mpsolve.numbers.exact import Exact, Number, exact_list
from mpsolve.problem.case import Case
from mpsolve.problem.load import loads_of
from mpsolve.problem.physical import PhysicalCase
from mpsolve.vehicles.load import Load

acb, arb = flint.acb, flint.arb

MAX_TIME, MAX_DIGITS = 2_000, 100
_GUARD_BITS = 48
_LOWERED = (1.0, 0.6, 0.35, 0.2, 0.1)  # the height of the path, where zeros or branch points lie below it
_NODES = 12_000  # about: where the path ends at the latest
_EXTENT = 100
_SPARE = 3  # digits that the spectrum has in any case
_MOST_LOST = 400
_SLOW = "the truly transient part decays slowly near τ = 0; ask for later times, nearer positions or fewer digits"
_BLUNT = "the induced frequencies given are not sharp enough: certify with more digits, or leave `spectrum` out"


@dataclass(frozen=True)
class Enclosure:
    """Balls (flint.arb) of the motion from rest, each of shape (len(xi), len(tau)), as for `Response`.

    w is proved to hold steady + harmonic + transient. nodes: how often W̃ was evaluated.
    """

    case: Case
    loads: tuple[Load, ...]
    xi: tuple[Exact, ...]
    tau: tuple[Exact, ...]
    w: Any
    steady: Any
    harmonic: Any
    transient: Any
    nodes: int


def enclose_response(
    case: Case | PhysicalCase,
    loads: Iterable[Load] | None = None,
    xi: Iterable[Number] | Number | None = None,
    tau: Iterable[Number] | Number = (0,),
    digits: int = 15,
    spectrum: AnySpectrum | None = None,
) -> Enclosure:
    """The motion in balls proved to hold it, of a beam from rest under moving masses.

    loads, xi, tau, spectrum as for `response`. digits: the balls aim at a radius of 10^−digits times the displacement
    of a unit force; they are returned whatever their radius is. At early times the transient part decays with an
    algebraic tail only, so that the radius grows towards τ = 0: there, where w = 0, to 1e-12 … 1e-3, the more the
    farther apart the masses and the positions and the smaller the mass ratios. One path serves all positions: far
    ones widen the balls of near ones, so ask for them in another call. Digits that a growing motion or a force near
    an induced frequency costs are added to the work, unless `spectrum` is given.

    Takes seconds (three masses: ten to thirty): some thousand evaluations of W̃, which serve all positions and times.

    Raises InputError for input that has no meaning and for the regime not covered (overdamping),
    PrecisionError where a step of the proof fails; both say what helps.
    """
    forces = loads_of(case, loads)
    if isinstance(case, PhysicalCase):
        case = case.dimensionless
    _check_digits(digits)
    places, times = _checked(case, xi, tau)
    spectrum, lost = _sharp(case, forces, spectrum, digits, max((float(t) for t in times), default=0.0))
    with ball_arithmetic(math.ceil((digits + lost) * math.log2(10)) + _GUARD_BITS) as field:
        model, given = track(case, field), setting(case, forces, places, field)
        forced, free = steady(model, given), induced(model, given, spectrum)
        taus = [t.ball() for t in times]
        parts = [_summed(waves, len(places), taus) for waves in (forced, free)]
        cut, count = _transient(case, model, given, [*forced, *free], digits, taus, places)
        return Enclosure(case, forces, places, times, sum(parts) + cut, parts[0], parts[1], cut, count)


@dataclass(frozen=True)
class PreciseMotion:
    """mpmath numbers for the motion from rest, shape (len(xi), len(tau)) each, as for `Response`.

    Each is within 10^−digits of the truth, in units of the displacement of a unit force: a proved bound.
    """

    case: Case
    loads: tuple[Load, ...]
    xi: tuple[Exact, ...]
    tau: tuple[Exact, ...]
    digits: int
    w: Any
    steady: Any
    harmonic: Any
    transient: Any


def precise_response(
    case: Case | PhysicalCase,
    loads: Iterable[Load] | None = None,
    xi: Iterable[Number] | Number | None = None,
    tau: Iterable[Number] | Number = (0,),
    digits: int = 15,
    spectrum: AnySpectrum | None = None,
) -> PreciseMotion:
    """The middles of the balls of `enclose_response`; PrecisionError if a ball is wider than 10^−digits."""
    _check_digits(digits)
    found = enclose_response(case, loads, xi, tau, min(digits + 3, MAX_DIGITS), spectrum)
    parts = found.w, found.steady, found.harmonic, found.transient
    limit = arb(10) ** -digits
    for k, time in enumerate(found.tau):
        whole, closed, cut = (
            max((ball.rad() for part in some for ball in part[:, k]), default=arb(0), key=float)
            for some in (parts[:1], parts[1:3], parts[3:])
        )
        worst, why = max(whole, closed, cut, key=float), _SLOW if cut > closed else _BLUNT
        if not all(radius < limit for radius in (whole, closed, cut)):
            stated = f"at τ = {time.short()} the motion is known to {float(worst):.1e} only, not to {digits} decimals"
            raise PrecisionError(f"{stated}: {why}")
    values = [np.vectorize(_middle, otypes=[object])(part) for part in parts]
    return PreciseMotion(found.case, found.loads, found.xi, found.tau, digits, *values)


def _check_digits(digits: Any) -> None:
    if isinstance(digits, bool) or not isinstance(digits, int) or not 1 <= digits <= MAX_DIGITS:
        raise InputError("digits", f"is {digits!r}: give a whole number from 1 to {MAX_DIGITS}")


def _sharp(
    case: Case, loads: tuple[Load, ...], spectrum: AnySpectrum | None, digits: int, last: float
) -> tuple[SheetSpectrum, int]:
    """Induced frequencies with the digits that the sum of the parts needs, and how many of them it loses."""
    least = max(digits + 8, 20)
    known = proved_spectrum(case, spectrum, least)
    lost = _lost(known, loads, last)
    if spectrum is None and lost > _SPARE:
        known = proved_spectrum(case, None, least + math.ceil(min(lost, _MOST_LOST)))
        lost = _lost(known, loads, last)
    if lost > _MOST_LOST:
        raise InputError(
            "loads" if last * _growth(known) < _MOST_LOST else "tau",
            f"the parts of the motion exceed their sum, or it the unit, by more than {_MOST_LOST} digits: change the "
            "frequency of a force that meets an induced frequency, or end earlier",
        )
    return known, max(0, math.ceil(lost))


def _lost(spectrum: SheetSpectrum, loads: tuple[Load, ...], last: float) -> float:
    """Decimal digits to which the motion grows, and which cancel near a resonance: twice those of |q − ω|/|q|."""
    nearest = 1.0
    with ball_arithmetic(math.ceil(spectrum.digits * math.log2(10)) + _GUARD_BITS):
        for load in loads:
            for root in spectrum.roots if load.amplitude and load.frequency else ():
                gap = abs(1 - abs(load.frequency).ball() / root.q)
                nearest = min(nearest, max(float(gap.lower()), 0.0))
    return last * _growth(spectrum) - 2 * math.log10(nearest) if nearest else math.inf


def _growth(spectrum: SheetSpectrum) -> float:
    """Decimal digits a unit of τ by which the motion grows."""
    return max((float(-root.q.imag.mid()) for root in spectrum.roots), default=0.0) / math.log(10)


def _middle(ball: Any) -> Any:
    """The middle of a ball as an mpmath number, exactly."""
    mantissa, exponent = ball.mid().man_exp()
    return mpmath.mp.make_mpf(mpmath.libmp.from_man_exp(int(mantissa), int(exponent)))


def _checked(case: Case, xi: Any, tau: Any) -> tuple[tuple[Exact, ...], tuple[Exact, ...]]:
    require_cuts_on_line(case)
    places = case.merged.positions if xi is None else exact_list(xi, "xi")
    times = exact_list(tau, "tau")
    if any(t.sign < 0 for t in times):
        raise InputError("tau", "holds a time before 0, where the motion starts: give no earlier time")
    if any(float(t) > MAX_TIME for t in times):
        raise InputError("tau", f"holds a time beyond {MAX_TIME}, the longest for which balls are computed")
    for x in places:
        if not float(case.positions[0]) - _EXTENT <= float(x) <= float(case.positions[-1]) + _EXTENT:
            raise InputError("xi", f"holds {x.short()}, more than {_EXTENT} from the masses: give nearer positions")
    return tuple(places), times


def _summed(waves: list[BallWave], rows: int, taus: list[Any]) -> Any:
    total = np.full((rows, len(taus)), arb(0), dtype=object)
    for wave in waves:
        total += np.array([[wave.at(row, t) for t in taus] for row in range(rows)], dtype=object).reshape(total.shape)
    return total


def _transient(
    case: Case, model: Track, given: Setting, poles: list[BallWave], digits: int, taus: list[Any], places: Any
) -> tuple[Any, int]:
    total = np.full((len(places), len(taus)), arb(0), dtype=object)
    if not total.size:
        return total, 0
    times = np.array([float(t) for t in taus])
    spots = [float(x) for x in (*places, *case.positions)]
    plane: Any = DiscField()
    discs = track(case, plane)
    way, seeds, clear = _lifted(case, model, discs, poles, max(spots) - min(spots), times.max())
    goal = arb(10) ** -digits
    end = _end(model, way, given, clear, times.min(), goal)
    cut_off, fall = tail(model, way, given.tones, given.gaps, end), model.eta_b + way.delta * arb(end)
    tolerances = np.maximum(float(goal), float(max(cut_off, key=float)) * np.exp(-times * float(fall))) / 1000
    found = panels(discs, seeds, way, given.discs, given.disc_gaps, end, times, tolerances)
    if not physical_start(model, way, found):
        raise PrecisionError("the sheet at the start of the path could not be proved: change a parameter slightly")
    samples = Samples(model, seeds, way, found, given.balls, given.gaps)
    for column, t in enumerate(taus):
        sums = zip(samples.integral(t, goal / 100), found.errors(t), cut_off, strict=True)
        for row, (value, error, rest) in enumerate(sums):
            spread = error / model.field.pi + rest * (-t * fall).exp()
            total[row, column] = value / model.field.pi + arb(0, spread.upper())
    above = [pole for pole in poles if not way.passes_above(model, pole.q)]
    return total - _summed(above, len(places), taus), samples.count


def _lifted(
    case: Case, model: Track, discs: Track, poles: list[BallWave], extent: float, last: float
) -> tuple[Route, Guide, float]:
    """A path below which no zero and no branch point lies, with proof, and where its far field begins."""
    obstacles = [complex(pole.q.mid()) for pole in poles]
    for factor in _LOWERED:
        way = route(case, model, obstacles, extent, last, factor)
        seeds = guide(float_track(case), way)
        try:
            clear, _ = far_start(model, way)
            prove_clear(model, discs, seeds, way, clear)
        except PrecisionError:
            if factor == _LOWERED[-1]:
                raise
            continue
        return way, seeds, clear
    raise AssertionError("unreachable")


def _end(model: Track, way: Route, given: Setting, clear: float, first: float, goal: Any) -> float:
    """Where the path is cut off: what is left is below the goal at the first time, or the path is long enough."""
    end, longest = 1.02 * clear + 1, _NODES * way.delta / 10
    while end < longest:
        rest = tail(model, way, given.tones, given.gaps, end)
        fall = (-arb(first) * (model.eta_b + way.delta * arb(end))).exp()
        if all(bound * fall < goal for bound in rest):
            break
        end *= 1.2
    if not all(bound.is_finite() for bound in tail(model, way, given.tones, given.gaps, end)):
        raise InputError(
            "loads",
            "a force changes too fast for balls, whose path ends before its frequency: compute in float64, or with "
            "a lower frequency",
        )
    return end
