"""The receptance of a family over boxes: integrals round circles, so that roots of one side may meet.

G(ξ ≥ 0) is the sum of the residues of N e^{Pξ}/D at the upper p-roots. Upper roots that are close to each other are
taken together, in one circle that leaves all others out, and so it does not matter whether they meet. On a circle
of radius R the trapezoidal rule errs by Σ c_n R^{n+1} over n + 1 = ±SAMPLES, ±2 SAMPLES, …, c_n the coefficients of
the Laurent series, |c_n| r^n ≤ max |f| on the circles of radius r within which f is analytic.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np

from mpsolve.characteristic.boxes import Wave, at
from mpsolve.numbers.arrays import Complexes, Reals, Truths
from mpsolve.numbers.float64 import gaps
from mpsolve.numbers.jets import TINY, UP, U, exponential
from mpsolve.numbers.quadratic import Quadratic

SAMPLES = 32
_TOGETHER = 0.3  # roots of one side closer than this share of the distance to the other side share a circle
_INNER, _OUTER = (
    0.05,
    0.85,
)  # where f is bounded, between the roots inside and the circle; of the next root's distance
_RADIUS = 0.4  # of a circle, relative to the distance of the next root outside
_GROWTH = 7.5  # over the largest distance: of a circle's outer radius
NOISE = 2.0**-36  # more than the points' rounding changes f, as the inner radius is at most _CLOSEST of the circle's
_CLOSEST = 0.9


def by_circles(wave: Wave, N: Quadratic, xi: Quadratic, upper: bool, fixed: bool) -> Quadratic:
    """G at the distances of one sign, from the roots of one side; fixed: whether no distance varies."""
    own = (np.arange(wave.z.shape[1]) < wave.up) == upper
    if not own.any():
        return Quadratic(np.zeros(xi.k.shape, complex), np.zeros(xi.e.shape), xi.m)
    circles = circles_of(wave, own, xi.size.max(1))
    f, points = samples(wave, N, circles)
    sums = _summed(f if upper else -f, points, xi, fixed)
    return Quadratic(sums.k, (sums.e + aliasing(wave, N, circles, xi)) * UP, sums.m)


def samples(wave: Wave, N: Quadratic, circles: Circles) -> tuple[Quadratic, Complexes]:
    """(N/D at the points of the active circles times their share of the integral over 2πi, the points)."""
    boxes = len(wave.z)
    turn = exponential(2j * np.pi * np.arange(SAMPLES) / SAMPLES)[0]
    arm = circles.radius[:, :, None] * turn
    points = (circles.centre[:, :, None] + arm).reshape(boxes, -1)
    weight = (np.where(circles.active[:, :, None], arm, 0) / SAMPLES).reshape(boxes, -1)
    inverse = at(wave.D, points).inverse()
    f = at(N, points) * inverse
    noise = NOISE * majorant(N, np.abs(points)) * inverse.size
    f = Quadratic(f.k, f.e + noise, f.m).times(weight)
    idle = weight == 0  # 1/D need not be bounded there
    return Quadratic(np.where(idle, 0, f.k), np.where(idle, 0.0, f.e), f.m), points


def _summed(f: Quadratic, points: Complexes, xi: Quadratic, fixed: bool) -> Quadratic:
    """Σ f e^{Pξ} over the points."""
    if not fixed:
        phase = Quadratic(xi.k[:, :, None, :], xi.e[:, None, :], xi.m).times(points[:, :, None])
        grown = phase.exp() * Quadratic(f.k[..., None], f.e[..., None], f.m)
        return grown.sum(-2)
    return summed(f, points, xi.a)


def summed(f: Quadratic, points: Complexes, xi: Any) -> Quadratic:
    """Σ f e^{Pξ} over the points, for numbers ξ of shape (boxes, distances)."""
    wave, lost = exponential(points[:, :, None] * xi[:, None, :])
    lost = lost + (2 * NOISE + 8 * U) * np.abs(points)[:, :, None] * np.abs(xi)[:, None, :]
    size = np.abs(wave)
    k = (f.k[:, :, None, :] @ wave)[:, :, 0]
    e = (f.e[:, None, :] @ (size * (1 + lost)))[:, 0]
    whole = np.abs(f.k).sum(0)[:, None, :]
    e = e + (whole @ (size * (lost + 16 * (points.shape[1] + 4) * U)))[:, 0]
    return Quadratic(k, e * UP + TINY, f.m)


@dataclass(frozen=True)
class Circles:
    """Shape (boxes, circles): centre and radius, the radii between which f is analytic, which of them count."""

    centre: Complexes
    radius: Reals
    inner: Reals
    outer: Reals
    active: Truths


def circles_of(wave: Wave, own: Truths, reach: Any, off_axis: bool = False) -> Circles:
    """A circle for each group of roots of one side, at the number of its first root; reach: the largest distance.

    A circle stays so small that e^{Pξ} grows little on it: what the models leave out is multiplied by that. off_axis:
    and on its side of Re P = 0.
    """
    z, other = wave.z[:, own], wave.z[:, ~own]
    count = z.shape[1]
    far = np.abs(z[:, :, None] - other[:, None, :]).min(2) if other.shape[1] else np.full(z.shape, np.inf)
    near = gaps(z, 0) <= _TOGETHER * np.minimum(far[:, :, None], far[:, None, :])
    for _ in range(max(count - 1, 0).bit_length()):
        near = (near.astype(float) @ near.astype(float)) > 0
    active = near.argmax(2) == np.arange(count)
    size = near.sum(2)
    centre = (near * z[:, None, :]).sum(2) / size
    away = np.abs(centre[:, :, None] - z[:, None, :])
    # a root of the group lies within size·tight of one of its nodes, if the others are further away
    inner = np.where(near, away, 0).max(2) + size * np.where(near, wave.tight[:, own][:, None, :], 0).max(2)
    outer = np.where(near, np.inf, away).min(2)
    if other.shape[1]:
        outer = np.minimum(outer, np.abs(centre[:, :, None] - other[:, None, :]).min(2))
    outer = np.minimum(outer, 4 * (np.abs(centre) + inner))
    if off_axis:
        outer = np.minimum(outer, np.abs(centre.real))
    outer = np.minimum(outer, np.maximum(_GROWTH / np.maximum(reach[:, None], TINY), 3 * inner))
    radius = np.where(active, np.maximum(_RADIUS * outer, np.sqrt(inner * outer)), 1.0)
    return Circles(centre, radius, inner + _INNER * (radius - inner), _OUTER * outer, active)


def aliasing(wave: Wave, N: Quadratic, circles: Circles, xi: Quadratic) -> Reals:
    """What the samples cannot see, shape (boxes, distances); ∞ where f is not bounded on the two circles.

    There |D| ≥ |lead| Π |P − z_k| (1 − Σ |a_k|/|P − z_k|) for both sides, so that no root of D lies between them.
    """
    total = np.zeros(xi.e.shape)
    inside = (circles.inner, circles.inner / circles.radius)
    outside = (circles.outer, circles.radius / circles.outer)
    upper = np.arange(wave.z.shape[1]) < wave.up
    signed, reach = xi.a.real, xi.size
    for radius, ratio in (inside, outside):
        to = np.abs(np.abs(circles.centre[:, :, None] - wave.z[:, None, :]) - radius[:, :, None]) * (1 - 16 * U)
        pull = wave.tight[:, None, :] / to * UP
        rest = [1 - np.where(side, pull, 0).sum(2) * UP for side in (upper, ~upper)]
        low = wave.low[:, None] * to.prod(2) * rest[0] * rest[1]
        bound = majorant(N, np.abs(circles.centre) + radius) / low * radius
        power = ratio**SAMPLES
        good = (rest[0] > 0) & (rest[1] > 0) & (low > TINY) & (ratio < _CLOSEST)
        share = np.where(good, bound * power / (1 - power), np.inf)[:, :, None]
        # e^{Re(Pξ)}, ξ = its middle and what it moves by
        turn = circles.centre.real[:, :, None] * signed[:, None, :] + radius[:, :, None] * reach[:, None, :]
        turn = turn + np.abs(circles.centre)[:, :, None] * xi.spread[:, None, :]
        total = total + np.where(circles.active[:, :, None], share * np.exp(turn), 0).sum(1)
    return total * (1 + 1e-6)


def majorant(polynomial: Quadratic, size: Any) -> Any:
    """Σ |c_i| size^i, a bound of the polynomial where |P| ≤ size; shape of `size`."""
    n = polynomial.k.shape[-1]
    return (size[:, :, None] ** np.arange(n) * polynomial.size[:, None, :]).sum(2)
