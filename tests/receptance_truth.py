"""Splittings and receptances of scaled tracks at any precision: the p-roots by mpmath, residues, nothing else."""

from __future__ import annotations

from fractions import Fraction
from typing import Any

import mpmath
import numpy as np

from mpsolve.problem.reduced import Guide
from mpsolve.tracks.waveguide import Polynomial


class Receptance:
    """D̂, N̂ of a guide at `digits` digits; roots with Re P < 0 (at Re σ > 0) are those of U."""

    def __init__(self, guide: Guide, digits: int = 45) -> None:
        self.mp = mpmath.MPContext()
        self.mp.dps = digits
        self.D, self.N, self.degree = guide.D, guide.N, guide.degree
        self._last: Any = None  # σ with the p-roots of both sides and their weights

    def in_P(self, polynomial: Polynomial, sigma: Any) -> list[Any]:
        """Coefficients in P, the highest first."""
        out = [self.mp.mpc(0)] * (max(i for i, _ in polynomial) + 1)
        for (i, j), c in polynomial.items():
            out[-1 - i] += self.number(c) * self.mp.mpc(sigma) ** j
        return out

    def number(self, x: Fraction) -> Any:
        return self.mp.mpf(x.numerator) / x.denominator

    def roots(self, sigma: Any) -> tuple[list[Any], list[Any]]:
        """(those with Re P < 0, the others)."""
        D = self.in_P(self.D, sigma)
        start = [self.mp.mpc(z) for z in np.roots([complex(c) for c in D])]
        found = self.mp.polyroots(D, maxsteps=800, extraprec=2 * self.mp.prec, roots_init=start)
        return [p for p in found if p.real < 0], [p for p in found if p.real > 0]

    def value(self, xi: Any, sigma: Any) -> Any:
        """G(ξ, σ)."""
        if self._last is None or self._last[0] != sigma:
            D, N = self.in_P(self.D, sigma), self.in_P(self.N, sigma)
            sides = [[(P, self._residue(N, D, P)) for P in side] for side in self.roots(sigma)]
            self._last = (sigma, *sides)
        poles, sign = (self._last[1], 1) if xi >= 0 else (self._last[2], -1)
        x = self.number(Fraction(xi))
        return sign * sum((weight * self.mp.exp(P * x) for P, weight in poles), self.mp.mpc(0))

    def _residue(self, N: list[Any], D: list[Any], P: Any) -> Any:
        return self.mp.polyval(N, P) / self.mp.polyval(D, P, derivative=1)[1]

    def rim(self, m: complex, r: float, count: int) -> list[Any]:
        """σ on the rim of a disc."""
        return [self.mp.mpc(m) + self.mp.mpf(r) * self.mp.expj(2 * self.mp.pi * k / count) for k in range(count)]
