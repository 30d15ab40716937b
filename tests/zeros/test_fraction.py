"""One fraction: the same values, no division left outside of functions, shared denominators once."""

from __future__ import annotations

import pytest
from flint import acb

from mpsolve.zeros.evaluate import Evaluator
from mpsolve.zeros.fraction import as_fraction, factors, guards
from mpsolve.zeros.parse import parse
from mpsolve.zeros.program import Program, reduced, shown


@pytest.mark.parametrize(
    "text",
    ["tan(z) - z", "1/(z - 1) + 1/(z - 1)**2", "(z + 1/z)**3/(1 + 1/z)", "gamma(z) - 2/z", "sin(1/z)/z", "z/pi + 1/3",
     "1/(1/(1/z))", "coth(z)*tanh(z) + z"],
)  # fmt: skip
def test_values_are_kept_and_nothing_is_divided(text: str) -> None:
    p = Program()
    k = parse(p, text)
    z = acb(0.7, -0.4)
    truth = Evaluator(p.steps).run(z, 1)[k]
    e = as_fraction(p, k)
    values = Evaluator(e.steps).run(z, 1)
    found = values[e.numerator] / (values[e.denominator] if e.denominator is not None else 1)
    assert found.overlaps(truth)
    assert float(found.rad()) < 1e-12
    steps, _ = reduced(e.steps, [e.numerator])
    assert [steps[g][0] for g in guards(steps)] == (["div"] if "sin(1/z)" in text else [])


def test_denominators_that_are_equal_are_shared() -> None:
    p = Program()
    e = as_fraction(p, parse(p, "1/(z - 1) + 1/(z - 1)**2"))
    assert e.denominator is not None
    assert shown(e.steps, e.denominator) == "z - 1**2" or "(z - 1)**2" in shown(e.steps, e.denominator)
    assert shown(e.steps, e.numerator) == "(z - 1) + 1"


def test_factors_are_those_of_the_outer_steps() -> None:
    p = Program()
    k = parse(p, "-3*(z - 1)**3*sin(z)*(z - 1)/pi*exp(1)")
    found = {shown(p.steps, place): power for place, power in factors(p.steps, k).items()}
    assert found == {"z - 1": 4, "sin(z)": 1}


def test_a_product_of_a_thousand_factors_is_no_recursion() -> None:
    p = Program()
    k = parse(p, "z")
    for j in range(1500):
        k = p.mul(k, p.sub(p.z, p.number(j)))
    assert len(factors(p.steps, k)) == 1500  # z − 0 is z, and so twice
    assert sum(factors(p.steps, k).values()) == 1501


@pytest.mark.parametrize(
    ("text", "names"),
    [
        ("sin(z)*exp(z**2) + rgamma(z)/pi + sqrt(2)", []),
        ("sqrt(z) + log(z + 1)", ["sqrt", "log"]),
        ("1/z + atan(z)", ["div", "atan"]),
        ("z/sqrt(2) + log(3)*z", []),
        ("bessel_j(3, z) + cos_sqrt(z)", []),
    ],
)
def test_roots_logarithms_and_quotients_of_z_are_watched(text: str, names: list[str]) -> None:
    program = Program()
    parse(program, text)
    assert [program.steps[k][0] for k in guards(program.steps)] == names
