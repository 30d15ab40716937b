"""mpmath numbers of any number of digits, in a context of their own: mpmath's global one is never used."""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction
from typing import Any


class Multiprecision:
    """mpmath numbers with `digits` decimal digits; matrices are those of its context `mp`."""

    def __init__(self, digits: int) -> None:
        import mpmath  # not at the top: proofs do without it, and it costs as much at start as all of them

        self.mp = mpmath.MPContext()
        self.mp.dps = digits

    def number(self, x: Fraction) -> Any:
        return self.mp.mpf(x.numerator) / x.denominator

    def evaluate(self, coefficients: Sequence[Fraction], z: Any) -> Any:
        total = self.mp.mpc(0)
        for c in reversed(coefficients):
            total = total * z + self.number(c)
        return total

    def matrix(self, rows: Sequence[Sequence[Any]]) -> Any:
        return self.mp.matrix([list(row) for row in rows]) if len(rows) else self.mp.matrix(0, 0)

    def times(self, a: Any, factor: Any) -> Any:
        return a * factor

    def product(self, a: Any, b: Any) -> Any:
        return a * b

    def exp(self, a: Any) -> Any:
        return self.mp.expm(a)

    def solve(self, a: Any, b: Any) -> Any:
        return self.mp.inverse(a) * b

    def entry(self, a: Any, i: int, j: int) -> Any:
        return a[i, j]

    def det(self, a: Any) -> Any:
        return self.mp.det(a)

    def roots(self, coefficients: Sequence[Any]) -> list[Any]:
        """The roots of a polynomial, coefficients from the constant term up."""
        return list(self.mp.polyroots(list(coefficients)[::-1], maxsteps=500, extraprec=3 * self.mp.prec))


class Rule:
    """n Gauss–Legendre nodes and weights in the context mp, and the polynomials there."""

    def __init__(self, mp: Any, n: int) -> None:
        self.mp, self.n = mp, n
        from numpy.polynomial.legendre import leggauss

        pairs = [self._node(x) for x in leggauss(n)[0]]
        self.nodes = [x for x, _ in pairs]
        self.weights = [w for _, w in pairs]
        rows = [self._polynomials(x) for x in self.nodes]
        self._to_series = [
            [(k + mp.mpf(1) / 2) * w * row[k] for w, row in zip(self.weights, rows, strict=True)] for k in range(n)
        ]

    def _polynomials(self, x: Any) -> list[Any]:
        """P_0 … P_n at x."""
        out = [self.mp.mpf(1), x]
        for k in range(1, self.n):
            out.append(((2 * k + 1) * x * out[k] - k * out[k - 1]) / (k + 1))
        return out[: self.n + 1]

    def _node(self, guess: float) -> tuple[Any, Any]:
        x, slope = self.mp.mpf(guess), self.mp.mpf(1)
        for _ in range(3 + int(self.mp.prec).bit_length()):
            P = self._polynomials(x)
            slope = self.n * (P[self.n - 1] - x * P[self.n]) / (1 - x * x)
            step = P[self.n] / slope
            x -= step
            if abs(step) < self.mp.mpf(2) ** (-self.mp.prec // 2 - 8):  # Newton's next error is its square
                break
        P = self._polynomials(x)
        slope = self.n * (P[self.n - 1] - x * P[self.n]) / (1 - x * x)
        return x, 2 / ((1 - x * x) * slope * slope)

    def series(self, values: Sequence[Any]) -> list[Any]:
        """Legendre coefficients of the polynomial through values at the nodes."""
        return [self.mp.fdot(row, values) for row in self._to_series]

    def moments(self, z: Any) -> list[Any]:
        """∫ P_k e^{izx} dx = 2 i^k j_k(z) for k < n, z ≥ 0: upward where z is large, else downward from far."""
        mp, n = self.mp, self.n
        if not z:
            return [mp.mpf(2)] + [mp.mpf(0)] * (n - 1)
        j = [mp.sin(z) / z, mp.sin(z) / z**2 - mp.cos(z) / z]
        if z > n:
            for k in range(1, n):
                j.append((2 * k + 1) / z * j[k] - j[k - 1])
        else:
            last = n + int(z) + 2 * mp.dps + 10
            down = [mp.mpf(0), mp.mpf(10) ** (-mp.dps)]
            for k in range(last, 0, -1):
                down.append((2 * k + 1) / z * down[-1] - down[-2])
            down.reverse()  # j_0, j_1, … up to a factor
            k = 0 if abs(j[0]) > abs(j[1]) else 1
            j = [x * (j[k] / down[k]) for x in down[:n]]
        return [2 * mp.mpc(0, 1) ** k * x for k, x in enumerate(j[:n])]
