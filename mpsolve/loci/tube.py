"""Tubes: discs that move with the parameter and hold exactly one root at each of its values, proved in batches.

Over a box |u₀| ≤ 1 (q̂ = q₀ + ρ u₀, complex), −1 ≤ u₁ ≤ 1 (x̂) the determinant vanishes where a scalar s does, whose
Taylor model is a + b₀u₀ + b₁u₁ + c₀₀u₀² + c₀₁u₀u₁ + c₁₁u₁² to within e. With u₀ = t u₁ + w, t near −b₁/b₀, and
|t| + κ ≤ 1: if |a| + |b₁ + b₀t| + |c₀₀|(|t| + κ)² + |c₀₁|(|t| + κ) + |c₁₁| + e < |b₀|κ, then for each u₁ there is
exactly one zero with |w| < κ, by Rouché's theorem against b₀w, and it has |w| ≤ the left side over |b₀|.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np

from mpsolve.characteristic.boxes import Boxes
from mpsolve.characteristic.free_matrix import FreeMatrix
from mpsolve.numbers.arrays import Complexes, Reals, Truths
from mpsolve.numbers.jets import UP
from mpsolve.numbers.quadratic import Quadratic
from mpsolve.proof.vanishing import Scalar, scalar

_LOST = 1 + 2.0**-40  # covers the rounding of the few operations after a model
_NOISE = 2.0**-48  # of |q̂| and the box: rounding of middles
_STEPS = 4


@dataclass(frozen=True)
class Tubes:
    """Arrays: from `low` to `high` in x̂ one root with |q̂ − (middle + slope (x̂ − at))| < outer, and even ≤ inner.

    good: where that is proved. near: about where the root is at `low` and at `high`; speed: about dq̂/dx̂ there. kind:
    where the boxes are, as `Room` says, once they are taken.
    """

    low: Reals
    high: Reals
    middle: Any
    slope: Complexes
    outer: Reals
    inner: Reals
    good: Truths
    near: tuple[Complexes, Complexes]
    speed: tuple[Complexes, Complexes]
    kind: Any = None

    @property
    def at(self) -> Reals:
        return self.low / 2 + self.high / 2

    def centre(self, x: Any) -> Any:
        """Of the disc at x̂."""
        return self.middle + self.slope * (x - self.at)

    def guess(self, x: float) -> Complexes:
        """About where the root is at x̂: the cubic with the values and slopes at the ends."""
        width = self.high - self.low
        s = (x - self.low) / np.where(width > 0, width, 1.0)
        (a, b), (u, v) = self.near, (slope * width for slope in self.speed)
        return a + s * (u + s * (3 * (b - a) - 2 * u - v + s * (2 * (a - b) + u + v)))

    def take(self, rows: Any) -> Tubes:
        """Those of some rows."""
        (near, far), (slow, fast) = self.near, self.speed
        return Tubes(
            self.low[rows], self.high[rows], self.middle[rows], self.slope[rows], self.outer[rows], self.inner[rows],
            self.good[rows], (near[rows], far[rows]), (slow[rows], fast[rows]),
            None if self.kind is None else self.kind[rows],
        )  # fmt: skip

    def holds(self, q: Any, radius: Any, x: Any) -> Any:
        """Whether a disc lies in the one that holds one root at x̂."""
        away = np.abs(q - self.centre(x)) + radius
        return self.good & (away * _LOST < self.outer)

    @property
    def mirrored(self) -> Any:
        """Whether the one root lies on the imaginary axis if it does so anywhere: its mirror image −q̄ is it, too."""
        away = np.maximum(np.abs(self.centre(self.low).real), np.abs(self.centre(self.high).real))
        return (2 * away + self.inner) * _LOST < self.outer


def scalar_over(matrix: FreeMatrix, middle: Any, rho: Reals, at: Reals, half: Reals) -> Scalar:
    """s over boxes: q̂ within `rho` of `middle` (complex), x̂ within `half` of `at`."""
    boxes = Boxes(np.stack([middle, at + 0j]), np.stack([rho, half]).astype(complex))
    with np.errstate(all="ignore"):
        A, G = matrix(boxes)
        return scalar(A, G.good)


def tubes(matrix: FreeMatrix, low: Any, high: Any, middle: Any, rho: Any) -> Tubes:
    """What is proved over boxes: q̂ within `rho` of `middle` (complex), x̂ from low to high."""
    at = low / 2 + high / 2
    half = np.maximum(high - at, at - low) * UP
    found = scalar_over(matrix, middle, rho, at, half)
    with np.errstate(all="ignore"):
        s = found.s
        b0, b1 = s.b
        c = np.abs(s.c)
        t = -b1 / b0
        lean = np.abs(t)
        kappa = 1 - lean * _LOST
        still = np.abs(s.a) + np.abs(b1 + b0 * t) + c[2] + s.e + 2.0**-45 * np.abs(s.k).sum(0)
        image = kappa
        for _ in range(_STEPS):  # all zeros with |w| ≤ image have the next one
            wide = lean + image
            image = np.minimum(image, (still + c[0] * wide**2 + c[1] * wide) / np.abs(b0) * _LOST)
        whole = still + c[0] + c[1]
        good = found.good & (kappa > 0) & (whole * _LOST < np.abs(b0) * kappa) & np.isfinite(whole)
        noise = _NOISE * (np.abs(middle) + rho)
        width = np.where(half > 0, half, 1.0)
        ends = [_zero(s, u) for u in (-1.0, 1.0)]
        near = tuple(middle + rho * u for u, _ in ends)
        speed = tuple(slope * rho / width for _, slope in ends)
        return Tubes(
            low, high, middle, t * rho / width, rho * kappa / _LOST - noise, rho * image * _LOST + noise, good,
            (near[0], near[1]), (speed[0], speed[1]),
        )  # fmt: skip


def _zero(s: Quadratic, u1: float) -> tuple[Complexes, Complexes]:
    """In floats: the zero u₀ of the model near its line at u₁, and du₀/du₁ there."""
    u0 = -(s.a + s.b[1] * u1) / s.b[0]
    for _ in range(4):
        value = s.a + s.b[0] * u0 + s.b[1] * u1 + s.c[0] * u0**2 + s.c[1] * u0 * u1 + s.c[2] * u1**2
        u0 = u0 - value / (s.b[0] + 2 * s.c[0] * u0 + s.c[1] * u1)
    return u0, -(s.b[1] + s.c[1] * u0 + 2 * s.c[2] * u1) / (s.b[0] + 2 * s.c[0] * u0 + s.c[1] * u1)
