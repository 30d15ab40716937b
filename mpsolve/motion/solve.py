"""The motion of the beam and of the contact points in time: the sum of its three parts, in float64."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING, Any, Literal, overload

import numpy as np

from mpsolve.certificate.on_sheet import AnySpectrum
from mpsolve.errors import InputError, PrecisionError, known
from mpsolve.fields import Float64
from mpsolve.model.branch import Track, track
from mpsolve.model.load import Load, loads_of
from mpsolve.model.parameters import Case, PhysicalCase
from mpsolve.motion.certified import proved_spectrum
from mpsolve.motion.contact import contact_loss, own_forces
from mpsolve.motion.contour import deformed_contour
from mpsolve.motion.forcing import Tone, tones
from mpsolve.motion.grid import checked_places, checked_times
from mpsolve.motion.sheets import sections
from mpsolve.motion.solution import HarmonicPair, HarmonicSolution, Response
from mpsolve.motion.transient import Motion, contour_integral
from mpsolve.motion.waves import Wave, induced_waves, steady_waves
from mpsolve.numbers.exact import Number
from mpsolve.parallel.threads import one_thread

if TYPE_CHECKING:
    from mpsolve.motion.enclosure import Enclosure, PreciseMotion

MISFIT = 1e-8  # of the initial conditions, relative to the steady and harmonic parts, above which nothing is returned
_LARGEST = 700.0  # of an exponent in float64


@overload
def response(
    case: Case | PhysicalCase,
    loads: Iterable[Load] | None = None,
    xi: Iterable[Number] | Number | None = None,
    tau: Iterable[Number] | Number = (0,),
    spectrum: AnySpectrum | None = None,
    digits: None = None,
    balls: Literal[False] = False,
) -> Response: ...
@overload
def response(
    case: Case | PhysicalCase,
    loads: Iterable[Load] | None = None,
    xi: Iterable[Number] | Number | None = None,
    tau: Iterable[Number] | Number = (0,),
    spectrum: AnySpectrum | None = None,
    *,
    digits: int,
    balls: Literal[False] = False,
) -> PreciseMotion: ...
@overload
def response(
    case: Case | PhysicalCase,
    loads: Iterable[Load] | None = None,
    xi: Iterable[Number] | Number | None = None,
    tau: Iterable[Number] | Number = (0,),
    spectrum: AnySpectrum | None = None,
    digits: int | None = None,
    *,
    balls: Literal[True],
) -> Enclosure: ...
def response(
    case: Case | PhysicalCase,
    loads: Iterable[Load] | None = None,
    xi: Iterable[Number] | Number | None = None,
    tau: Iterable[Number] | Number = (0,),
    spectrum: AnySpectrum | None = None,
    digits: int | None = None,
    balls: bool = False,
) -> Response | PreciseMotion | Enclosure:
    """The motion of an infinite beam from rest under moving masses and forces, (20)–(36).

    loads: one for each mass, by default those of `loads_of`. xi: positions in the moving frame, by default the
    positions of the masses. tau ≥ 0: the times. spectrum: `certify(case)`, if it is known already. digits: mpmath
    numbers instead of float64, each proved right to so many decimals; balls=True: the balls themselves, to 15 digits
    unless told; both where the cuts lie on a line (enclosure.py). Raises InputError for input
    that has no meaning, PrecisionError where the parts cannot be computed or do not meet the initial conditions; both
    say what helps.
    """
    if balls or digits is not None:
        from mpsolve.motion.enclosure import enclose_response, precise_response

        if balls:
            return enclose_response(case, loads, xi, tau, 15 if digits is None else digits, spectrum)
        return precise_response(case, loads, xi, tau, known(digits, "the number of digits"), spectrum)
    problem = prepare(case, loads, spectrum)
    places, times = checked_places(xi, problem.model.positions), checked_times(tau)
    return problem.response(places, times)


def harmonic_solution(
    case: Case | PhysicalCase,
    loads: Iterable[Load] | None = None,
    xi: Iterable[Number] | Number | None = None,
    tau: Iterable[Number] | Number = (0,),
    spectrum: AnySpectrum | None = None,
    digits: int | None = None,
) -> HarmonicSolution:
    """The steady and the unsteady harmonic part alone, (36); arguments and errors as for `response`.

    digits: mpmath numbers with as many digits (relative to the largest part) in arrays of objects, not float64; xi
    and tau then are exact numbers, and `spectrum` has to have 10 digits more.
    """
    if digits is not None:
        from mpsolve.motion.precise import precise_harmonic

        return precise_harmonic(case, loads, xi, tau, spectrum, digits)
    problem = prepare(case, loads, spectrum)
    return problem.harmonic(checked_places(xi, problem.model.positions), checked_times(tau))


@dataclass(frozen=True)
class Problem:
    """A case with its loads, and the waves of its closed-form parts."""

    case: Case
    loads: tuple[Load, ...]
    model: Track
    tones: tuple[Tone, ...]
    steady: tuple[Wave, ...]
    induced: tuple[Wave, ...]

    def harmonic(self, xi: Any, tau: Any) -> HarmonicSolution:
        growth = max((-wave.q.imag for wave in self.induced), default=0.0) * np.max(tau, initial=0.0)
        if growth > _LARGEST:
            raise InputError("tau", f"reaches {np.max(tau):g}, where the motion exceeds e^{growth:.0f}: end earlier")
        steady = [self._motion(wave, xi, tau) for wave in self.steady]
        zero = Motion(*(np.zeros((n, len(tau))) for n in (len(xi), self.count, self.count)))
        forced = sum(steady[1:], zero)
        pairs, harmonic = [], zero
        for wave in self.induced:
            part = self._motion(wave, xi, tau)
            harmonic = harmonic + part
            amplitude = wave.amplitude(self.model, xi)
            pairs.append(HarmonicPair(wave.q, wave.multiplicity, amplitude, part.displacement))
        total = steady[0] + forced
        return HarmonicSolution(
            total.displacement,
            forced.displacement,
            harmonic.displacement,
            tuple(pairs),
            total.velocity + harmonic.velocity,
            total.force + harmonic.force,
        )

    @property
    def count(self) -> int:
        return len(self.model.positions)

    def _motion(self, wave: Wave, xi: Any, tau: Any) -> Motion:
        turn = np.exp(1j * wave.q * tau)
        contacts = 1j * wave.q * wave.amplitude(self.model, self.model.positions)
        rows = (wave.amplitude(self.model, xi), contacts, np.array(wave.S) / 4)
        return Motion(*((row[:, None] * turn).real for row in rows))

    def transient(self, xi: Any, tau: Any) -> Motion:
        above = {wave.q: wave for wave in self.induced if wave.q.imag > self.model.eta_b}
        reach = (
            float(np.min(xi, initial=self.model.positions[0])),
            float(np.max(xi, initial=self.model.positions[-1])),
        )
        # tolerances are those of unit forces: the motion is linear in the loads
        size = max((abs(a) for tone in self.tones for a in tone.amplitudes), default=0.0) or 1.0
        scaled = [replace(tone, amplitudes=tuple(a / size for a in tone.amplitudes)) for tone in self.tones]
        with one_thread():
            contour = deformed_contour(self.model, scaled, sections(self.case), list(above), reach)
            part = contour_integral(self.model, scaled, contour, xi, tau) * size
        for q in contour.left_out:
            part = part + -self._motion(above[q], xi, tau)
        return part

    def response(self, xi: Any, tau: Any) -> Response:
        # the contact points and τ = 0 are always computed, to hold the result against the initial conditions
        places, times = np.concatenate([self.model.positions, xi]), np.concatenate([[0.0], tau])
        closed, cut = self.harmonic(places, times), self.transient(places, times)
        misfit = _misfit(closed, cut)
        if not misfit < MISFIT:
            raise PrecisionError(
                f"steady, harmonic and transient part miss the initial conditions by {misfit:.1e} of their size: "
                "this case is too close to a branch point or a double root, or its masses are too light or too close "
                "to each other, or its forces too fast, for float64; change a parameter slightly, or merge the masses"
            )
        velocity, force = (x[:, 1:] for x in (closed.velocity + cut.velocity, closed.force + cut.force))
        own, acceleration = own_forces(self.loads, [float(eta) for eta in self.case.eta_m], self.group, force, tau)
        first = contact_loss(self.loads, own, tau)
        keep = slice(self.count, None), slice(1, None)
        pairs = tuple(
            HarmonicPair(p.q, p.multiplicity, p.amplitude[keep[0]], p.contribution[keep])
            for p in closed.harmonic_pairs
        )
        return Response(
            self.case,
            self.loads,
            xi,
            tau,
            closed.steady[keep],
            closed.steady_harmonic[keep],
            closed.harmonic[keep],
            cut.displacement[keep],
            pairs,
            velocity[self.group],
            acceleration,
            own,
            tuple(time for time, _ in first),
            tuple(note for _, note in first),
            misfit,
        )

    @property
    def group(self) -> list[int]:
        """For each mass the number of its position."""
        places = list(dict.fromkeys(self.case.positions))
        return [places.index(place) for place in self.case.positions]


def prepare(
    case: Case | PhysicalCase, loads: Iterable[Load] | None = None, spectrum: AnySpectrum | None = None
) -> Problem:
    """The certified induced frequencies and the residues there; errors as for `response`."""
    forces = loads_of(case, loads)
    if isinstance(case, PhysicalCase):
        case = case.dimensionless
    spectrum = proved_spectrum(case, spectrum)
    field = Float64()
    return Problem(
        case,
        forces,
        track(case, field),
        tones(case, forces, field),
        steady_waves(case, forces),
        induced_waves(case, forces, spectrum),
    )


def _misfit(closed: HarmonicSolution, cut: Motion) -> float:
    """The largest |w| and |w_τ| at τ = 0 (the first time), relative to the largest part of either."""
    places = (closed.steady, closed.harmonic, cut.displacement)
    speeds = (closed.velocity, cut.velocity)
    size = max(float(np.max(np.abs(part[:, 0]))) for part in (*places, *speeds))
    missed = max(float(np.max(np.abs(sum(part[:, 0] for part in parts)))) for parts in (places, speeds))
    return missed / size if missed else 0.0
