"""Exact steps: equal ones once, numbers folded, functions in disguise equal to flint's own."""

from __future__ import annotations

from fractions import Fraction

import pytest
from flint import acb
from functions import function

from mpsolve.errors import InputError
from mpsolve.zeros.evaluate import Evaluator
from mpsolve.zeros.program import Program, reduced, shown


def test_equal_steps_stand_once_and_numbers_are_folded() -> None:
    p = Program()
    a = p.mul(p.z, p.z)
    assert p.mul(p.z, p.z) == a
    assert p.rational(p.add(p.number(Fraction(1, 3)), p.number(Fraction(1, 6)))) == Fraction(1, 2)
    assert p.mul(p.number(1), a) == a
    assert p.rational(p.mul(p.number(0), a)) == 0


@pytest.mark.parametrize(
    "name",
    ["tan", "cot", "sec", "csc", "sinh", "cosh", "tanh", "coth", "gamma", "erfc", "expm1", "log1p", "asin", "acos",
     "atan", "asinh", "acosh", "atanh", "exp", "log", "sqrt", "sin", "cos", "rgamma", "erf", "airy_ai", "airy_bi"],
)  # fmt: skip
@pytest.mark.parametrize("z", [acb(0.3, 0.4), acb(-1.3, 0.7), acb(2.5, -1.5), acb(-0.2, -3)])
def test_functions_are_those_of_flint_on_every_quadrant(name: str, z: acb) -> None:
    p = Program()
    k = p.call(name, p.z)
    value = Evaluator(p.steps).run(z, 1)[k]
    assert value.overlaps(getattr(z, name)())
    assert float(value.rad()) < 1e-10


def test_powers_are_principal() -> None:
    p = Program()
    for exponent in (Fraction(3, 2), Fraction(-1, 2), Fraction(1, 3), Fraction(-2)):
        z = acb(-1.3, 0.7)
        k = p.power(p.z, p.number(exponent))
        assert Evaluator(p.steps).run(z, 1)[k].overlaps(z ** (acb(exponent.numerator) / exponent.denominator))


def test_what_cannot_be_is_refused() -> None:
    p = Program()
    with pytest.raises(InputError, match="not known"):
        p.call("conjugate", p.z)
    with pytest.raises(InputError, match="divided by zero"):
        p.div(p.z, p.number(0))
    with pytest.raises(InputError, match="up to"):
        p.whole(p.z, 10**6)
    with pytest.raises(InputError, match="base above 0"):
        p.power(p.number(-2), p.z)


def test_only_what_an_output_needs_is_kept() -> None:
    p = Program()
    p.call("sin", p.z)
    k = p.add(p.z, p.number(1))
    steps, (place,) = reduced(p.steps, [k])
    assert [step[0] for step in steps] == ["z", "number", "add"]
    assert shown(steps, place) == "z + 1"


@pytest.mark.parametrize("text", ["bessel_j(2, z)", "sin(z) - (z * (1/2))"])
def test_what_is_shown_can_be_read_again(text: str) -> None:
    once = str(function(text).expression)
    assert once == text
    assert str(function(once).expression) == once
