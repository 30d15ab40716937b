"""That the imaginary part of a root is convex in the parameter over a short interval: by Taylor series of its slope.

Over a disc of complex x̂ the root is the only one in a square (`branch.Model`), so q̂′ is analytic there and is
bounded. Its Taylor coefficients come from samples on a circle (`numbers.taylor`), each an enclosed root. That the
upper p-roots are those with Re P < 0 at the samples too, it is proved for the whole disc that holds them.
"""

from __future__ import annotations

from typing import Any

import numpy as np

from mpsolve.characteristic.boxes import Boxes
from mpsolve.characteristic.free_matrix import FreeMatrix
from mpsolve.characteristic.free_proved import FreeProved
from mpsolve.errors import PrecisionError
from mpsolve.numbers.balls import acb, arb, precision
from mpsolve.numbers.taylor import SAMPLES, Taylor, taylor
from mpsolve.proof import newton
from mpsolve.proof.vanishing import scalar
from mpsolve.ranges.branch import SIDE, Model
from mpsolve.ranges.curves import AtPoint

_SHARE = 0.34  # of a box: the square round the disc of complex x̂ lies in |u₁| < 1/2
_SHRINK = 1  # samples lie on the circle of half the radius
_COVERED = 0.3  # of the radius: half of the interval that a disc decides
_DISCS = (1, 3, 8, 20)
_WIDER = 1.7
_BITS = 96


def is_convex(matrix: FreeMatrix, proved: FreeProved, path: Any, low: float, high: float, first: complex) -> bool:
    """Whether Im q̂″ > 0 on [low, high], for the root that `path` (floats) follows; False where it is not proved.

    first: about its slope.
    """
    for discs in _DISCS:
        half = (high - low) / 2 / discs
        radius = half * (1 + 2.0**-20) / _COVERED
        middles = [low + (2 * k + 1) * half for k in range(discs)]
        try:
            if all(_bends(matrix, proved, complex(path(x)), x, radius, first) for x in middles):
                return True
        except PrecisionError:
            continue
    return False


def _bends(matrix: FreeMatrix, proved: FreeProved, q: complex, x: float, radius: float, first: complex) -> bool:
    """Of the interval round the middle of a disc."""
    r_x = radius / _SHARE
    r_q = _WIDER * (abs(first) * radius + abs(q.imag)) / SIDE
    A, G = matrix(Boxes(np.array([[q.real], [x]]), np.array([[r_q], [r_x]])))
    reduced = scalar(A, G.good)
    if not reduced.good[0] or not np.isfinite(reduced.s.e[0]):
        return False
    with precision(_BITS):
        model = Model.of(reduced.s, 0)
        side = arb(0, _SHARE)
        found = model.branch(acb(side, side))
        if found is None:
            return False
        slope = found[1] * arb(r_q) / arb(r_x)
        samples = _Samples(proved, arb(q.real), arb(r_q), arb(x), q, first)
        samples.require_sides(arb(q.real) + found[0] * arb(r_q), radius * 2.0**-_SHRINK)
        centre = samples(acb(x))
        bound = arb((slope - centre).abs_upper())
        series = taylor(lambda at: samples(at) - centre, acb(x), arb(radius), bound, _SHRINK)
        return bool(_derivative(series, arb(0, radius * _COVERED)).imag > 0)


class _Samples:
    """q̂′ at exact complex x̂."""

    def __init__(self, proved: FreeProved, q: Any, r_q: arb, x: arb, near: complex, first: complex) -> None:
        self._proved, self._q, self._r_q, self._x, self._near, self._first = proved, q, r_q, x, near, first

    def require_sides(self, q: Any, radius: float) -> None:
        """`PrecisionError` unless no p-root is imaginary for x̂ in the disc and q̂ in the ball."""
        ball = arb(0, radius)
        self._proved.matrices(acb(0, 1) * q, [self._x + acb(ball, ball)], slopes=False)

    def __call__(self, x: Any) -> Any:
        x = acb(x).mid()
        near = acb(self._near) + acb(self._first) * (x - self._x)
        f = AtPoint.near(self._proved, near.mid(), x)
        ball = newton.isolated(f, newton.polished(f, near.mid()), abs(near)).image
        u = (ball - self._q) / self._r_q
        if not (abs(u.real) < arb(SIDE) and abs(u.imag) < arb(SIDE)):
            raise PrecisionError("a root was lost next to a lowest point")
        return f.motion(ball)


def _derivative(series: Taylor, t: arb) -> acb:
    """Over a ball of real t round 0."""
    total = acb(0)
    for k in range(SAMPLES - 1, 0, -1):
        total = total * t + series.coefficients[k] * k
    ratio = arb(t.abs_upper()) / series.outer
    # Σ k r^(k−1) from k = n on is (n r^(n−1) (1 − r) + r^n)/(1 − r)²
    n = SAMPLES
    rest = series.bound / series.outer * (n * ratio ** (n - 1) * (1 - ratio) + ratio**n) / (1 - ratio) ** 2
    ball = arb(0, rest.upper())
    return total + acb(ball, ball)
