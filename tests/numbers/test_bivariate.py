"""Polynomials in two variables and their rows, against one whose rows are written down."""

from __future__ import annotations

from flint import fmpq, fmpq_mpoly_ctx, fmpq_poly

from mpsolve.numbers.bivariate import from_rows, to_rows


def test_rows_are_the_coefficients_of_the_first_variable() -> None:
    context = fmpq_mpoly_ctx.get(("x", "y"), "lex")
    x, y = context.gens()
    f = 3 * x**2 * y + x**2 - fmpq(1, 2) * y**3
    rows = [fmpq_poly([0, 0, 0, fmpq(-1, 2)]), fmpq_poly([]), fmpq_poly([1, 3])]
    assert to_rows(f) == rows
    assert from_rows(rows, context) == f
    assert to_rows(context.constant(0)) == []
