"""Many cases as arrays: two masses at 0 and d, or one."""

from __future__ import annotations

from dataclasses import dataclass, fields
from functools import cached_property
from typing import Any

import numpy as np

from mpsolve.fields import Float64
from mpsolve.model.branch import Track
from mpsolve.problem.case import Case


@dataclass(frozen=True)
class Cases:
    """Arrays of one shape. A single mass is eta_1 with eta_2 = 0, at any d > 0: the second mass has no effect."""

    alpha: Any
    axial: Any  # N = η_N − η_S
    eta_b: Any
    eta_1: Any
    eta_2: Any
    d: Any

    def __getitem__(self, index: Any) -> Cases:
        return Cases(*(getattr(self, f.name)[index] for f in fields(self)))

    def __len__(self) -> int:
        return len(self.alpha)

    def exact(self, index: int) -> Case:
        """One case, its floats read as their shortest decimals."""
        eta = [float(self.eta_1[index]), float(self.eta_2[index])]
        masses = 2 if eta[1] else 1
        return Case(
            alpha=float(self.alpha[index]),
            eta_b=float(self.eta_b[index]),
            eta_n=float(self.axial[index]),
            eta_m=eta[:masses],
            positions=[0.0, float(self.d[index])][:masses],
        )

    @cached_property
    def track(self) -> Track:
        """The arrays as the formulas of the model take them."""
        return Track(
            Float64(), self.alpha, self.axial, self.eta_b, (self.eta_1, self.eta_2), (0.0 * self.d, self.d), True
        )

    @cached_property
    def limit(self) -> Any:
        """q_lm; zero or negative where the cuts are joined."""
        axial, alpha2, beta2 = self.axial, self.alpha**2, 1 - self.eta_b**2
        # stationary: z (z − 2N)² = α² (z² − 4Nz + 4β²) in z = p², at the largest root (model/limits.py)
        z = largest_real_root(-(4 * axial + alpha2), 4 * axial * (axial + alpha2), -4 * alpha2 * beta2)
        z = np.maximum(z, np.maximum(2 * axial, 0))
        return np.sqrt(z * (z - 4 * axial) + 4 * beta2) / 2 - self.alpha * np.sqrt(z)


def largest_real_root(a2: Any, a1: Any, a0: Any) -> Any:
    """The largest real root of y³ + a2 y² + a1 y + a0, real arrays, by Cardano's and Viète's formulas."""
    p, q = a1 - a2 * a2 / 3, a2 * (2 * a2 * a2 / 27 - a1 / 3) + a0
    square = q * q / 4 + p * p * p / 27
    root = np.sqrt(np.maximum(square, 0))
    cube = np.cbrt(-q / 2 - np.copysign(root, q))
    one = cube - p / (3 * np.where(cube == 0, 1, cube))
    size = np.sqrt(np.maximum(-p / 3, 0))
    size3 = size * size * size
    cosine = np.clip(-q / 2 / np.where(size3 == 0, 1, size3), -1, 1)
    y = np.where(square > 0, one, 2 * size * np.cos(np.arccos(cosine) / 3)) - a2 / 3
    for _ in range(2):
        slope = (3 * y + 2 * a2) * y + a1
        y = y - np.where(slope > 0, ((y + a2) * y + a1) * y + a0, 0) / np.where(slope > 0, slope, 1)
    return y
