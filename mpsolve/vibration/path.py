"""The path of integration, one for floats, mpmath and balls: up a line Re σ = α, and then perhaps to the left of it.

Its numbers are chosen once, in floats, and are exact in every arithmetic. In floats and mpmath the integral fades out
along the line, which stays to the right of the cuts; balls follow the parabola σ(r) = α − δ(r − r₀) + ir², r ≥ r₀,
that leaves the line at the height r₀²: there e^{σt} falls, and p-roots that are waves keep |Im p| bounded. What lies
to the right of the path comes as residues.

On a beam short waves run ahead, the shorter the faster. A wave P(σ) needs the time d = |ξ||dP/dσ| over the distance
ξ. Where d falls with the frequency, the wave of the ω with d(ω) = t arrives at the time t: the path has to be
followed beyond it, or nothing of it is seen.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable, Iterator
from dataclasses import dataclass, replace
from typing import Any

import numpy as np

from mpsolve.vibration.poles import Poles

RISE = 3.0
"""A line to the right of all growth is so far from it that e^{σt} grows by e^RISE more than the motion."""
_LEAST = 2.0
"""The least r at which a path leaves its line."""
_STEEP, _SPAN = 2.0, 0.25
"""δ at most, and times the distance of the first from the last contact."""
_LOWERED = 5
_OCTAVES, _STEP = 17, 1e-4
_FALLS, _SPARE = 0.93, 1.5
_TURNS = 1500.0
"""ωd at most that the path is followed to for this: further on it turns too often."""
_BEYOND = 6.0
"""So far beyond the highest frequency that arrives the fading of the path may begin to be felt."""


@dataclass(frozen=True)
class Leg:
    """A piece of the path: σ(x) and σ'(x) for x from `first` to `last`."""

    place: Callable[[Any], Any]
    slope: Callable[[Any], Any]
    first: float
    last: float


@dataclass(frozen=True)
class Path:
    """α, r₀ (infinite if the line goes on for ever) and δ, scaled.

    Arguments are numbers of any arithmetic that can be multiplied by 1j: float arrays, mpmath's, acb.
    """

    alpha: float
    start: float = math.inf
    delta: float = 0.0

    def line(self, omega: Any) -> Any:
        """The point of the line at the height ω."""
        return omega * 1j + self.alpha

    def lifted(self, r: Any) -> Any:
        """σ(r)."""
        return r * r * 1j - (r - self.start) * self.delta + self.alpha

    def slope(self, r: Any) -> Any:
        """σ'(r)."""
        return r * 2j - self.delta

    def legs(self, end: float) -> tuple[Leg, Leg]:
        """The line up to where the path leaves it, and the parabola up to r = end."""
        upward = Leg(self.line, lambda x: x * 0 + 1j, 0.0, self.start**2)
        return upward, Leg(self.lifted, self.slope, self.start, end)

    @property
    def below(self) -> bool:
        """Whether it runs below the axis, so that what the loads keep up comes as residues, too."""
        return self.alpha < 0

    def parted(self, poles: Iterable[Any]) -> tuple[list[Any], list[Any]]:
        """Of what has a `sigma`, what lies to the right of the line and what does not."""
        sides: tuple[list[Any], list[Any]] = [], []
        for one in poles:
            sides[not one.sigma.real > self.alpha].append(one)
        return sides


def below_axis(poles: Poles) -> Path | None:
    """A line between the cuts and the axis, far from roots on either side; None where they are not all known."""
    floor = poles.floor
    if floor >= 0 or not poles.complete:
        return None
    tries = floor * np.linspace(0.95, 0.35, 61)
    real = np.array([pole.sigma.real for pole in poles.poles])
    near = np.abs(tries[:, None] - real).min(1) if len(real) else np.full(len(tries), np.inf)
    return Path(float(tries[int(np.argmax(np.minimum(near, tries - poles.cut)))]))


def above_growth(growth: float, last: float) -> Path:
    """A line to the right of all roots, for times up to `last`."""
    return Path(max(0.0, growth) + RISE / last)


def bent(line: Path, fastest: float, span: float) -> Iterator[Path]:
    """Paths that leave the line above the `fastest` frequency, for contacts so far apart: the shortest one first."""
    start, delta = max(_LEAST, (1.5 * fastest) ** 0.5), min(_STEEP, _SPAN / span if span else _STEEP)
    for k in range(_LOWERED):
        yield replace(line, start=start * 1.25**k, delta=delta / 2**k)


def reach_of_waves(
    image: Callable[[Any], Any],
    waves: Callable[[Any], Any],
    distances: list[Any],
    path: Path,
    times: Any,
    share: float,
) -> float:
    """The scaled Ω from which on no wave arrives at about one of the times with a `share` of the motion.

    image: û, (len(σ), channels), on the path's line; waves: P, (len(σ), waves); distances: of each channel from the
    contacts. All channels are measured together: give those of one kind.
    """
    omega = 2.0 ** np.arange(0, _OCTAVES + 0.5, 0.5)
    sigma = path.line(omega)
    with np.errstate(all="ignore"):
        size = np.nan_to_num(np.abs(image(sigma)) * omega[:, None])
        slow = _slopes(waves, sigma)
    falls = slow[1:] < _FALLS * slow[:-1]
    longest = max((float(np.max(xi, initial=0.0)) for xi in distances), default=0.0)
    within = omega[:-1] * slow[:-1, 0] * longest < _TURNS
    at, felt = np.sort(times), (size[:-1] > share * size.max(initial=0.0)) & within[:, None]
    highest = 0.0
    for k, xi in enumerate(distances):
        delay = np.multiply.outer(np.asarray(xi, float), np.where(falls, slow[:-1], 0.0))
        near = np.searchsorted(at, delay / _SPARE) < np.searchsorted(at, delay * _SPARE)
        rows = np.flatnonzero(near.any((0, 2)) & felt[:, k])
        highest = max(highest, float(omega[rows[-1]]) if len(rows) else 0.0)
    return _BEYOND * highest


def _slopes(waves: Callable[[Any], Any], sigma: Any) -> Any:
    """|dP/dσ| of each wave, (len(σ), waves), the steepest first."""
    step = _STEP * np.abs(sigma)
    here, there = waves(sigma), waves(sigma + 1j * step)
    moved = np.abs(there[:, None, :] - here[:, :, None]).min(2) / step[:, None]
    return -np.sort(-np.nan_to_num(moved), axis=1)
