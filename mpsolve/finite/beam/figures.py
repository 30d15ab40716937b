"""A problem on the finite beam, solved with given figures: length, start, numbers of modes and steps."""

from __future__ import annotations

import math
from dataclasses import dataclass, replace
from typing import Any

import numpy as np

from mpsolve.errors import InputError
from mpsolve.finite.beam.march import UNKNOWN, Loading, Motion, march
from mpsolve.finite.beam.modes import Beam
from mpsolve.finite.case import hermite, positive
from mpsolve.numbers.float_list import checked_times, float_list
from mpsolve.parallel.threads import one_thread
from mpsolve.problem.case import Case
from mpsolve.vehicles.load import Load

LONGEST_STEP = 0.5
FEWEST_STEPS = 8
SHORTEST_WAVE = 2 / 3
"""Wavelength of the last mode, at first: three modes a unit of length."""
MOST_MODES = 40_000
MOST_WORK, MOST_STEPS = 1e9, 1_000_000
"""Most modes times steps, and most steps, of one march: some minutes."""


@dataclass(frozen=True)
class Figures:
    """What the finite model adds to the problem: dimensionless lengths, and counts."""

    start: float
    length: float
    modes: int
    steps: int


@dataclass(frozen=True)
class Answer:
    """Deflections (n + m, t) of the masses and the further points in w_st, contact forces (n, t) in unit forces."""

    deflection: Any
    force: Any

    @property
    def largest(self) -> float:
        return float(np.max(np.abs(self.deflection)))

    def change(self, other: Answer) -> tuple[float, float]:
        """The largest differences of the deflections and of the forces."""
        return (
            float(np.max(np.abs(self.deflection - other.deflection))),
            float(np.max(np.abs(self.force - other.force))),
        )


class Problem:
    """A case, its loads, and the times and moving coordinates that are asked for, checked; float64."""

    def __init__(self, case: Case, loads: tuple[Load, ...], tau: Any, xi: Any, tolerance: float) -> None:
        self.tau, self.xi = checked_times(tau), float_list(xi, "xi")
        if not self.tau.size or self.tau[-1] <= 0 or np.any(np.diff(self.tau) <= 0):
            raise InputError("tau", "is not an ascending list of times from 0 on: give at least one time above 0")
        self.tolerance = positive(tolerance, "tolerance")
        if self.tolerance >= 1:
            raise InputError("tolerance", f"is {self.tolerance:g}, not below 1: give the error accepted, in w_st")
        self.alpha, self.axial, self.eta_b = float(case.alpha), float(case.axial), float(case.eta_b)
        self.eta_m = np.array([float(eta) for eta in case.eta_m])
        self.gaps = np.array([float(x) - float(case.positions[0]) for x in case.positions])
        self.offsets = self.xi - float(case.positions[0])
        self.lowest = min(0.0, *self.offsets) if self.xi.size else 0.0
        self.highest = max(self.gaps[-1], *self.offsets) if self.xi.size else float(self.gaps[-1])
        self.loads = [tuple(map(float, (a.constant, a.amplitude, a.frequency, a.phase))) for a in loads]
        self.fastest = max(abs(frequency) if amplitude else 0.0 for _, amplitude, frequency, _ in self.loads)
        self.fixed: tuple[str, ...] = ()  # the figures that were given, which may be what makes the work too much
        self._answers: dict[Figures, Answer] = {}

    @property
    def duration(self) -> float:
        return float(self.tau[-1])

    @property
    def reach(self) -> float:
        """From the rearmost point at τ = 0 to the foremost one at the end."""
        return self.highest - self.lowest + self.alpha * self.duration

    def applied(self, tau: Any) -> Any:
        """2η_C + 2η_A sin(ω̂τ + φ) of every mass, (n, *tau.shape)."""
        return np.array([2 * c + 2 * a * np.sin(frequency * tau + phase) for c, a, frequency, phase in self.loads])

    def first_figures(self, start: float | None, length: float | None) -> Figures:
        """Figures to begin with; InputError where the load would not stay on the beam."""
        margin = self._static_margin()
        if start is not None:
            start = positive(start, "start")
            margin = start + self.lowest
            if margin <= 0:
                raise InputError("start", f"is {start:g}, and xi = {np.min(self.xi):g} is not on the beam: raise it")
            length = start - self.lowest + self.reach + margin if length is None else positive(length, "length")
        elif length is not None:
            length = positive(length, "length")
            margin = (length - self.reach) / 2
        else:
            length = self.reach + 2 * margin
        needed = self.reach + max(margin, 0.0)
        if length <= needed:
            stated = f"is {length:g}, but the load and the points watched cover {needed:g} from the left support"
            raise InputError("length", f"{stated} by the last time: give more than {needed:g}, or end tau earlier")
        steps = math.ceil(self.duration / min(LONGEST_STEP, 1 / max(self.fastest, 1e-9)))
        return Figures(margin - self.lowest, length, self._first_modes(length), max(FEWEST_STEPS, steps))

    def _static_margin(self) -> float:
        """Where the deflection under a resting force falls to the tolerance: by the least Im p > 0 of D(p, 0)."""
        p = np.roots([1, 0, -4 * self.axial, 0, 4])
        return math.log(1 / self.tolerance) / float(min(p.imag[p.imag > 0]))

    def _first_modes(self, length: float) -> int:
        shortest = max(2 * math.pi / SHORTEST_WAVE, 3 * self._travelling(), 4 * math.sqrt(2 * self.fastest))
        return math.ceil(length * shortest / math.pi)

    def _travelling(self) -> float:
        """The wavenumber beyond which a steady force radiates nothing: ω² > α²k² above."""
        return 2 * math.sqrt(max(self.axial + self.alpha**2, 0.0))

    def checked_modes(self, modes: int, length: float) -> int:
        least = math.ceil(1.25 * length * self._travelling() / math.pi) + 3
        return _count(modes, "modes", least, "the modes beyond would not follow the load as if at rest")

    def checked_steps(self, steps: int) -> int:
        return _count(steps, "steps", 2 * FEWEST_STEPS, "half of them must tell the error")

    def widened(self, figures: Figures) -> Figures:
        """Twice the distances from the supports, or the static margin more, with the same modes a length."""
        least = self._static_margin()
        left = figures.start + self.lowest
        right = figures.length - left - self.reach
        length = figures.length + max(left, least) + max(right, least)
        modes = math.ceil(figures.modes * length / figures.length)
        return replace(figures, start=figures.start + max(left, least), length=length, modes=modes)

    def richer(self, figures: Figures) -> Figures:
        """A third more modes."""
        return replace(figures, modes=math.ceil(figures.modes * 4 / 3))

    def finer(self, figures: Figures) -> Figures:
        """Twice as many steps."""
        return replace(figures, steps=2 * figures.steps)

    def solve(self, figures: Figures) -> Answer:
        """The answer with these figures, kept; InputError where they are beyond what can be computed."""
        excess = figures.modes > MOST_MODES or figures.steps > MOST_STEPS or figures.modes * figures.steps > MOST_WORK
        if excess:
            stated = f"needs {figures.modes} modes and {figures.steps} steps or more, beyond what is computed"
            given = " or ".join(self.fixed)
            remedy = f"lower {given}" if given else "raise it, or end tau earlier"
            raise InputError(self.fixed[0] if self.fixed else "tolerance", f"{stated}: {remedy}")
        if figures not in self._answers:
            beam = Beam(figures.length, figures.modes, self.alpha, self.axial, self.eta_b)
            degree = UNKNOWN + 2 if self.fastest else UNKNOWN
            loading = Loading(self.eta_m, figures.start + self.gaps, self.applied, degree)
            with np.errstate(over="ignore", invalid="ignore"), one_thread():
                answer = self._read(march(beam, loading, self.duration, figures.steps, self.offsets))
            if not np.isfinite(answer.largest):
                raise InputError("tau", f"reaches {self.duration:g}, where the motion overflows: end earlier")
            self._answers[figures] = answer
        return self._answers[figures]

    def _read(self, motion: Motion) -> Answer:
        """The motion at the times asked for."""
        mean, times = motion.acceleration, motion.times
        middle = (times[1:] + times[:-1]) / 2
        # means of the steps, freed of what alternates from step to step, then taken to the values in the middle
        smooth = mean.copy()
        smooth[:, 2:-2] = (4 * (mean[:, 1:-3] + mean[:, 3:-1]) + 10 * mean[:, 2:-2] - mean[:, :-4] - mean[:, 4:]) / 16
        smooth[:, 1:-1] -= np.diff(smooth, 2) / 24
        first = self.applied(0.0)[:, None] / self.eta_m[:, None]  # on an infinite beam f = 0 at first
        last = 1.5 * smooth[:, -1:] - 0.5 * smooth[:, -2:-1]
        nodes = np.concatenate([[0.0], middle, times[-1:]])
        values = np.concatenate([first, smooth, last], axis=1)
        acceleration = hermite(nodes, values, np.gradient(values, nodes, axis=1), self.tau)
        force = (self.applied(self.tau) - self.eta_m[:, None] * acceleration) / 2
        return Answer(hermite(times, motion.deflection, motion.velocity, self.tau), force)


def _count(value: int, key: str, least: int, why: str) -> int:
    if isinstance(value, bool) or not isinstance(value, (int, np.integer)):
        raise InputError(key, f"is {value!r}, not a whole number: give one of at least {least}")
    if value < least:
        raise InputError(key, f"is {value}, below {least}: {why}")
    return int(value)
