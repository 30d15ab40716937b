"""A motion of which nothing is known, as the effort ran out before there was any: NaN, and errors without bound."""

from __future__ import annotations

from typing import Any

import numpy as np

from mpsolve.outcome import Reason
from mpsolve.vibration.engine import Parts, Solution
from mpsolve.vibration.image import Image
from mpsolve.vibration.integral import Line
from mpsolve.vibration.panels import ORDER, Panels
from mpsolve.vibration.path import Path


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
