"""Judging boxes that may be laid along the curve on which two waves, one ahead and one behind, all but meet.

Next to it the receptance varies as quickly as there is little damping: across, but not along. With D(P, σ, x) = 0 =
D_P at their meeting point the curve has the slope dσ/dx = −D_x/D_σ. It chooses; nothing rests on it.
"""

from __future__ import annotations

from typing import Any

import numpy as np

from mpsolve.numbers.arrays import Complexes, Reals
from mpsolve.numbers.quadratic import Quadratic
from mpsolve.proof.sheared import rounded
from mpsolve.ranges.judge import Judge

_LEAST, _MOST = 0.25, 1.5  # of what x moves beside what q does, for boxes that are laid along
_LEFT = 0.15  # of it that may be left, by bends and by what no real slope takes away
_NEAR = 1.5  # boxes away from the curve
_APART = 4.0  # times the distance of the two p-roots: how far others must be


class LeaningJudge(Judge):
    """Of a family of one parameter, and boxes with a row of slopes; says which are to get another slope."""

    def __call__(self, low: Any, high: Any) -> tuple[Any, ...]:
        kind, axis, _ = self.judged(low, high)
        slope = np.full(len(kind), np.nan)
        rows = np.flatnonzero(kind == 0)
        if len(rows) and 0 < self.matrix.receptance.track.up < self.matrix.family.degree:
            slope[rows] = self._slopes(low[:, rows], high[:, rows])
        return kind, axis, slope

    def _slopes(self, low: Reals, high: Reals) -> Reals:
        boxes, track = self.boxes(low, high), self.matrix.receptance.track
        y, rho = boxes.variables
        with np.errstate(all="ignore"):
            D = track.D(y, rho)
            z, _ = track.nodes(D)
            more = _more(D, z, track.up) * boxes.r[0] / boxes.r[1]
            return np.where(np.isfinite(more), rounded(low[-1] + more, low, high), np.nan)


def _more(D: Quadratic, z: Complexes, up: int) -> Reals:
    """By how much u₀ should move with u₁; nan where that helps little."""
    gap = np.abs(z[:, :up, None] - z[:, None, up:])
    flat = gap.reshape(len(z), -1)
    rows, pair = np.arange(len(z)), flat.argmin(1)
    P = (z[rows, pair // gap.shape[2]] + z[rows, up + pair % gap.shape[2]]) / 2
    whole = np.abs(z[:, :, None] - z[:, None, :]) + 1e300 * np.eye(z.shape[1])
    alone = np.sort(whole.reshape(len(z), -1), 1)[:, 2] > _APART * flat[rows, pair]
    n = np.arange(D.k.shape[-1])
    power = P[:, None] ** n
    a, b0, b1, c00, c01, c11 = (D.k * power).sum(-1)
    slope = (D.k[:3, :, 1:] * n[1:] * power[:, :-1]).sum(-1)
    turn = 2 * (D.k[0, :, 2:] * (n * (n - 1))[2:] * power[:, :-2]).sum(-1)
    more = (-b1 / b0).real
    along = slope[2] + more * slope[1]
    left = np.abs(b1 + more * b0) + np.abs(c11 + more * c01 + more**2 * c00 - along**2 / turn)
    share = np.abs(more)
    fine = alone & (share > _LEAST) & (share < _MOST) & (left < _LEFT * share * np.abs(b0))
    near = np.abs(a - slope[0] ** 2 / turn) < _NEAR * (np.abs(b0) + np.abs(b1))
    return np.where(fine & near, more, np.nan)
