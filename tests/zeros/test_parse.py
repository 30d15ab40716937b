"""Texts and sympy's expressions have the values that mpmath gives them."""

from __future__ import annotations

from fractions import Fraction

import mpmath
import pytest
import sympy
from flint import acb

from mpsolve.errors import InputError
from mpsolve.zeros.evaluate import Evaluator
from mpsolve.zeros.parse import from_sympy, parse
from mpsolve.zeros.program import Program

POINT = complex(0.7, -0.4)


def value(text: str) -> complex:
    p = Program()
    k = parse(p, text)
    return complex(Evaluator(p.steps).run(acb(POINT), 1)[k])


@pytest.mark.parametrize(
    ("text", "truth"),
    [
        ("sin(z) - z/2", mpmath.sin(POINT) - POINT / 2),
        ("z^3 - 2*z**2 + 1", POINT**3 - 2 * POINT**2 + 1),
        ("-z**2", -(POINT**2)),
        ("e**z + pi*i", mpmath.exp(POINT) + mpmath.pi * 1j),
        ("2**z*z**(1/2)", 2**POINT * mpmath.sqrt(POINT)),
        ("bessel_j(2, z)", mpmath.besselj(2, POINT)),
        ("cos_sqrt(z) + sinc_sqrt(z)", mpmath.cos(mpmath.sqrt(POINT)) + mpmath.sinc(mpmath.sqrt(POINT))),
        ("3j*z + ln(z)", 3j * POINT + mpmath.log(POINT)),
    ],
)
def test_a_text_is_what_it_says(text: str, truth: complex) -> None:
    assert value(text) == pytest.approx(complex(truth), rel=1e-13)


def test_decimals_are_exact() -> None:
    p = Program()
    assert p.rational(parse(p, "0.1 + 1e-3")) == Fraction(101, 1000)


@pytest.mark.parametrize(
    "text",
    ["", "sin(z", "z +", "conj(z)", "abs(z)", "x + 1", "z if z else 1", "__import__('os')", "sin(z, z)", "z.real",
     "lambda: 1", "z[0]", "'a'", "sin()", "(" * 3000 + "z" + ")" * 3000, "z**z**9**9**9",
     "1e400000000*z", "bessel_j(z, z)"],
)  # fmt: skip
def test_what_is_no_expression_is_refused_in_a_sentence(text: str) -> None:
    with pytest.raises(InputError):
        parse(Program(), text)


def test_sympy_agrees_with_itself() -> None:
    z = sympy.Symbol("w")
    expression = sympy.tan(sympy.sqrt(2 * z)) + sympy.sqrt(z / (3 * sympy.pi**2 - z)) - sympy.I * sympy.Rational(1, 3)
    p = Program()
    k = from_sympy(p, expression)
    got = complex(Evaluator(p.steps).run(acb(POINT), 1)[k])
    assert got == pytest.approx(complex(expression.subs(z, POINT).evalf()), rel=1e-13)


def test_sympy_with_two_symbols_or_no_analytic_function_is_refused() -> None:
    x, y = sympy.symbols("x y")
    for expression in (x + y, sympy.conjugate(x), sympy.Abs(x), sympy.re(x)):
        with pytest.raises(InputError):
            from_sympy(Program(), expression)
