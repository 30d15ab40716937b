"""The answer of each mode to a force as a sum of exponentials: the roots of its determinant, and their residues."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np

from mpsolve.characteristic.symbol import horner
from mpsolve.finite.discretization import Discretization, in_s
from mpsolve.numbers.arrays import Complexes, Reals
from mpsolve.numbers.float64 import companions, polynomial_and_slope
from mpsolve.numbers.wave_tables import Waves

_APART = 1e-5
"""Nearer roots, relative to their size, are moved apart to this distance, which changes the mode by its square."""
_POLISH = 3
_FAR = 1e-3


@dataclass(frozen=True)
class Exponentials:
    """w_j(t) = Re Σ weight e^{rate t} after a unit impulse, for the modes j = 1 … J.

    k (J,): wavenumbers. rate, weight (R, J): of each exponential; of two conjugate ones the upper stands for both.
    Modes with fewer ones than R have some of rate and weight 0. turn: 1 where modes are sines, i where cosines.
    """

    k: Any
    rate: Complexes
    weight: Complexes
    turn: complex = 1

    def waves(self, length: float, velocity: float) -> Waves:
        """All in a row, for the tables of a step."""
        return Waves(np.tile(self.k, len(self.rate)), self.rate.ravel(), self.weight.ravel(), length, velocity)


def exponentials(track: Discretization) -> Exponentials:
    """The exponentials of every mode: roots of the exact determinant, float64."""
    k = track.wavenumbers
    degree = max(j for _, j in track.dispersion)
    D, N = in_s(track.dispersion, k, degree), in_s(track.numerator, k, degree - 1)
    roots = separated(_roots(D))
    kept = roots.imag >= 0
    weight = np.where(kept, np.where(roots.imag > 0, 2, 1) * _residues(D[-1], N, roots), 0)
    if track.guided:
        weight[0] /= 2  # ∫ of a cosine² is L/2, but L of the first one
    first = np.argsort(~kept, axis=-1, kind="stable")[:, : int(kept.sum(-1).max())]
    rate = np.where(kept, roots, 0)
    return Exponentials(
        k, np.take_along_axis(rate, first, -1).T, np.take_along_axis(weight, first, -1).T, 1j if track.guided else 1
    )


def _roots(coefficients: Reals) -> Complexes:
    """The roots in s of each mode, (J, degree), sharpened by Newton where they stand alone."""
    degree = len(coefficients) - 1
    scale = np.abs(coefficients[0] / coefficients[-1]) ** (1 / degree)
    scale = np.where(scale > 0, scale, 1.0)
    scaled = coefficients * scale ** np.arange(degree + 1)[:, None]
    scaled = scaled / scaled[-1]
    z = np.linalg.eigvals(companions(scaled.T)).astype(complex)
    alone = _gaps(z) > _FAR
    for _ in range(_POLISH):
        value, slope = polynomial_and_slope(scaled.T, z)
        z = z - np.where(alone, value, 0) / np.where(alone, slope, 1)
    return z * scale[:, None]


def _gaps(z: Complexes) -> Any:
    """The distance from each root to the nearest other one, relative to its size."""
    gap = np.abs(z[:, :, None] - z[:, None, :])
    gap[:, range(z.shape[1]), range(z.shape[1])] = np.inf
    return gap.min(-1) / np.where(z == 0, 1, np.abs(z))


def separated(roots: Complexes) -> Complexes:
    """The roots, (J, degree) with their conjugates, with those that nearly meet set apart about their middle."""
    z = roots.copy()
    for i in range(z.shape[1]):
        for j in range(i):
            middle = (z[:, i] + z[:, j]) / 2
            near = np.abs(z[:, i] - z[:, j]) < _APART * np.abs(middle)
            real = np.abs(middle.imag) < _APART * np.abs(middle)
            half = np.where(real, 1j, 1.0) * (_APART / 2) * np.abs(middle)
            middle = np.where(real, middle.real, middle)
            z[near, i], z[near, j] = (middle + half)[near], (middle - half)[near]
    return z


def _residues(lead: Reals, numerator: Reals, roots: Complexes) -> Any:
    others = roots[:, :, None] - roots[:, None, :]
    others[:, range(roots.shape[1]), range(roots.shape[1])] = 1
    return horner([c[:, None] for c in numerator], roots) / (lead[:, None] * others.prod(-1))
