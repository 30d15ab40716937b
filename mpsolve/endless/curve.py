"""A root of the endless row followed round the circle of z: the curve q(κ) of one Bloch motion, in float64."""

from __future__ import annotations

from typing import Any

import numpy as np

from mpsolve.endless.bloch import Bloch

_NEWTON = 6


def around(bloch: Bloch, theta: float, sigma: complex, points: int = 400) -> tuple[Any, Any]:
    """(θ, σ) for `points` values of θ from theta over a whole turn, each root from the one before by Newton's method.

    The curve closes where the root comes back to itself; below the cuts of the track it may end, as nan.
    """
    angles = theta + 2 * np.pi * np.arange(points + 1) / points
    out = np.full(points + 1, np.nan, complex)
    here = before = complex(sigma)
    for k, angle in enumerate(angles):
        guess = 2 * here - before if k > 1 else here
        for _ in range(_NEWTON):
            value, slope = bloch.delta(np.array([guess]), np.exp(1j * np.array([angle])))
            guess -= complex(value[0] / slope[0])
        if not np.isfinite(guess):
            break
        before, here = here, guess
        out[k] = guess
    return angles, out
