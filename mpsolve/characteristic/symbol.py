"""D and N of a moving track as polynomials in P whose coefficients are polynomials in σ, over any arithmetic."""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction
from functools import cached_property
from typing import Any

from mpsolve.frozen import frozen
from mpsolve.numbers.arithmetic import Arithmetic
from mpsolve.numbers.balls import acb_poly, bits_now, rational_ball
from mpsolve.problem.reduced import Guide
from mpsolve.tracks.waveguide import Polynomial, slope_in_s

Table = tuple[tuple[Fraction, ...], ...]
_KEPT = 16


@frozen
class Symbol:
    """A polynomial in P and σ: rows[i][j] is the exact coefficient of P^i σ^j."""

    rows: Table

    @staticmethod
    def of(polynomial: Polynomial) -> Symbol:
        top = max((i for i, _ in polynomial), default=0)
        rows = []
        for i in range(top + 1):
            width = max((j for k, j in polynomial if k == i), default=0)
            rows.append(tuple(polynomial.get((i, j), Fraction(0)) for j in range(width + 1)))
        return Symbol(tuple(rows))

    def at(self, K: Arithmetic, sigma: Any) -> list[Any]:
        """The coefficients of P^0, P^1, … at σ."""
        return [K.evaluate(row, sigma) for row in self.rows]

    def balls(self) -> list[Any]:
        """The rows as polynomials in σ with balls at the precision that is set."""
        bits = bits_now()
        if bits not in self._kept:
            if len(self._kept) >= _KEPT:
                self._kept.clear()
            self._kept[bits] = [acb_poly([rational_ball(c) for c in row]) for row in self.rows]
        return self._kept[bits]

    @cached_property
    def _kept(self) -> dict[int, list[Any]]:
        return {}


@frozen
class Symbols:
    """What the receptance of a moving track is made of: D, N and their slopes in σ."""

    D: Symbol
    N: Symbol
    D_sigma: Symbol
    N_sigma: Symbol

    @staticmethod
    def of(guide: Guide) -> Symbols:
        return Symbols(*map(Symbol.of, (guide.D, guide.N, slope_in_s(guide.D), slope_in_s(guide.N))))

    @cached_property
    def degree(self) -> int:
        """The number of p-roots."""
        return len(self.D.rows) - 1

    def at(self, K: Arithmetic, sigma: Any) -> Coefficients:
        """All four at one σ, or on an array of σ."""
        like = sigma * 0
        parts = (self.D, self.N, self.D_sigma, self.N_sigma)
        return Coefficients(*([like + c for c in x.at(K, sigma)] for x in parts))


@frozen
class Terms:
    """A simple p-root z gives G the term w e^{zξ}, and its slope in σ the term (a + bξ) e^{zξ}."""

    z: Any
    w: Any
    a: Any
    b: Any


@frozen
class Coefficients:
    """D, N, D_σ, N_σ as coefficients in P at one σ."""

    D: list[Any]
    N: list[Any]
    D_sigma: list[Any]
    N_sigma: list[Any]

    @cached_property
    def D_P(self) -> list[Any]:
        return slope_in_P(self.D)

    @cached_property
    def _further(self) -> tuple[list[Any], ...]:
        """D_PP, N_P, D_σP."""
        return slope_in_P(self.D_P), slope_in_P(self.N), slope_in_P(self.D_sigma)

    def newton(self, z: Any) -> Any:
        """Nearer to a simple root of D."""
        return z - horner(self.D, z) / horner(self.D_P, z)

    def drift(self, z: Any) -> Any:
        """dP/dσ at a simple root z of D."""
        return -horner(self.D_sigma, z) / horner(self.D_P, z)

    def weight(self, z: Any) -> Any:
        """The residue N/D_P at a simple root z of D."""
        return horner(self.N, z) / horner(self.D_P, z)

    def terms(self, z: Any) -> Terms:
        """Residue at a simple root z of D of N e^{Pξ}/D, and of its derivative in σ, a double pole."""
        D_PP, N_P, D_sP = (horner(x, z) for x in self._further)
        over, N, D_s = 1 / horner(self.D_P, z), horner(self.N, z), horner(self.D_sigma, z)
        lost = N * D_s * over * over
        turn = (N_P * D_s + N * D_sP) * over * over
        return Terms(z, N * over, horner(self.N_sigma, z) * over - turn + lost * D_PP * over, -lost)


def slope_in_P(coefficients: Sequence[Any]) -> list[Any]:
    """Coefficients of the derivative in P."""
    return [i * c for i, c in enumerate(coefficients)][1:]


def horner(coefficients: Sequence[Any], z: Any) -> Any:
    """Σ c_i z^i; 0 for an empty list."""
    if len(coefficients) < 2:
        return z * 0 + sum(coefficients)
    total = coefficients[-1]
    for c in coefficients[-2::-1]:
        total = total * z + c
    return total


def product(a: Sequence[Any], b: Sequence[Any]) -> list[Any]:
    """Coefficients of the product of two polynomials."""
    out: list[Any] = [0] * (len(a) + len(b) - 1)
    for i, x in enumerate(a):
        for j, y in enumerate(b):
            out[i + j] = out[i + j] + x * y
    return out
