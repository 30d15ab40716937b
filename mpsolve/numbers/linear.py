"""Exact linear algebra by elimination: kernels, bases and solutions of matrices of rationals, as lists of rows."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from fractions import Fraction
from typing import Any

Vector = list[Fraction]
Echelon = dict[int, Vector]
"""Independent rows by their leading column, where each has 1 and the others 0."""


def taken(row: Iterable[Fraction], echelon: Echelon) -> bool:
    """Whether the row is independent of the echelon; then it joins it."""
    rest = list(row)
    for lead, known in echelon.items():
        if rest[lead]:
            rest = _less(rest, rest[lead], known)
    first = next((i for i, x in enumerate(rest) if x), None)
    if first is None:
        return False
    rest = [x / rest[first] for x in rest]
    for lead, known in echelon.items():
        if known[first]:
            echelon[lead] = _less(known, known[first], rest)
    echelon[first] = rest
    return True


def _less(a: Vector, factor: Fraction, b: Vector) -> Vector:
    return [x - factor * y for x, y in zip(a, b, strict=True)]


def kernel(rows: Iterable[Iterable[Fraction]], width: int) -> list[Vector]:
    """A basis of the common kernel of rows of that width."""
    echelon: Echelon = {}
    for row in rows:
        taken(row, echelon)
    out = []
    for free in (i for i in range(width) if i not in echelon):
        vector = [-echelon[i][free] if i in echelon else Fraction(0) for i in range(width)]
        vector[free] = Fraction(1)
        out.append(vector)
    return out


def completed(first: list[Vector], space: list[Vector]) -> list[Vector]:
    """Vectors of `space` that, with `first`, are a basis of their span."""
    echelon: Echelon = {}
    return [vector for vector in [*first, *space] if taken(vector, echelon)][len(first) :]


def solved(rows: Iterable[Iterable[Fraction]], right: Iterable[Fraction]) -> Vector:
    """The solution of a regular system."""
    echelon: Echelon = {}
    for row, x in zip(rows, right, strict=True):
        taken([*row, x], echelon)
    return [echelon[k][-1] for k in range(len(echelon))]


def units(n: int) -> list[Vector]:
    return [[Fraction(int(i == k)) for i in range(n)] for k in range(n)]


def dot(a: Iterable[Any], b: Iterable[Fraction]) -> Fraction:
    """Σ a_i b_i of numbers, or of polynomials in free parameters."""
    return sum((x * y for x, y in zip(a, b, strict=True) if x and y), Fraction(0))


def image(rows: Iterable[Sequence[Any]], vector: Sequence[Any]) -> list[Any]:
    """A matrix times a vector."""
    return [dot(row, vector) for row in rows]


def congruent(rows: Any, left: Sequence[Sequence[Fraction]], right: Sequence[Sequence[Fraction]]) -> list[list[Any]]:
    """aᵀ A b for each a in `left` and b in `right`."""
    images = [image(rows, vector) for vector in right]
    return [[dot(a, one) for one in images] for a in left]
