"""Irregularities of rail and wheels as the march meets them: their rates, tested over each step."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np

from mpsolve.vibration.forcing import Irregularity


def rough_rates(rough: Sequence[Irregularity], contacts: int, h: float, steps: int) -> Any:
    """∫φ_a dr/dθ over each step of length h, (steps, contacts, a), φ_0 = 1, φ_1 = P₁; r compresses where positive.

    In parts: r(1) − r(0), and r(1) + r(0) − 2 ∫r, which is in closed form for r = A sin(ωt + φ).
    """
    if not rough:
        return np.zeros((steps, contacts, 2))
    size, omega, phase = (
        np.array([getattr(one, key) for one in rough]) for key in ("amplitude", "frequency", "phase")
    )
    turn = np.multiply.outer(np.arange(steps + 1) * h, omega) + phase
    r = size * np.sin(turn)
    middle = (turn[1:] + turn[:-1]) / 2
    mean = size * np.sin(middle) * np.sinc(omega * h / (2 * np.pi))
    return np.stack([r[1:] - r[:-1], r[1:] + r[:-1] - 2 * mean], axis=-1)
