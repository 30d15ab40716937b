"""What a user gives for f, as a function on balls: a text, sympy's expression, a Python function, or two of them."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

from flint import acb

from mpsolve.errors import InputError, PrecisionError
from mpsolve.numbers.balls import arb, precision
from mpsolve.zeros.evaluate import Evaluator
from mpsolve.zeros.fraction import as_fraction, product_of
from mpsolve.zeros.function import CallableFunction, ExpressionFunction, Function
from mpsolve.zeros.parse import from_sympy, parse
from mpsolve.zeros.program import Expression, Program, dependent, reduced, shown
from mpsolve.zeros.trace import UnreadableError, takes_flag, trace

VOUCHED = "f gives balls that are not finite wherever it may not be analytic"
FLAGGED = "f passes the flag `analytic` on to every function with a branch cut, and to nothing that is not analytic"
DERIVED = "derivative gives balls that hold f′"


@dataclass(frozen=True)
class Given:
    """f as it was read. expression: None for a Python function that cannot be read."""

    function: Function
    denominator: Function | None
    expression: Expression | None
    assumed: tuple[str, ...]
    words: str


def read_function(f: object, derivative: Callable[[Any], Any] | None, assume_analytic: bool) -> Given:
    """InputError for what is no function, is not analytic, or cannot be read and is not vouched for."""
    if isinstance(f, tuple):
        if len(f) != 2:
            raise InputError("f", f"is a tuple of {len(f)}: give (numerator, denominator)")
        return _quotient(f, derivative, assume_analytic)
    program = Program()
    try:
        given = of_expression(as_fraction(program, _step(program, f)))
        if callable(f) and not hasattr(f, "free_symbols"):
            _require_same(f, given)
        return given
    except UnreadableError as error:
        return _opaque(f, derivative, assume_analytic, str(error))


def of_expression(expression: Expression) -> Given:
    """What is known of an expression."""
    if not dependent(expression.steps)[expression.numerator]:
        raise InputError("f", f"is {expression}, which vanishes nowhere or everywhere: give a function of z")
    for output in (expression.numerator, expression.denominator):
        if output is not None:
            _require_constants(expression, output)
    below = None if expression.denominator is None else ExpressionFunction(expression, expression.denominator)
    return Given(ExpressionFunction(expression, expression.numerator), below, expression, (), str(expression))


def _require_constants(expression: Expression, output: int) -> None:
    """InputError where a constant factor or divisor is 0, or cannot be told from it."""
    _, constants = product_of(expression.steps, output)
    if not constants:
        return
    with precision(1024):
        for k in constants:
            steps, _ = reduced(expression.steps, [k])
            try:
                nonzero = Evaluator(steps).run(acb(0), 1)[-1].abs_lower() > 0
            except PrecisionError:
                nonzero = False
            if not nonzero:
                stated = f"has the constant factor {shown(expression.steps, k, 60)}, which may be 0"
                raise InputError("f", f"{stated}: leave it out, or give a function that has values other than 0")


def _step(program: Program, f: object) -> int:
    if isinstance(f, str):
        return parse(program, f)
    if isinstance(f, Expression):
        raise InputError("f", "is a reduced expression: give its text")
    if hasattr(f, "free_symbols"):
        return from_sympy(program, f)
    if callable(f):
        return trace(program, f)
    raise InputError("f", f"is of type {type(f).__name__}: give a text, an expression of sympy, or a function")


def _quotient(f: tuple[Any, ...], derivative: Callable[[Any], Any] | None, assume_analytic: bool) -> Given:
    program = Program()
    try:
        return of_expression(as_fraction(program, program.div(_step(program, f[0]), _step(program, f[1]))))
    except UnreadableError as error:
        top = _opaque(f[0], derivative, assume_analytic, str(error))
        bottom = _opaque(f[1], None, assume_analytic, str(error))
        words = "a quotient of Python functions"
        return Given(top.function, bottom.function, None, top.assumed, words)


def _opaque(f: Any, derivative: Callable[[Any], Any] | None, assume_analytic: bool, why: str) -> Given:
    """A function of which only balls are known: refused unless someone vouches that it is analytic."""
    if not callable(f):
        raise InputError("f", f"is of type {type(f).__name__}: give two Python functions, or two expressions")
    flagged = takes_flag(f)
    if not flagged and not assume_analytic:
        raise InputError(
            "f",
            f"cannot be read as an expression ({why}), so nothing shows that it is analytic: write it with z's own "
            "methods, or as f(z, analytic) with the flag passed on as acb.integral has it, or vouch for it with "
            "assume_analytic=True",
        )
    function = CallableFunction((lambda z: f(z, True)) if flagged else f, derivative)
    _require_analytic_at_points(function)
    name = getattr(f, "__name__", "a Python function")
    assumed = (FLAGGED if flagged else VOUCHED, *(() if derivative is None else (DERIVED,)))
    return Given(function, None, None, assumed, f"the Python function {name}")


def _require_same(f: Callable[[Any], Any], given: Given) -> None:
    """Refuses a function that does something else to a ball than to a symbol, at a few points. No proof."""
    for point in _POINTS:
        try:
            value = acb(f(acb(point)))
            read = given.function.value(acb(point))
            read = read / given.denominator.value(acb(point)) if given.denominator is not None else read
        except (PrecisionError, ArithmeticError, ValueError, TypeError, AttributeError):
            continue
        if value.is_finite() and not value.overlaps(read):
            raise InputError(
                "f", f"has another value at {point:.3g} than as an expression: give a function of z alone"
            )


_POINTS = (0.37 + 0.41j, -1.3 + 0.7j, 2.1 - 1.9j, -0.2 - 2.3j, 3.7 + 0.01j, 0.05 + 5.5j)


def _require_analytic_at_points(function: CallableFunction) -> None:
    """Refuses what is plainly not analytic, as its difference quotients depend on their direction, and a derivative
    that is plainly another one. No proof."""
    step = arb(2) ** -40
    with precision(160):
        for point in _POINTS:
            try:
                middle = function.value(acb(point))
                quotients = [
                    (function.value(acb(point) + step * d) - middle) / (step * d) for d in (acb(1), acb(0, 1))
                ]
                given = quotients[0] if function.derivative is None else function.slope(acb(point))
            except PrecisionError:
                continue
            if _differ(*quotients):
                raise InputError(
                    "f", f"is not analytic near {point:.3g}: its slope there depends on the direction of z"
                )
            if _differ(quotients[0], given):
                raise InputError("derivative", f"is not f′ near {point:.3g}: give that of f, or leave it out")


def _differ(one: Any, other: Any) -> bool:
    scale, gap = max(float(abs(x).upper()) for x in (one, other)), float(abs(one - other).lower())
    return gap > 1e-4 * scale and gap > 1e-9
