"""Δ̃ by residue sums in mpmath, at any number of digits; roots by the secant method."""

from __future__ import annotations

from fractions import Fraction
from typing import Any

import mpmath
import numpy as np

from oracle_general.floats import Floats
from oracle_general.tracks import moving, track
from oracle_general.vehicles import together


class Precise:
    """The functions of one problem at `digits` decimal digits."""

    def __init__(self, problem: dict[str, Any], digits: int = 40) -> None:
        self.problem, self.mp = problem, mpmath.MPContext()
        self.mp.dps = digits
        D, N = track(problem["track"])
        v = Fraction(problem["v"])
        self.D, self.N = moving(D, v), moving(N, v)
        parts = together(problem["vehicles"])
        self.M, self.C, self.K, self.B = ([[self._number(x) for x in row] for row in rows]
                                          for rows in (parts.M, parts.C, parts.K, parts.B))  # fmt: skip
        self.x, self.h = [self._number(x) for x in parts.x], [self._number(h) for h in parts.h]
        self.upper = Floats(problem).upper

    def _number(self, x: Fraction) -> Any:
        return self.mp.mpf(x.numerator) / x.denominator

    def _coefficients(self, table: dict[tuple[int, int], Fraction], q: Any) -> list[Any]:
        """Highest power of p first."""
        out = [self.mp.mpc(0)] * (max(k for k, _ in table) + 1)
        for (k, j), value in table.items():
            out[k] += self._number(value) * self.mp.j ** (k + j) * q**j
        return out[::-1]

    def p_roots(self, q: Any) -> list[Any]:
        D = self._coefficients(self.D, q)
        start = [self.mp.mpc(complex(p)) for p in np.roots([complex(c) for c in D])]
        p = self.mp.polyroots(D, maxsteps=500, extraprec=2 * self.mp.prec + 50, roots_init=start)
        return sorted(p, key=lambda z: -z.imag)

    def kernels(self, q: Any) -> list[list[Any]]:
        """G(x_i − x_j, q)."""
        mp = self.mp
        D, N, p = self._coefficients(self.D, q), self._coefficients(self.N, q), self.p_roots(q)
        weights = [mp.polyval(N, z) / mp.polyval(D, z, derivative=True)[1] for z in p]
        pairs = list(zip(weights, p, strict=True))

        def kernel(xi: Any) -> Any:
            side, sign = (pairs[: self.upper], mp.j) if xi >= 0 else (pairs[self.upper :], -mp.j)
            return sign * mp.fsum(w * mp.expj(z * xi) for w, z in side)

        return [[kernel(a - b) for b in self.x] for a in self.x]

    def matrix(self, q: Any) -> Any:
        """The bordered matrix of Δ̃."""
        mp, n, c = self.mp, len(self.M), len(self.x)
        A, G = mp.matrix(n + c), self.kernels(q)
        for i in range(n):
            for j in range(n):
                A[i, j] = self.K[i][j] + mp.j * q * self.C[i][j] - q * q * self.M[i][j]
            for j in range(c):
                A[i, n + j], A[n + j, i] = -self.B[i][j], self.B[i][j]
        for i in range(c):
            for j in range(c):
                A[n + i, n + j] = G[i][j] + (self.h[i] if i == j else 0)
        return A

    def delta(self, q: Any) -> Any:
        return self.mp.det(self.matrix(self.mp.mpmathify(q)))

    def root(self, start: complex) -> Any:
        """The root of Δ̃ that the secant method finds from `start`."""
        mp = self.mp
        a = mp.mpc(start)
        b = a * (1 + mp.mpf(10) ** -7) + (mp.mpf(10) ** -12 if a == 0 else 0)
        fa, fb = self.delta(a), self.delta(b)
        for _ in range(60):
            if fb == fa:
                break
            a, fa, b = b, fb, b - fb * (b - a) / (fb - fa)
            if abs(b - a) < abs(b) * mp.mpf(10) ** (8 - mp.dps):
                break
            fb = self.delta(b)
        else:
            raise ArithmeticError(f"the secant method does not settle from {start}")
        return b
