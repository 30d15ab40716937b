"""mpmath numbers of any number of digits, in contexts of their own: mpmath's global one is never used."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from mpsolve.numbers.balls import arb, precision

_SPARE = 16  # bits


def context(digits: int) -> Any:
    """mpmath with so many decimal digits."""
    import mpmath  # not at the top: proofs do without it, and it costs as much at start as all of them

    own = mpmath.MPContext()
    own.dps = digits
    return own


def middle(mp: Any, ball: Any) -> Any:
    """The middle of a real ball as a number of the context, exactly."""
    from mpmath.libmp import from_man_exp

    return mp.make_mpf(from_man_exp(*map(int, ball.mid().man_exp())))


class Rule:
    """n Gauss–Legendre nodes and weights in the context mp, and the polynomials there."""

    def __init__(self, mp: Any, n: int) -> None:
        self.mp, self.n = mp, n
        with precision(mp.prec + _SPARE):
            pairs = [arb.legendre_p_root(n, k, weight=True) for k in range(n)]
        self.nodes, self.weights = ([middle(mp, ball) for ball in balls] for balls in zip(*pairs, strict=True))
        rows = [self._polynomials(x) for x in self.nodes]
        self._to_series = [
            [(k + mp.mpf(1) / 2) * w * row[k] for w, row in zip(self.weights, rows, strict=True)] for k in range(n)
        ]

    def _polynomials(self, x: Any) -> list[Any]:
        """P_0 … P_{n − 1} at x."""
        out = [self.mp.mpf(1), x]
        for k in range(1, self.n - 1):
            out.append(((2 * k + 1) * x * out[k] - k * out[k - 1]) / (k + 1))
        return out

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
