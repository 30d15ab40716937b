"""mpmath numbers as an arithmetic: what formulas are compared with."""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction
from typing import Any

from mpsolve.numbers.multiprecision import context


class Multiprecision:
    """mpmath numbers with `digits` decimal digits; matrices are those of its context `mp`."""

    def __init__(self, digits: int) -> None:
        self.mp = context(digits)

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
