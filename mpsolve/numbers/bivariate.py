"""Rational polynomials in two variables as rows: the coefficients of 1, x, x², …, each a polynomial in y."""

from __future__ import annotations

from collections.abc import Sequence

from flint import fmpq, fmpq_mpoly, fmpq_mpoly_ctx, fmpq_poly

Rows = list[fmpq_poly]


def to_rows(f: fmpq_mpoly) -> Rows:
    """The rows of a polynomial in x and y, the last one not 0."""
    table: dict[int, dict[int, fmpq]] = {}
    for (i, j), c in f.to_dict().items():
        table.setdefault(int(i), {})[int(j)] = c
    listed = (table.get(i, {}) for i in range(max(table, default=-1) + 1))
    return [fmpq_poly([row.get(k, 0) for k in range(max(row, default=-1) + 1)]) for row in listed]


def from_rows(rows: Sequence[fmpq_poly], context: fmpq_mpoly_ctx) -> fmpq_mpoly:
    """The polynomial in the two variables of the context."""
    return context.from_dict({(i, j): c for i, row in enumerate(rows) for j, c in enumerate(row.coeffs()) if c})
