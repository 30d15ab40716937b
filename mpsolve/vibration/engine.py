"""A motion in three parts: forced, residues at induced frequencies, and the integral along a line below the cuts.

u(t) = Σ residues to the right of the path + (1/2πi) ∫ û e^{σt} dσ along it, in the physical region of the σ-plane,
where û is analytic but for poles. Before t = 0 the sum must vanish: a root that is left out, or a wrong residue,
shows there. Where the roots are not known as far as a path below the axis, it lies above all growth and no residue is
needed.
"""

from __future__ import annotations

import math
from contextlib import suppress
from dataclasses import dataclass, replace
from typing import Any

import numpy as np

from mpsolve.errors import EffortError, InputError, PrecisionError
from mpsolve.numbers.arrays import Complexes, Reals
from mpsolve.vibration.forcing import Tone, forced, transform
from mpsolve.vibration.image import Image
from mpsolve.vibration.integral import CLEAR, extended, sampled_line
from mpsolve.vibration.path import Path, above_growth, below_axis, reach_of_waves
from mpsolve.vibration.poles import Poles, natural
from mpsolve.vibration.residues import modes
from mpsolve.vibration.solution import Solution
from mpsolve.waves.speeds import wave_speeds

GOOD = 1e-8
"""Of the largest deflection: the error that is worked for; forces are worked for to a thousand times as much."""
_FORCES = 1000.0
_ROUNDED = 2e-10
_CANCELS = 2.0**-50
"""Of the largest part: what is lost where parts cancel, as next to a resonance."""
_STILL = 1e-6
"""Of what the forces would deflect a track at rest: less is none, as under a load that outruns the waves."""
_SLOW = 2.5
"""1/(√2 − 1): an error that falls as Ω^(−1/2), as that of a force soon after the start, is so much the change."""
_LEAST = 24.0
_LARGEST = 650.0
_HOPELESS = 1e6
"""Of GOOD: an error from which on nothing is returned."""
_AT_SPEED = 1e-4
_HIGH = (1e12, 1e10, 1e8, 1e6, 1e4)
_FARTHEST = 2.0**17
_JUDGED = 80
_BEFORE = -CLEAR * np.array([1.0, 1.7, 3.1])


@dataclass(frozen=True)
class _Verdict:
    """Over the error that is worked for: the largest error, and that before t = 0. felt: the share of the fading."""

    excess: float
    felt: float
    early: float


def _sample(times: Any) -> Any:
    """Some of the times > 0, the earliest and the last among them, to judge errors at; 1 where there is none."""
    positive = np.unique(times[times > 0])
    if not len(positive):
        return np.ones(1)
    if len(positive) <= _JUDGED:
        return positive
    ranks = np.unique(np.geomspace(1, len(positive), _JUDGED // 2).astype(int) - 1)
    even = np.linspace(0, len(positive) - 1, _JUDGED // 2).astype(int)
    return positive[np.union1d(ranks, even)]


@dataclass(frozen=True)
class Engine:
    """What acts on a problem from t = 0 on, what has acted for ever (constant), and the roots; times are scaled."""

    image: Image
    acting: tuple[Tone, ...]
    held: tuple[Tone, ...]
    poles: Poles

    def transformed(self, sigma: Any) -> Complexes:
        """û, (len(σ), channels)."""
        image = self.image
        return image.solve(sigma, transform(self.acting, sigma, image.size + image.contacts))

    def solve(self, times: Any) -> Solution:
        """The motion, for these times ≥ 0."""
        last = float(np.max(times, initial=0.0)) or 1.0
        growth = self.poles.growth * last
        if growth > _LARGEST:
            stated = f"reach {last / self.image.rate:g}, where the motion exceeds e^{growth:.0f}"
            raise InputError("times", f"{stated}: end earlier")
        path = self.path(last)
        found, excess, causal = self._along(path, times)
        if path.below and not causal and found.reason is None:
            try:
                other, worse, _ = self._along(above_growth(self.poles.growth, last), times)
                found, excess = (found, excess) if excess <= worse else (other, worse)
            except EffortError as error:
                found = replace(found, reason=error.reason)
        if not excess < _HOPELESS and found.reason is not None:
            raise EffortError(found.reason)
        if not excess < _HOPELESS:
            raise PrecisionError(f"the motion is off by {excess * GOOD:.1e} of itself, as {self._why()}")
        return found

    def _why(self) -> str:
        """Of what no motion was found, and what helps."""
        problem = self.image.problem
        for name, square in wave_speeds(problem.track).items():
            if abs(problem.v**2 / square - 1) < _AT_SPEED:
                return f"v is the speed of the {name}, where they do not run away: change v a little"
        return "a root is missing or growth is too fast: end earlier, or give spectrum=certify(problem)"

    def path(self, last: float) -> Path:
        """Below the axis where the roots allow it, else to the right of all growth, for times up to `last`."""
        return below_axis(self.poles) or above_growth(self.poles.growth, last)

    def _along(self, path: Path, times: Any) -> tuple[Solution, float, bool]:
        """The motion along this path, its error over that worked for, and whether it vanishes before t = 0."""
        steady = tuple(forced(self.image, tone) for tone in self.acting)
        held = sum((forced(self.image, tone).amplitude.real for tone in self.held), np.zeros(self.image.channels))
        turns = np.array([1j * one.frequency for one in self.acting])
        last = float(np.max(times, initial=0.0))
        taken = modes(self.transformed, self.poles.poles, turns, self.poles.floor, last)
        line = sampled_line(self.transformed, path, self._reach(path, times))
        some = _sample(times)
        while True:
            solution = Solution(self.image, held, steady, taken, line, self._first(), held)
            solution, verdict = self._judged(solution, some)
            causal = verdict.early <= max(1.0, verdict.excess / 10)
            if verdict.excess <= 1 or verdict.felt < 0.2 or not line.settled or line.omega > _FARTHEST:
                return solution, verdict.excess, causal
            try:
                line = extended(self.transformed, line)
            except EffortError as error:
                return replace(solution, reason=error.reason), verdict.excess, causal

    def _first(self) -> Reals:
        """lim σ û for σ → ∞: 0 for all that falls as a power of σ."""
        values = np.full((2, self.image.channels), np.nan)
        for high in _HIGH:  # as far out as float64 follows
            at = np.array([high, 100 * high], complex)
            with np.errstate(all="ignore"), suppress(np.linalg.LinAlgError):
                values = (self.transformed(at) * at[:, None]).real
            if np.isfinite(values).all():
                break
        return np.where(np.abs(values[1]) < 0.5 * np.abs(values[0]), 0.0, values[1])

    def _judged(self, solution: Solution, times: Any) -> tuple[Solution, _Verdict]:
        """With its error by channels."""
        line = solution.line
        parts = solution.parts(times)
        goal = self._goals(parts.total)
        largest = np.abs([parts.static, parts.forced, parts.free]).max((0, 2), initial=0.0)
        change = _SLOW * np.abs(line.change(times)).max(1, initial=0.0)
        before = np.abs(solution.moved(_BEFORE / line.omega)).max(1)
        grown = math.exp(max(line.path.alpha * float(np.max(times, initial=0.0)), 0.0)) / np.pi
        error = line.left_open * grown + before + change + _ROUNDED / GOOD * goal + _CANCELS * largest
        worst = int(np.argmax(error / goal))
        early = float((before / goal).max())
        verdict = _Verdict(float(error[worst] / goal[worst]), float(change[worst] / max(error[worst], 1e-300)), early)
        return replace(solution, error=error), verdict

    def _goals(self, total: Any) -> Any:
        """The errors that are worked for, by channels: of the largest deflection, force, or coordinate."""
        image = self.image
        largest = np.abs(total).max(1, initial=0.0)
        body, force, rail = (
            slice(0, image.size),
            slice(image.size, -len(image.places) or None),
            slice(-len(image.places) or len(largest), None),
        )
        largest[body] = np.maximum(largest[body], 1e-2 * largest[body].max(initial=0.0))
        for kind in (force, rail):
            largest[kind] = largest[kind].max(initial=0.0)
        still = _STILL * float(image.guide.g) * largest[force].max()
        for kind in (body, rail):
            largest[kind] = np.maximum(largest[kind], still)
        goal = GOOD * largest
        goal[force] *= _FORCES
        return np.maximum(goal, 1e-300)

    def _reach(self, path: Path, times: Any) -> float:
        positive = times[times > 0]
        first = float(positive.min()) if len(positive) else 1.0
        fast = [tone.frequency for tone in self.acting] + [abs(pole.sigma) for pole in self.poles.poles]
        waves = self.arriving(path, positive if len(positive) else np.ones(1), GOOD / 10)
        return max(CLEAR / first, _LEAST, 8 * natural(self.image), 5 * max(fast, default=0.0), waves)

    def arriving(self, path: Path, times: Any, share: float) -> float:
        """How far the path is followed for the sake of waves that run ahead of the rail's deflections."""
        image = self.image
        if not image.places:
            return 0.0
        rail = slice(image.size + image.contacts, None)
        away = np.subtract.outer(np.array(image.places, float), np.array(image.pencil.places, float))
        away = np.abs(away) * 2.0**-image.guide.length
        return reach_of_waves(
            lambda sigma: self.transformed(sigma)[:, rail], image.receptance.waves, list(away), path, times, share
        )
