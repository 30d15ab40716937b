"""What a tone keeps up for ever: the image's residue at its frequency."""

from __future__ import annotations

from dataclasses import dataclass
from math import comb
from typing import Any

import numpy as np

from mpsolve.errors import InputError
from mpsolve.vibration.forcing import Tone
from mpsolve.vibration.image import Image

_STEP = 1e-3
"""Scaled: from where limits at 0 are extrapolated."""
_SAME = 1e-9
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

    def rate(self, times: Any) -> Any:
        """d/dt of it."""
        return (1j * self.frequency * self.amplitude[:, None] * np.exp(1j * self.frequency * times)).real


def forced(image: Image, tone: Tone) -> Forced:
    """InputError where the frequency is an induced one, so that the motion has no bound."""
    at = np.array([1j * tone.frequency])
    amplitude, clear = np.full(1, np.nan), False
    with np.errstate(all="ignore"):
        A = image.matrices(at)[0][0]
        if np.isfinite(A).all():
            clear = float(np.linalg.svd(_even(A), compute_uv=False)[-1]) > _SINGULAR
            amplitude = image.solve(at, tone.column[None])[0] if clear else amplitude
        elif not tone.frequency:
            amplitude, clear = _limit(image, tone)
    if not clear or not np.isfinite(amplitude).all():
        said = f"act at {tone.frequency * image.rate:.6g} rad/s" if tone.frequency else "are constant"
        stated = f"{said}, a frequency at which vehicle and track move by themselves: the motion grows without end"
        raise InputError("loads", f"{stated}; change the frequency, or hold what moves by itself")
    return Forced(tone.frequency, amplitude if tone.frequency else amplitude.real + 0j)


def _limit(image: Image, tone: Tone) -> tuple[Any, bool]:
    """The amplitude as σ → 0 from the right, where p-roots meet common zeros of N and D; and whether there is one."""
    values = image.solve(_STEP * np.arange(1.0, 9.0), np.broadcast_to(tone.column, (8, len(tone.column)))).real
    best, fewer = (_extrapolated(values[:n]) for n in (8, 7))
    return best, bool(np.abs(best - fewer).max() <= _SAME * np.abs(best).max())


def _extrapolated(values: Any) -> Any:
    """To 0 from 1, 2, …: the polynomial through all."""
    n = len(values)
    weights = np.array([(-1.0) ** k * comb(n, k + 1) for k in range(n)])
    return weights @ values


def _even(A: Any) -> Any:
    """Rows and columns brought to the size 1."""
    A = A / np.maximum(np.abs(A).max(1, keepdims=True), 1e-300)
    return A / np.maximum(np.abs(A).max(0, keepdims=True), 1e-300)
