"""The answer of each mode to a force as a sum of exponentials: the roots of its determinant, and their residues.

What a step does to exponentials under moving forces is known in closed form: tables that do not change from step to
step. A mode a sin kx of a simply supported length L is Re(weight · z) with z_t = rate · z + (2/L) Σ_j f_j(t) sin k
x_j(t), and x_j moves at a constant velocity. Over a step f_j is f₀P₀ + f₁P₁, P₀ = 1, P₁ = 2θ − 1, and motions are
tested against both.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cache
from typing import Any

import numpy as np
from numpy.polynomial import legendre

from mpsolve.characteristic.symbol import horner
from mpsolve.finite.discretization import Discretization, in_s
from mpsolve.numbers.arrays import Complexes, Reals
from mpsolve.numbers.float64 import balanced, gaps, polynomial_and_slope

_SMALL = 3.0
_POINTS = 14
_LEGENDRE = np.array([[1.0, 0.0], [-1.0, 2.0]])
"""P₀ and P₁ in 1, θ."""
_MIRRORED = np.array([[1.0], [-1.0]])
"""What turns P_l read from the end of the step into P_l."""


@cache
def gauss(points: int) -> tuple[Reals, Reals]:
    """Nodes and weights of Gauss on [0, 1], each (points,)."""
    x, weight = legendre.leggauss(points)
    return (x + 1) / 2, weight / 2


def moments(z: Any, degree: int) -> Complexes:
    """∫₀¹ θ^d e^{zθ} dθ for d = 0 … degree, (degree + 1, *z.shape); good to 1e-14 where Re z ≲ 1, degree ≤ 8.

    By parts from d − 1 to d where |z| > 3, by Gauss elsewhere.
    """
    out = np.empty((degree + 1, *z.shape), complex)
    large = np.abs(z) > _SMALL
    far, near = z[large], z[~large]
    end = np.exp(far)
    value = (end - 1) / far
    out[0][large] = value
    for d in range(1, degree + 1):
        value = (end - d * value) / far
        out[d][large] = value
    theta, weight = gauss(_POINTS)
    wave = np.exp(np.multiply.outer(theta, near))
    for d in range(degree + 1):
        out[d][~large] = np.tensordot(weight * theta**d, wave, 1)
    return out


def nested_moments(p: Complexes, q: Any) -> Complexes:
    """∫₀¹ θ^a e^{pθ} ∫₀^θ σ^l e^{qσ} dσ dθ for a, l ≤ 1; (2, 2, *p.shape).

    The inner integral is taken in closed form where |q| > 3, by Gauss over σ/θ elsewhere.
    """
    out = np.zeros((2, 2, *p.shape), complex)
    large = np.abs(q) > _SMALL
    far = q[large]
    both, first = moments(p[large] + far, 2), moments(p[large], 1)
    for a in (0, 1):
        plain = (both[a] - first[a]) / far
        out[a, 0][large], out[a, 1][large] = plain, (both[a + 1] - plain) / far
    for node, weight in zip(*gauss(_POINTS), strict=True):
        inside = moments(p[~large] + q[~large] * node, 3)
        for a in (0, 1):
            out[a, 0][~large] += weight * inside[a + 1]
            out[a, 1][~large] += weight * node * inside[a + 2]
    return out


@dataclass(frozen=True)
class Waves:
    """Wavenumber, rate and weight of exponentials, each (E,); length of the track; velocity of the loads."""

    k: Any
    rate: Complexes
    weight: Complexes
    length: float
    velocity: float


@dataclass(frozen=True)
class WaveTables:
    """E exponentials, n contacts, two tests a, two force polynomials l.

    decay (E,): e^{rate h}. entry, two of (l, E): ∫ P_l e^{±ikx} as added to z. history, two of (a, E): ∫φ_a of the
    velocity under e^{±ikx} per unit z. direct (n, n, a, l): ∫φ_a of the velocity at contact i per force P_l at
    contact j, as far as it depends on x_i − x_j; image (a, l, E): the rest, per e^{ik(x_i + x_j)}. x at the start.
    """

    decay: Complexes
    entry: tuple[Complexes, Complexes]
    history: tuple[Complexes, Complexes]
    direct: Reals
    image: Any


def _nested(p: Complexes, q: Any, h: float) -> Any:
    """h ∫ P_a e^{pt} ∫₀^t P_l e^{qs}, lengths in units of the step h; (a, l, *p.shape)."""
    return h * np.einsum("am,lj,mj...->al...", _LEGENDRE, _LEGENDRE, nested_moments(p * h, q * h))


def wave_tables(waves: Waves, places: Reals, h: float) -> WaveTables:
    """The tables for contacts at these distances from one another, and steps h."""
    k, rate, weight = waves.k, waves.rate, waves.weight
    turn, share = 1j * waves.velocity * k, 2 / waves.length

    def entry(sign: int) -> Any:  # ∫ e^{rate(h − t)} P_l(t) of sin = Σ sign e^{sign ikx}/2i
        backward = _LEGENDRE @ moments((rate - sign * turn) * h, 1)
        return share * sign / 2j * h * np.exp(sign * turn * h) * _MIRRORED * backward

    def history(sign: int) -> Any:
        return weight * (rate + sign * turn) * sign / 2j * (_LEGENDRE @ moments((rate + sign * turn) * h, 1))

    def answer(out: int, entering: int) -> Any:  # the velocity along e^{out ikx} to a force along e^{entering ikx}
        strength = -out * entering / 4 * share * weight * (rate + out * turn)
        return strength * _nested(rate + out * turn, entering * turn - rate, h)

    wave = np.exp(1j * np.multiply.outer(places[:, None] - places, k))
    direct = np.einsum("ije,ale->ijal", wave, answer(1, -1)) + np.einsum("ije,ale->ijal", wave.conj(), answer(-1, 1))
    return WaveTables(
        decay=np.exp(rate * h),
        entry=(entry(1), entry(-1)),
        history=(history(1), history(-1)),
        direct=direct.real,
        image=answer(1, 1) + answer(-1, -1).conj(),
    )


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
    scaled, z, unit = balanced(coefficients.T)
    alone = gaps(z).min(-1) > _FAR * np.where(z == 0, 1, np.abs(z))
    for _ in range(_POLISH):
        value, slope = polynomial_and_slope(scaled, z)
        z = z - np.where(alone, value, 0) / np.where(alone, slope, 1)
    return z * unit


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
