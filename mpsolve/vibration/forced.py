"""What a tone keeps up for ever: the image's residue at its frequency."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np

from mpsolve.errors import InputError
from mpsolve.vibration.forcing import Tone
from mpsolve.vibration.image import Image

_SINGULAR = 1e-13
"""The least singular value, of a matrix with rows and columns of size 1, that is told from 0."""


@dataclass(frozen=True)
class Forced:
    """Re(amplitude e^{iωt}); amplitude (channels,)."""

    frequency: float
    amplitude: Any

    def motion(self, times: Any) -> Any:
        """(channels, times)."""
        return (self.amplitude[:, None] * np.exp(1j * self.frequency * times)).real


def forced(image: Image, tone: Tone) -> Forced:
    """InputError where the frequency is an induced one, so that the motion has no bound."""
    at = np.array([1j * tone.frequency])
    try:
        with np.errstate(all="ignore"):
            amplitude = image.solve(at, tone.column[None])[0]
            least = float(np.linalg.svd(_even(image.matrices(at)[0][0]), compute_uv=False)[-1])
    except np.linalg.LinAlgError:
        least, amplitude = 0.0, np.full(1, np.nan)
    if not least > _SINGULAR or not np.isfinite(amplitude).all():
        said = f"act at {tone.frequency * image.rate:.6g} rad/s" if tone.frequency else "are constant"
        stated = f"{said}, a frequency at which vehicle and track move by themselves: the motion grows without end"
        raise InputError("loads", f"{stated}; change the frequency, or hold what moves by itself")
    return Forced(tone.frequency, amplitude if tone.frequency else amplitude.real + 0j)


def _even(A: Any) -> Any:
    """Rows and columns brought to the size 1."""
    A = A / np.abs(A).max(1, keepdims=True)
    return A / np.abs(A).max(0, keepdims=True)
