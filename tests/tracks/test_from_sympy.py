"""What is read of a sympy matrix is exact; what cannot be read is named by its place."""

from __future__ import annotations

from fractions import Fraction

import pytest
import sympy as sp

from mpsolve.errors import InputError
from mpsolve.tracks.from_sympy import exact_matrix

p, Omega = sp.symbols("p Omega")


def test_derivatives_come_with_i() -> None:
    """∂/∂x = ip and ∂/∂t = iΩ: p⁴ is P⁴, −Ω² is s², iΩ is s, i p is P."""
    matrix = exact_matrix([[p**4 / 3 - 2 * Omega**2, sp.I * p], [-sp.I * p, sp.I * Omega + 0.1]])
    assert matrix == (
        ({(4, 0): Fraction(1, 3), (0, 2): Fraction(2)}, {(1, 0): Fraction(1)}),
        ({(1, 0): Fraction(-1)}, {(0, 1): Fraction(1), (0, 0): Fraction(1, 10)}),
    )


@pytest.mark.parametrize(
    ("entry", "said"),
    [
        (sp.Symbol("k") + p, "symbol k"),
        (1 / (1 + p), "polynomial"),
        (sp.sqrt(2) * p**2, "irrational"),
        (p, "not real"),
    ],
)
def test_what_cannot_be_read_is_named(entry: sp.Expr, said: str) -> None:
    with pytest.raises(InputError, match=said) as caught:
        exact_matrix([[1, 0], [0, entry]])
    assert caught.value.key == "matrix[2][2]"


@pytest.mark.parametrize("given", [[[1, 2]], "rail", 3])
def test_what_is_no_square_matrix_is_refused(given: object) -> None:
    with pytest.raises(InputError, match="matrix"):
        exact_matrix(given)
