"""A sympy matrix in p and Omega as exact polynomials in P = ip and s = iΩ."""

from __future__ import annotations

from fractions import Fraction
from typing import Any

import sympy as sp

from mpsolve.errors import InputError
from mpsolve.tracks.waveguide import Matrix, Polynomial

_MOST = 8
"""The most fields of a track: determinants are expanded."""


def exact_matrix(given: Any) -> Matrix:
    """The matrix over P = ip and s = iΩ; InputError where an entry is no real polynomial in them."""
    try:
        matrix = sp.Matrix(given)
    except (TypeError, ValueError, sp.SympifyError):
        message = f"is of type {type(given).__name__}: give a sympy matrix, or rows, in the symbols p and Omega"
        raise InputError("matrix", message) from None
    if matrix.rows != matrix.cols or not 1 <= matrix.rows <= _MOST:
        stated = f"has {matrix.rows} rows and {matrix.cols} columns"
        raise InputError("matrix", f"{stated}: give a square one of 1 to {_MOST} fields")
    order = range(matrix.rows)
    return tuple(tuple(_entry(matrix[i, j], f"matrix[{i + 1}][{j + 1}]") for j in order) for i in order)


def _entry(expression: Any, key: str) -> Polynomial:
    P, s = sp.symbols("P s")
    names = {str(symbol): symbol for symbol in expression.free_symbols}
    unknown = sorted(names.keys() - {"p", "Omega"})
    if unknown:
        raise InputError(key, f"holds the symbol {unknown[0]}: put in its number, only p and Omega may be left")
    values = {name: value for name, value in (("p", -sp.I * P), ("Omega", -sp.I * s)) if name in names}
    put_in = expression.subs({names[name]: value for name, value in values.items()}, simultaneous=True)
    try:
        terms = sp.Poly(sp.expand(put_in), P, s).terms()
    except sp.PolynomialError:
        raise InputError(key, f"is {expression}, no polynomial in p and Omega: multiply its row out") from None
    return {(int(i), int(j)): c for (i, j), value in terms if (c := _rational(value, key))}


def _rational(value: Any, key: str) -> Fraction:
    """The exact coefficient; a decimal stands for what is printed of it."""
    if value.has(sp.Float):
        value = sp.expand(value.xreplace({x: sp.Rational(str(x)) for x in value.atoms(sp.Float)}))
    if not value.is_Rational:
        complex_ = bool(value.has(sp.I))
        stated = "is not real in ∂/∂x = ip and ∂/∂t = iΩ" if complex_ else "is irrational"
        what = "let p and Omega come with i, as derivatives do" if complex_ else "give a ratio such as Rational(1, 3)"
        raise InputError(key, f"has the coefficient {value}, which {stated}: {what}")
    return Fraction(int(value.p), int(value.q))
