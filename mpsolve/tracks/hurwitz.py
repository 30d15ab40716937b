"""Hurwitz's determinants of a polynomial in s: all roots have Re s < 0 exactly where they are positive."""

from __future__ import annotations

from typing import Any

from mpsolve.numbers.bivariate import Rows
from mpsolve.numbers.realroots import is_positive


def is_stable(D: Rows) -> bool:
    """Whether for every real p all roots s have Re s < 0, the leading coefficient being positive."""
    return all(is_positive(minor) for minor in hurwitz_minors(D))


def _hurwitz(coefficients: list[Any]) -> list[list[Any]]:
    """The Hurwitz matrix of Σ c_j s^j; its leading minors are the Hurwitz determinants."""
    n = len(coefficients) - 1
    zero = 0 * coefficients[0]
    index = [[n - (2 * (k + 1) - (i + 1)) for k in range(n)] for i in range(n)]
    return [[coefficients[j] if 0 <= j <= n else zero for j in row] for row in index]


def hurwitz_minors(coefficients: list[Any]) -> list[Any]:
    """The Hurwitz determinants in ascending order, by elimination without fractions; it ends with one that is 0.

    The coefficients of s⁰, s¹, … may be polynomials in one variable or several.
    """
    a, last, out = _hurwitz(coefficients), None, []
    for k in range(len(a)):
        out.append(a[k][k])
        if not a[k][k]:
            break
        for i in range(k + 1, len(a)):
            for j in range(k + 1, len(a)):
                value = a[i][j] * a[k][k] - a[i][k] * a[k][j]
                a[i][j] = value if last is None else value // last
        last = a[k][k]
    return out
