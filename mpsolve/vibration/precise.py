"""The motion to any number of digits, in mpmath, by the formulas of the float version.

Where the panels lie is decided in float64; more nodes on each give more digits. Roots come from `certify`. Nothing is
proved: what the motion is before t = 0, where it must vanish, and a lower Ω tell the error.
"""

from __future__ import annotations

import math
from collections.abc import Iterable
from dataclasses import replace
from fractions import Fraction
from typing import Any, NamedTuple

import numpy as np

from mpsolve.certificate.certify import certify
from mpsolve.errors import EffortError
from mpsolve.numbers.model import whole
from mpsolve.numbers.multiprecision import Rule, context
from mpsolve.outcome import Reason
from mpsolve.parallel.threads import one_thread
from mpsolve.problem.problem import Problem
from mpsolve.progress import Progress, silent
from mpsolve.proof.effort import Effort, begun
from mpsolve.spectrum.spectrum import Spectrum
from mpsolve.vehicles.loads import exact_forces, outer_forces
from mpsolve.vibration.balls.image import PreciseImage, number
from mpsolve.vibration.engine import Engine
from mpsolve.vibration.forcing import tones
from mpsolve.vibration.image import Image
from mpsolve.vibration.integral import sampled_line
from mpsolve.vibration.motion import PreciseVibration, fields_of, split, unknown_precise
from mpsolve.vibration.path import Path
from mpsolve.vibration.poles import Poles, certified, natural, require_own
from mpsolve.vibration.vibrate import checked_places, times_above_0

MOST = 200
_GUARD = 25
_LEAST = 24.0
_FURTHER = 1.5
"""So much further than needed the line is followed: what the rest changes is the error that is told."""
_FAR_OFF = 1e3
"""Of the digits asked for: an error from which on the answer says that they are not reached."""


def response_mp(
    problem: Problem,
    loads: Any = None,
    *,
    times: Iterable[Any],
    digits: int,
    places: Any = None,
    spectrum: Spectrum | None = None,
    effort: Effort | None = None,
    progress: Progress | None = None,
) -> PreciseVibration:
    """The motion from rest to `digits` digits (15 to 200) of the largest deflection, in mpmath; a minute at 20.

    Fewer are reached next to a wave front, as on strings: then `reason` says so, and `error` how many.
    problem, loads, places: as for `response`. times > 0, exact numbers: the smallest one sets the work. spectrum: of
    `certify(problem, digits=digits + 25)` at least; without it that is computed. InputError for what cannot be used.
    effort: where it is spent nothing is known, and `reason` says so; evaluations are those of the equations at one σ,
    those of `certify` are counted by themselves. progress hears of frequencies, residues and integral.
    """
    digits = whole(digits, "digits", 15, MOST)
    exact = times_above_0(times)
    work, said = begun(effort), progress or silent
    image = Image(problem, checked_places(problem, places))
    require_own(problem, spectrum)
    outer = outer_forces(image.pencil, loads)
    mp = context(digits + _GUARD)
    precise = PreciseImage(mp, image, exact_forces(image.pencil, loads), digits + _GUARD)
    try:
        found = _certified(problem, digits + _GUARD, effort, said) if spectrum is None else spectrum
        poles = certified(image, found)
        at = [mp.mpf(t.numerator) / t.denominator * precise.rate for t in exact]
        engine = Engine(image, tones(image, outer, ()), (), poles)
        path = engine.path(float(max(at)))
        made = _Work(precise, poles, found, digits, path, work, said)
        far = 4 * digits * math.log(10) / float(min(at))
        waves = engine.arriving(path, np.array([float(t) for t in at]), 10.0**-digits)
        omega = max(_FURTHER * far, _LEAST, 8 * natural(image), 5 * made.fastest, _FURTHER * waves)
        with one_thread():
            line = sampled_line(engine.transformed, path, omega)
        return _judged(made.motion(at, exact, line.panels.middle, line.panels.half, omega), digits)
    except EffortError as error:
        return unknown_precise(image, mp, exact, error.reason)


def _judged(found: PreciseVibration, digits: int) -> PreciseVibration:
    error = max(found.error)
    if error <= _FAR_OFF * 10.0**-digits:
        return found
    stated = f"the motion is off by {error:.1e} of itself, not 1e-{digits}, as next to a front that passes a place"
    return replace(found, reason=Reason("digits", stated, {}, "give times farther from it, or float64's `response`"))


def _certified(problem: Problem, digits: int, effort: Effort | None, said: Progress) -> Spectrum:
    """The roots; EffortError where the effort is spent on them."""
    said("frequencies", 0.0)
    found = certify(problem, digits=digits, check=False, effort=effort)
    if found.reason is not None and found.reason.code in ("effort", "interrupted"):
        raise EffortError(found.reason)
    return found


class _Residue(NamedTuple):
    """A pole and its moments (1/2πi) ∮ (σ − pole)^m û dσ, (terms, channels)."""

    sigma: Any
    moments: Any


_real = np.vectorize(lambda x: x.real, otypes=[object])


class _Work:
    """One motion in the making; everything scaled. Rows of channels are arrays of mpmath's numbers."""

    def __init__(
        self,
        image: PreciseImage,
        poles: Poles,
        spectrum: Spectrum,
        digits: int,
        path: Path,
        effort: Effort,
        said: Progress,
    ) -> None:
        self.image, self.mp, self.digits, self.effort, self.said = image, image.mp, digits, effort, said
        self.path = path
        rate = image.rate
        balls = [(number(self.mp, root.q), root.multiplicity) for root in spectrum.roots if root.q.real >= 0]
        self.roots = [(self.mp.mpc(0, 1) * q / rate, times) for q, times in balls]
        self.roots = [(z, times) for z, times in self.roots if z.real > poles.floor]
        self.cut, self.floor = poles.cut, poles.floor
        self.rule = Rule(self.mp, int(1.6 * digits) + 12)
        self.zero = np.full(image.image.channels, self.mp.mpf(0), object)

    @property
    def fastest(self) -> float:
        return max([float(abs(z)) for z, _ in self.roots] + [float(w) for w in self.image.frequencies], default=0.0)

    def motion(
        self, at: list[Any], exact: tuple[Fraction, ...], middle: Any, half: Any, omega: float
    ) -> PreciseVibration:
        """Everything at the times `at`."""
        mp, image, count = self.mp, self.image.image, len(at)
        self.said("residues", 0.0)
        steady, modes = self._steady(), self._modes()
        panels = []
        for k, (a, b) in enumerate(zip(middle, half, strict=True)):
            self.said("integral", k / len(middle))
            panels.append(self._panel(mp.mpf(float(a)), mp.mpf(float(b))))
        times = [*at, *(-mp.mpf(x) * 4 * self.digits * math.log(10) / omega for x in (1.0, 1.7))]
        wide, narrow = (self._along(panels, mp.mpf(x), times) for x in (omega, omega / _FURTHER))
        right, left = self.path.parted(modes)
        kept, free, beside, aside = (self._sum(poles, times) for poles in (steady, modes, right, left))
        below = self.path.below
        rest = wide - aside - (0 if below else kept)
        early = wide + beside + (kept if below else 0)  # what should vanish before t = 0
        parts = [rows[:, :count] for rows in (kept, free, rest)]
        total = parts[0] + parts[1] + parts[2]
        off = np.abs(wide - narrow)[:, :count].max(1) + np.abs(early)[:, count:].max(1)
        _, force, rail = (float(a.max() / np.abs(b).max()) if len(a) else 0.0
                          for a, b in zip(split(image, off), split(image, total), strict=True))  # fmt: skip
        rows = fields_of(image, total, steady=parts[0], harmonic=parts[1], transient=parts[2])
        return PreciseVibration(exact, image.places, **rows, error=(rail, force))

    def _panel(self, middle: Any, half: Any) -> tuple[Any, Any, list[Any], Any]:
        """Middle, half, nodes of ω, values there (nodes, channels)."""
        nodes = [middle + half * x for x in self.rule.nodes]
        return middle, half, nodes, np.array([self._value(self.path.line(w)) for w in nodes], object)

    def _value(self, sigma: Any) -> list[Any]:
        self.effort.spend(1)
        return self.image(sigma)

    def _along(self, panels: list[Any], omega: Any, times: list[Any]) -> Any:
        """(1/π) Re ∫ χ û e^{σt} dω, (channels, times)."""
        mp = self.mp
        width = omega / (2 * mp.sqrt(self.digits * mp.log(10)))
        out = np.full((len(self.zero), len(times)), mp.mpf(0), object)
        for middle, half, nodes, values in panels:
            self.effort.spend(0)
            share = np.array([mp.erfc((w - omega / 2) / width) / 2 for w in nodes], object)
            if max(share) < mp.mpf(10) ** (-self.digits - _GUARD):
                continue
            series = np.array([self.rule.series(list(column)) for column in (share[:, None] * values).T], object)
            for k, t in enumerate(times):
                moments = self.rule.moments(half * abs(t))
                if t < 0:
                    moments = [mp.conj(x) for x in moments]
                turn = half * mp.exp(self.path.line(middle) * t) / mp.pi
                out[:, k] += _real(turn * (series @ np.array(moments, object)))
        return out

    def _steady(self) -> list[_Residue]:
        """Poles of the loads with what they keep up, from circles round them."""
        poles = [self.mp.mpc(0), *(self.mp.mpc(0, w) for w in self.image.frequencies)]
        return [self._circle(z, 1) for z in poles]

    def _modes(self) -> list[_Residue]:
        return [self._circle(z, times) for z, times in self.roots]

    def _circle(self, middle: Any, times: int) -> _Residue:
        mp = self.mp
        others = [z for z, _ in self.roots] + [mp.mpc(0)] + [mp.mpc(0, w) for w in self.image.frequencies]
        gaps = [abs(middle - z) for other in others for z in (other, mp.conj(other))]
        room = middle.real - (self.floor if middle.real > self.floor else self.cut)
        radius = mp.mpf("0.3") * min([gap for gap in gaps if gap > abs(middle) * mp.mpf(10) ** -self.digits] + [room])
        count = 2 * (self.digits + _GUARD) + 8
        turns = np.array([radius * mp.expjpi(mp.mpf(2 * k + 1) / count) for k in range(count)], object)
        values = np.array([self._value(middle + turn) for turn in turns], object)
        return _Residue(middle, np.array([turns ** (m + 1) @ values / count for m in range(times)], object))

    def _sum(self, poles: list[_Residue], times: list[Any]) -> Any:
        """The motion of the poles and their mirror images, (channels, times)."""
        out = np.full((len(self.zero), len(times)), self.mp.mpf(0), object)
        for k, t in enumerate(times):
            for z, moments in poles:
                factor = self.mp.exp(z * t) * (2 if z.imag > 0 else 1)
                for m, row in enumerate(moments):
                    out[:, k] += _real(factor * t**m / self.mp.factorial(m) * row)
        return out
