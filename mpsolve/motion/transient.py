"""The truly transient part of the motion: what the branch cuts contribute to (32), in float64.

The integral over the deformed contour, less the induced frequencies above the cut line that it passes below: these
belong to the unsteady harmonic part.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from mpsolve.model.branch import Track
from mpsolve.motion.contour import Contour, images
from mpsolve.motion.forcing import Tone

_BLOCK = 512
_ENTRIES = 8_000_000  # of e^{iqτ} at a time, which bounds the memory: 128 MB
_NEGLIGIBLE = 1e-17  # what one node may leave out
_RATE = 1e-2  # what velocity and force count beside the displacement


@dataclass(frozen=True)
class Motion:
    """Displacement at ξ, and velocity and contact force of the masses (merged), each with the times last."""

    displacement: Any
    velocity: Any
    force: Any

    def __add__(self, other: Motion) -> Motion:
        pairs = ((self.displacement, other.displacement), (self.velocity, other.velocity), (self.force, other.force))
        return Motion(*(a + b for a, b in pairs))

    def __mul__(self, factor: float) -> Motion:
        return Motion(self.displacement * factor, self.velocity * factor, self.force * factor)

    def __neg__(self) -> Motion:
        return Motion(-self.displacement, -self.velocity, -self.force)


def contour_integral(track: Track, tones: Sequence[Tone], contour: Contour, xi: Any, tau: Any) -> Motion:
    """(1/2π) ∫ W̃ e^{iqτ} dq over the contour and its mirror image."""
    masses, order = len(track.positions), np.argsort(tau)
    points, place = np.unique(np.concatenate([track.positions, xi]), return_inverse=True)
    total = np.zeros((len(points) + 2 * masses, len(tau)))
    for part in contour.nodes:
        for k in range(0, len(part.q), _BLOCK):
            block = part[k : k + _BLOCK]
            w, S = images(track, tones, block, points)
            rows = np.concatenate([w, 1j * block.q * w[place[:masses]], S / 4]) * (block.weights / np.pi)
            _accumulate(total, rows, block.q, tau, order, len(points))
    return Motion(total[place[masses:]], total[len(points) : -masses], total[-masses:])


def _accumulate(total: Any, rows: Any, q: Any, tau: Any, order: Any, shown: int) -> None:
    """Adds Re Σ rows e^{iqτ}, for the times at which it matters; the first `shown` rows are displacements."""
    size = np.maximum(np.abs(rows[:shown]).max(axis=0), _RATE * np.abs(rows[shown:]).max(axis=0))
    excess = np.log(np.maximum(size, 1e-300) / _NEGLIGIBLE)
    last = np.max(np.where(excess > 0, excess / np.maximum(q.imag, 1e-300), 0.0))
    used = order[: np.searchsorted(tau[order], last, side="right")]
    width = max(1, _ENTRIES // len(q))
    for k in range(0, len(used), width):
        some = used[k : k + width]
        total[:, some] += _sums(rows, q, tau[some])


def _sums(rows: Any, q: Any, tau: Any) -> Any:
    """Re Σ rows e^{iqτ} over the nodes, shape (rows, times), ascending τ.

    Evenly spaced times after the first, τ = τ₁ + jδ: with j = ab + c, e^{iqτ} is a product of a few exponentials, and
    the sum one of matrices.
    """
    first, rest = tau[:1], tau[1:]
    step = (rest[-1] - rest[0]) / max(len(rest) - 1, 1) if len(rest) else 0.0
    even = len(rest) > 64 and np.allclose(rest, rest[0] + step * np.arange(len(rest)), rtol=0, atol=1e-15 * rest[-1])
    if not even:
        return (rows @ np.exp(1j * q[:, None] * tau)).real
    width = int(np.sqrt(len(rest)))
    coarse = np.exp(1j * rest[::width, None] * q)
    fine = np.exp(1j * q[:, None] * (step * np.arange(width)))
    later = ((rows[:, None] * coarse).reshape(-1, len(q)) @ fine).reshape(len(rows), -1)[:, : len(rest)]
    return np.concatenate([rows @ np.exp(1j * q[:, None] * first), later], axis=1).real
