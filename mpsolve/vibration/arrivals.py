"""How high frequencies are that still arrive: on a beam short waves run ahead, the shorter the faster.

A channel û turns with the frequency as e^{−iωd}, d the delay of its wave. Where d falls with ω, a wave of the ω with
d(ω) = t arrives at the time t: the path of integration has to be followed beyond it, or nothing of it is seen.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np

_OCTAVES, _A_STEP = 17, 1e-4
_FALLS, _SPARE = 0.93, 1.5
_BEYOND = 6.0
"""So far beyond the highest frequency that arrives the fading of the path may begin to be felt."""


def reach_of_waves(image: Callable[[Any], Any], alpha: float, times: Any, share: float, kinds: list[slice]) -> float:
    """The scaled Ω from which on no wave arrives at about one of the times that has a `share` of its kind's motion.

    image: û, (len(σ), channels), on Re σ = α; kinds: the channels that are measured together.
    """
    omega = 2.0 ** np.arange(0, _OCTAVES + 0.5, 0.5)
    at = np.sort(times)
    step = min(_A_STEP * at[0], 1e-2) * np.ones(len(omega))
    sigma = alpha + 1j * np.concatenate([omega, omega + step])
    with np.errstate(all="ignore"):
        here, there = np.split(image(sigma), 2)
        delay = -np.angle(there / here) / step[:, None]
        size = np.abs(here) * omega[:, None] / np.pi
    delay, size = np.nan_to_num(delay), np.nan_to_num(size)
    felt = np.zeros(size.shape, bool)
    for kind in kinds:
        felt[:, kind] = size[:, kind] > share * size[:, kind].max(initial=0.0)
    near = np.searchsorted(at, delay / _SPARE) < np.searchsorted(at, delay * _SPARE)
    late = near[:-1] & (delay[1:] < _FALLS * delay[:-1]) & felt[:-1]
    rows = np.flatnonzero(late.any(1))
    return _BEYOND * float(omega[rows[-1]]) if len(rows) else 0.0
