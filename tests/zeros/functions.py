"""Functions for the tests of zeros, from a text."""

from __future__ import annotations

from mpsolve.zeros.fraction import as_fraction
from mpsolve.zeros.function import ExpressionFunction
from mpsolve.zeros.parse import parse
from mpsolve.zeros.program import Program


def function(text: str) -> ExpressionFunction:
    """The numerator of an expression."""
    program = Program()
    expression = as_fraction(program, parse(program, text))
    return ExpressionFunction(expression, expression.numerator)
