"""A Python function read as an expression: it is called once, on a symbol that writes down what is done to it.

So a function that takes flint.acb by its operators and methods (z.sin(), z**2, …) is an expression, and all that is
known of expressions holds of it. A part of z, its modulus or its conjugate, which no analytic function may ask for,
is refused by name. A function that needs a ball (it calls flint itself, or asks whether z is small) is not readable.
"""

from __future__ import annotations

import inspect
from collections.abc import Callable
from decimal import Decimal
from fractions import Fraction
from typing import Any

import flint

from mpsolve.errors import InputError
from mpsolve.numbers.packed import dyadic
from mpsolve.zeros.program import NAMES, Program

_NOT_ANALYTIC = (
    "real", "imag", "conjugate", "arg", "sgn", "csgn", "abs_lower", "abs_upper", "rad", "mid",
    "real_abs", "real_sgn", "real_max", "real_min", "real_floor", "real_ceil", "real_heaviside", "real_sqrt",
)  # fmt: skip


class UnreadableError(Exception):
    """The function does what a symbol cannot follow; the message says what."""


def _refused(what: str) -> InputError:
    return InputError("f", f"takes {what}, so it is not analytic: give a function of z alone")


def _operator(name: str) -> tuple[Callable[[Symbol, Any], Symbol], Callable[[Symbol, Any], Symbol]]:
    """A method of a program as an operator of symbols: from the left, from the right."""

    def left(one: Symbol, x: Any) -> Symbol:
        return one._new(getattr(one.program, name)(one.place, one._other(x)))

    def right(one: Symbol, x: Any) -> Symbol:
        return one._new(getattr(one.program, name)(one._other(x), one.place))

    return left, right


class Symbol:
    """Stands for a ball; its operators and methods write steps."""

    def __init__(self, program: Program, place: int) -> None:
        self.program, self.place = program, place

    def _new(self, place: int) -> Symbol:
        return Symbol(self.program, place)

    def _other(self, x: Any) -> int:
        return x.place if isinstance(x, Symbol) else constant(self.program, x)

    __add__, __radd__ = _operator("add")
    __sub__, __rsub__ = _operator("sub")
    __mul__, __rmul__ = _operator("mul")
    __truediv__, __rtruediv__ = _operator("div")
    __pow__, __rpow__ = _operator("power")

    def __neg__(self) -> Symbol:
        return self._new(self.program.neg(self.place))

    def __pos__(self) -> Symbol:
        return self

    def __abs__(self) -> Symbol:
        raise _refused("abs(z)")

    def pow(self, x: Any, analytic: bool = True) -> Symbol:  # noqa: ARG002 — as flint's own
        return self.__pow__(x)

    def bessel_j(self, order: Any) -> Symbol:
        return self._new(self.program.call("bessel_j", self.place, _whole(order)))

    def __getattr__(self, name: str) -> Callable[..., Symbol]:
        if name in _NOT_ANALYTIC:
            raise _refused(f"z.{name}")
        if name not in NAMES:
            raise AttributeError(f"a symbol has no {name!r}")
        return lambda analytic=True: self._new(self.program.call(name, self.place))  # noqa: ARG005

    def _decided(self, *_: Any) -> Any:
        raise UnreadableError("it decides by the value of z")

    __bool__ = __lt__ = __gt__ = __le__ = __ge__ = __eq__ = __ne__ = _decided
    __float__ = __complex__ = __int__ = __index__ = _decided
    __hash__ = object.__hash__


def _whole(x: Any) -> Any:
    exact = x if isinstance(x, (int, flint.fmpz)) else None
    if exact is None and isinstance(x, (flint.arb, flint.acb)):
        exact = flint.acb(x).unique_fmpz() if flint.acb(x).is_exact() else None
    return None if exact is None else int(exact)


def constant(program: Program, x: Any) -> int:
    """An exact number: a float stands for itself, a ball must be a point. UnreadableError for another."""
    if isinstance(x, (bool, int, Fraction)):
        return program.number(Fraction(x))
    if isinstance(x, float):
        return program.number(_finite(x))
    if isinstance(x, complex):
        return program.add(program.number(_finite(x.real)), program.mul(program.number(_finite(x.imag)), program.i))
    if isinstance(x, (flint.fmpz, flint.fmpq)):
        return program.number(Fraction(int(x.numerator), int(x.denominator)) if hasattr(x, "denominator") else int(x))
    if isinstance(x, flint.arb) and x.is_exact() and x.is_finite():
        return program.number(dyadic(x))
    if isinstance(x, flint.acb) and x.is_exact() and x.is_finite():
        return program.add(program.number(dyadic(x.real)), program.mul(program.number(dyadic(x.imag)), program.i))
    if isinstance(x, Decimal) and x.is_finite():
        return program.number(Fraction(x))
    raise UnreadableError(f"it has a constant of type {type(x).__name__} that is not exact")


def _finite(x: float) -> Fraction:
    try:
        return Fraction(x)
    except (ValueError, OverflowError):
        raise InputError("f", f"has the constant {x}: give finite numbers") from None


def trace(program: Program, f: Callable[..., Any]) -> int:
    """The step that f is; UnreadableError where it cannot be read, InputError where it is not analytic."""
    if takes_flag(f):
        raise UnreadableError("it takes the flag `analytic`, as acb.integral has it")
    try:
        out = f(Symbol(program, program.z))
    except (InputError, UnreadableError):
        raise
    except Exception as error:  # noqa: BLE001 — whatever a user's function raises where it is given no ball
        raise UnreadableError(f"{type(error).__name__}: {error}") from None
    return out.place if isinstance(out, Symbol) else constant(program, out)


def takes_flag(f: Callable[..., Any]) -> bool:
    """Whether f takes (z, analytic)."""
    try:
        parameters = list(inspect.signature(f).parameters.values())
    except (TypeError, ValueError):
        return False
    kinds = (inspect.Parameter.POSITIONAL_ONLY, inspect.Parameter.POSITIONAL_OR_KEYWORD)
    needed = [p for p in parameters if p.kind in kinds and p.default is inspect.Parameter.empty]
    return len(needed) == 2
