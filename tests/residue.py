"""Truths about moving tracks in mpmath: residue sums at the p-roots, and tracks made at random."""

from __future__ import annotations

import random
from fractions import Fraction
from typing import Any

import mpmath
from track_models import DAMPED

from mpsolve.problem.reduced import Guide
from mpsolve.tracks import EulerBernoulli
from mpsolve.tracks.waveguide import Polynomial, Waveguide

TRACKS = DAMPED | {
    "winkler": EulerBernoulli(EI="1/4", m=1, k=1, c="0.1", kp="0.2", N="0.1"),
    "kelvin-voigt": EulerBernoulli(EI="6.4e6", m=60, k="1e6", c=770, eta="1e-4"),
}


def random_track(size: int, seed: int) -> Waveguide:
    """K₀ + C s + M s² − K₂P² + K₄P⁴ with positive definite K₀, C, M, K₂ and K₄ ≥ 0 of rank one: passive, damped."""
    draw = random.Random(seed)

    def definite() -> list[list[Fraction]]:
        rows = [[Fraction(draw.randint(-9, 9), 10) for _ in range(size)] for _ in range(size)]
        return [
            [sum(a * b for a, b in zip(x, y, strict=True)) + Fraction(i == j, 2) for j, y in enumerate(rows)]
            for i, x in enumerate(rows)
        ]

    K0, C, M, K2 = (definite() for _ in range(4))
    arm = [Fraction(draw.randint(1, 9), 10) for _ in range(size)]
    matrix = tuple(
        tuple(
            {(0, 0): K0[i][j], (0, 1): C[i][j], (0, 2): M[i][j], (2, 0): -K2[i][j], (4, 0): arm[i] * arm[j]}
            for j in range(size)
        )
        for i in range(size)
    )
    clean = tuple(tuple({k: c for k, c in entry.items() if c} for entry in row) for row in matrix)
    return Waveguide(clean, draw.randrange(size))


class Residues:
    """Ĝ of a scaled moving track from its p-roots, at `digits` digits; upper ones are told by the sign of Re P."""

    def __init__(self, guide: Guide, digits: int) -> None:
        self.mp = mpmath.MPContext()
        self.mp.dps = digits
        self.D, self.N = guide.D, guide.N
        self._known: dict[Any, list[Any]] = {}

    def coefficients(self, polynomial: Polynomial, sigma: Any) -> list[Any]:
        """Of P^0, P^1, …"""
        out = [self.mp.mpc(0)] * (max(i for i, _ in polynomial) + 1)
        for (i, j), c in polynomial.items():
            out[i] += self.mp.mpf(c.numerator) / c.denominator * self.mp.mpmathify(sigma) ** j
        return out

    def roots(self, sigma: Any) -> list[Any]:
        if sigma not in self._known:
            D = self.coefficients(self.D, sigma)[::-1]
            self._known[sigma] = list(self.mp.polyroots(D, maxsteps=500, extraprec=3 * self.mp.prec))
        return self._known[sigma]

    def __call__(self, xi: Any, sigma: Any) -> Any:
        """G(ξ, σ) for Re σ > 0 in this part of the plane."""
        D, N = self.coefficients(self.D, sigma), self.coefficients(self.N, sigma)
        slope = [i * c for i, c in enumerate(D)][1:]
        xi = self.mp.mpf(xi.numerator) / xi.denominator if isinstance(xi, Fraction) else self.mp.mpf(xi)
        total = self.mp.mpc(0)
        for z in self.roots(sigma):
            ahead = z.real < 0
            if ahead is bool(xi >= 0):
                weight = self.mp.polyval(N[::-1], z) / self.mp.polyval(slope[::-1], z)
                total += (1 if ahead else -1) * weight * self.mp.exp(z * xi)
        return total

    def slope(self, xi: Any, sigma: Any) -> Any:
        """dG/dσ by a central difference at four times the digits that it is worth."""
        h = self.mp.mpf(10) ** (-self.mp.dps // 4)
        sigma = self.mp.mpmathify(sigma)
        return (self(xi, sigma + h) - self(xi, sigma - h)) / (2 * h)


def holds(ball: Any, value: Any) -> bool:
    """Whether a flint ball holds an mpmath number, which is exact to far below the ball's radius."""
    import flint

    from mpsolve.numbers.balls import precision

    with precision(4000):
        return bool(ball.contains(flint.acb(_exact(value.real), _exact(value.imag))))


def _exact(x: Any) -> Any:
    import flint

    sign, mantissa, exponent, _ = x._mpf_
    return flint.arb((int(-mantissa if sign else mantissa), int(exponent)))
