"""What may be a function: read, vouched for, or refused in a sentence; nothing that is not analytic comes through."""

from __future__ import annotations

from typing import Any

import pytest
import sympy
from flint import acb, arb

from mpsolve.errors import InputError
from mpsolve.zeros.read import DERIVED, FLAGGED, VOUCHED, read_function


@pytest.mark.parametrize(
    "f",
    ["sin(z) - z/2", lambda z: z.sin() - z / 2, sympy.sin(sympy.Symbol("x")) - sympy.Symbol("x") / 2,
     ("z*sin(z) - z**2/2", "z"), (lambda z: z.sin() - z / 2, "1")],
)  # fmt: skip
def test_every_form_is_an_expression(f: Any) -> None:
    given = read_function(f, None, False)
    assert given.expression is not None
    assert given.assumed == ()
    z = acb(0.7, 0.3)
    value = given.function.value(z) / (given.denominator.value(z) if given.denominator is not None else 1)
    assert value.overlaps(z.sin() - z / 2)


def test_a_function_of_balls_must_be_vouched_for_or_take_the_flag() -> None:
    with pytest.raises(InputError, match="assume_analytic"):
        read_function(lambda z: acb(z).sin(), None, False)
    assert read_function(lambda z: acb(z).sin(), None, True).assumed == (VOUCHED,)
    assert read_function(lambda z, analytic: z.sqrt(analytic=analytic), None, False).assumed == (FLAGGED,)


@pytest.mark.parametrize(
    "f",
    [
        lambda z: acb(z).conjugate(),
        lambda z: acb(abs(acb(z))),
        lambda z: acb(z) + acb(z).real,
        lambda z: acb(z) * acb(z).conjugate() - 1,
        lambda z: acb(acb(z).imag),
    ],
)
def test_what_is_plainly_not_analytic_is_refused_even_where_it_is_vouched_for(f: Any) -> None:
    with pytest.raises(InputError, match="not analytic"):
        read_function(f, None, True)


def test_a_derivative_rests_on_the_users_word_and_another_slope_is_refused() -> None:
    def square(z: Any) -> Any:
        return acb(z) ** 2 if isinstance(z, acb) else 1 / 0

    assert read_function(square, lambda z: 2 * z, True).assumed == (VOUCHED, DERIVED)
    for other in (lambda _: acb(1), lambda z: 2 * z + acb("0.01"), lambda z: z):
        with pytest.raises(InputError, match="derivative: is not f′"):
            read_function(square, other, True)


def test_a_function_that_does_something_else_to_a_symbol_is_refused() -> None:
    with pytest.raises(InputError, match="another value"):
        read_function(lambda z: z.sin() if isinstance(z, acb) else z, None, False)


@pytest.mark.parametrize(
    "f",
    [
        "z*sin(0)",
        "tan(0)*z/(z + 1)",
        "(sin(pi) + 0*z)*exp(z)",
        "z/(sin(pi)*(z + 2))",
        "z/sin(pi)",
        "z/(2 - sqrt(2)**2)",
    ],
)
def test_a_constant_factor_that_may_be_0_is_refused(f: str) -> None:
    with pytest.raises(InputError, match="f: "):
        read_function(f, None, False)


def test_a_small_constant_factor_is_not_taken_for_0() -> None:
    assert read_function("z*(exp(1/10**40) - 1)/(cos(1/10**40) - 1)", None, False).denominator is None


@pytest.mark.parametrize("f", [3, None, "3", "pi", (1, 2, 3), lambda _: 5, "1/z", [], lambda: 0])
def test_what_is_no_function_is_refused(f: Any) -> None:
    with pytest.raises(InputError):
        read_function(f, None, False)


def test_a_ball_that_is_no_constant_is_not_read() -> None:
    with pytest.raises(InputError, match="not exact"):
        read_function(lambda z: z + arb.pi(), None, False)
