"""A motion as it is computed, read at any time: forced parts, modes, the line; and one of which nothing is known."""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import Any

import numpy as np

from mpsolve.numbers.arrays import Integers, Reals
from mpsolve.outcome import Reason
from mpsolve.vibration.forcing import Forced
from mpsolve.vibration.image import Image
from mpsolve.vibration.integral import ORDER, Line, Panels
from mpsolve.vibration.path import Path
from mpsolve.vibration.residues import Mode


@dataclass(frozen=True)
class Parts:
    """(channels, times) each: what constant loads keep up, what harmonic ones do, the modes, and the rest."""

    static: Reals
    forced: Reals
    free: Any
    transient: Reals

    @property
    def total(self) -> Any:
        return self.static + self.forced + self.free + self.transient


@dataclass(frozen=True)
class Solution:
    """A motion at any time: forced parts, modes, and the line; held: a constant motion that was there before.

    first: what acts at once after t = 0, as on a wheel without mass. error: by channels, what panels, fading and
    causality leave open. reason: why no better one was worked for, where effort ran out.
    """

    image: Image
    held: Reals
    steady: tuple[Forced, ...]
    modes: tuple[Mode, ...]
    line: Line
    first: Reals
    error: Reals
    reason: Reason | None = None

    def parts(self, times: Any) -> Parts:
        """At times t̂ > 0."""
        zero = np.zeros((self.image.channels, len(times)))
        static = sum((one.motion(times) for one in self.steady if not one.frequency), zero)
        waves = sum((one.motion(times) for one in self.steady if one.frequency), zero)
        free = sum((mode.motion(times) for mode in self.modes), zero)
        rest = self.line.motion(times)
        if not self.line.path.below:
            rest = rest - static - waves
        _, left = self.line.path.parted(self.modes)
        rest = rest - sum((mode.motion(times) for mode in left), zero)
        return Parts(static + self.held[:, None], waves, free, rest)

    def rates(self, times: Any) -> Reals:
        """The rate of the sum at times t̂ ≥ 0, per unit of t̂, (channels, times); 0 at 0, where all is at rest."""
        return np.where(times == 0, 0.0, sum((one.rate(times) for one in self.right), self.line.rate(times)))

    def moved(self, times: Any) -> Reals:
        """The motion without what is held, (channels, times); at times < 0 it is 0 but for errors."""
        return sum((one.motion(times) for one in self.right), self.line.motion(times))

    def swing(self, time: float) -> Reals:
        """By channels: the motion is no further from what constant loads keep up, at this time t̂ > 0 and ever after.

        Infinite where that is not seen from sizes alone.
        """
        line = self.line
        if not line.path.below:
            return np.full(len(line.left_open), np.inf)
        rest = line.panels.integral() * np.exp(line.path.alpha * time) / np.pi
        waves = sum((np.abs(one.amplitude) for one in self.steady if one.frequency), rest)
        return sum((mode.most(time) for mode in line.path.parted(self.modes)[0]), waves)

    def only(self, channels: Integers) -> Solution:
        """Some of the channels, of which `moved` then tells."""
        return replace(
            self,
            held=self.held[channels],
            steady=tuple(replace(one, amplitude=one.amplitude[channels]) for one in self.steady),
            modes=tuple(replace(mode, moments=mode.moments[:, channels]) for mode in self.modes),
            line=self.line.only(channels),
        )

    @property
    def right(self) -> list[Any]:
        """What comes as residues: all that lies to the right of the path."""
        path = self.line.path
        return path.parted(self.modes)[0] + (list(self.steady) if path.below else [])


def unknown_solution(image: Image, reason: Reason) -> Solution:
    """No number of it is one."""
    nothing, endless = np.full(image.channels, np.nan), np.full(image.channels, np.inf)
    panels = Panels(np.empty(0), np.empty(0), np.empty((0, ORDER, image.channels)))
    return Solution(
        image, nothing, (), (), Line(Path(np.nan), np.nan, panels, endless, False), nothing, endless, reason
    )


def unknown_parts(image: Image, times: Any) -> Parts:
    """(channels, times) of NaN each."""
    return Parts(*np.full((4, image.channels, len(times)), np.nan))
