"""The integral along the line of a path, faded out towards high |Im σ|.

Fading by erfc averages the motion over times about 1/Ω with a weight whose moments vanish, so that it is felt only
where the motion has a corner: at the start of the loads, and where a wave front passes. Half of Ω tells how far.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

import numpy as np

from mpsolve.errors import PrecisionError
from mpsolve.vibration.panels import Panels, inverse, joined, sampled
from mpsolve.vibration.path import Path

CLEAR = 80.0
"""Ω t from which on the start at t = 0 is not felt through the fading."""
_SHARPNESS = 0.11
"""Of Ω: the width of the fading."""
_TOLERANCE = 3e-12
_MOST_PANELS = 4000
_OCTAVES = 10
_WIDEST = 1 / 24
_erfc = np.vectorize(math.erfc, otypes=[float])


@dataclass(frozen=True)
class Line:
    """The image sampled on the path's line, 0 ≤ ω ≤ Ω; left_open: by channels, of the integral over ω."""

    path: Path
    omega: float
    panels: Panels
    left_open: Any
    settled: bool

    def motion(self, times: Any) -> Any:
        """(channels, times)."""
        return inverse(self.panels, lambda w: faded(w, self.omega), self.path.alpha, times)

    def rate(self, times: Any) -> Any:
        """d/dt of the motion, (channels, times)."""
        sigma = self.path.line(self.panels.nodes)
        turned = Panels(self.panels.middle, self.panels.half, self.panels.values * sigma[..., None])
        return inverse(turned, lambda w: faded(w, self.omega), self.path.alpha, times)

    def change(self, times: Any) -> Any:
        """How much half of Ω would change it: more than its error where the image has decayed as powers do."""
        return inverse(self.panels, lambda w: faded(w, self.omega) - faded(w, self.omega / 2), self.path.alpha, times)

    def only(self, channels: Any) -> Line:
        """Some of the channels."""
        panels = Panels(self.panels.middle, self.panels.half, self.panels.values[..., channels])
        return Line(self.path, self.omega, panels, self.left_open[channels], self.settled)


def faded(w: Any, omega: float) -> Any:
    """1 below Ω/4, 0 above 3Ω/4, to 1e-9."""
    return 0.5 * _erfc((w - omega / 2) / (_SHARPNESS * omega))


def sampled_line(image: Callable[[Any], Any], path: Path, omega: float) -> Line:
    """The image, (len(σ), channels), on the line up to Ω."""
    breaks = np.concatenate([[0.0], omega * 2.0 ** np.arange(-_OCTAVES, 1)])
    return Line(path, omega, *_sampled(image, path, breaks, omega, 0.0))


def extended(image: Callable[[Any], Any], line: Line) -> Line:
    """The same up to 2Ω."""
    low, high = line.omega, 2 * line.omega
    more = _sampled(image, line.path, np.array([low, high]), high, line.panels.integral())
    panels = joined([line.panels, more[0]])
    return Line(line.path, high, panels, line.left_open + more[1], line.settled and more[2])


def _sampled(image: Any, path: Path, breaks: Any, omega: float, size: Any) -> tuple[Panels, Any, bool]:
    def tolerance(more: Any) -> Any:
        whole = size + more
        return _TOLERANCE * np.maximum(whole, 1e-6 * np.max(whole))

    try:
        return sampled(lambda w: image(path.line(w)), breaks, tolerance, _MOST_PANELS, omega * _WIDEST)
    except np.linalg.LinAlgError:
        stated = "the equations are singular on the path, as a root lies there"
        raise PrecisionError(f"{stated}: change a parameter a little") from None
