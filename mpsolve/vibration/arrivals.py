"""How high frequencies are that still arrive: on a beam short waves run ahead, the shorter the faster.

A wave P(σ) needs the time d = |ξ||dP/dσ| over the distance ξ. Where d falls with the frequency, the wave of the ω
with d(ω) = t arrives at the time t: the path of integration has to be followed beyond it, or nothing of it is seen.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np

from mpsolve.vibration.path import Path

_OCTAVES, _STEP = 17, 1e-4
_FALLS, _SPARE = 0.93, 1.5
_TURNS = 1500.0
"""ωd at most that the path is followed to for this: further on it turns too often."""
_BEYOND = 6.0
"""So far beyond the highest frequency that arrives the fading of the path may begin to be felt."""


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
