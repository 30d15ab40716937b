"""Kernels and bases of exact matrices, by elimination of rationals."""

from __future__ import annotations

from fractions import Fraction
from typing import Any


def kernel(rows: Any) -> list[list[Fraction]]:
    """A basis of the kernel."""
    width = len(rows[0])
    echelon: dict[int, list[Fraction]] = {}
    for row in rows:
        _taken(row, echelon)
    out = []
    for free in (i for i in range(width) if i not in echelon):
        vector = [-echelon[i][free] if i in echelon else Fraction(0) for i in range(width)]
        vector[free] = Fraction(1)
        out.append(vector)
    return out


def _taken(row: Any, echelon: dict[int, list[Fraction]]) -> bool:
    """Whether the row is independent of those in reduced echelon form; then it joins them."""
    rest = list(row)
    for lead, known in echelon.items():
        if rest[lead]:
            factor = rest[lead]
            rest = [a - factor * b for a, b in zip(rest, known, strict=True)]
    first = next((i for i, x in enumerate(rest) if x), None)
    if first is None:
        return False
    rest = [x / rest[first] for x in rest]
    for other, known in echelon.items():
        if known[first]:
            echelon[other] = [a - known[first] * b for a, b in zip(known, rest, strict=True)]
    echelon[first] = rest
    return True


def completed(first: list[list[Fraction]], space: list[list[Fraction]]) -> list[list[Fraction]]:
    """Vectors of `space` that, with `first`, are a basis of their span."""
    echelon: dict[int, list[Fraction]] = {}
    return [vector for vector in [*first, *space] if _taken(vector, echelon)][len(first) :]
