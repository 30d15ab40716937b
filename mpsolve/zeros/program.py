"""A function of one complex variable z as exact steps: each names an operation and the earlier steps that it takes.

Equal steps stand once. What a certificate carries is this list. Functions that are others in disguise (tan, sinh,
gamma, atan, …) are made of the few in `FUNCTIONS`, with the principal branches that are usual for them.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, field
from fractions import Fraction
from typing import Any

from mpsolve.errors import InputError

Step = tuple[Any, ...]
"""("z",), ("number", "p/q"), ("i",), ("pi",), (operation, step, step), ("pow", step, n), (function, step, …)."""

LEAVES = ("z", "number", "i", "pi")
OPERATIONS = ("add", "sub", "mul", "div")
FUNCTIONS = ("exp", "log", "sqrt", "sin", "cos", "sinh", "cosh", "atan", "rgamma", "erf", "airy_ai", "airy_bi")
WITH_ORDER = {"bessel_j": int, "hyp0f1": str}  # and a whole order, or a rational parameter above 0
CUT = ("log", "sqrt")
MOST_STEPS, MOST_POWER = 5000, 10_000


@dataclass
class Program:
    """Steps in the order of their evaluation."""

    steps: list[Step] = field(default_factory=list)
    places: dict[Step, int] = field(default_factory=dict)

    def step(self, *step: Any) -> int:
        """The place of this step, which is appended where it is new."""
        if step not in self.places:
            if len(self.steps) >= MOST_STEPS:
                raise InputError("f", f"has more than {MOST_STEPS} steps: give a shorter expression")
            self.places[step] = len(self.steps)
            self.steps.append(step)
        return self.places[step]

    @property
    def z(self) -> int:
        return self.step("z")

    @property
    def i(self) -> int:
        return self.step("i")

    def number(self, x: Fraction | int) -> int:
        return self.step("number", str(Fraction(x)))

    def rational(self, k: int) -> Fraction | None:
        """The number that step k is, or None."""
        return Fraction(self.steps[k][1]) if self.steps[k][0] == "number" else None

    def add(self, a: int, b: int) -> int:
        x, y = self.rational(a), self.rational(b)
        if x is not None and y is not None:
            return self.number(x + y)
        return b if x == 0 else a if y == 0 else self.step("add", a, b)

    def sub(self, a: int, b: int) -> int:
        x, y = self.rational(a), self.rational(b)
        if x is not None and y is not None:
            return self.number(x - y)
        return a if y == 0 else self.step("sub", a, b)

    def mul(self, a: int, b: int) -> int:
        x, y = self.rational(a), self.rational(b)
        if x is not None and y is not None:
            return self.number(x * y)
        if x == 0 or y == 0:
            return self.number(0)
        return b if x == 1 else a if y == 1 else self.step("mul", a, b)

    def div(self, a: int, b: int) -> int:
        x, y = self.rational(a), self.rational(b)
        if y == 0:
            raise InputError("f", "is divided by zero: give a function that has values")
        if y is not None:
            return self.number(x / y) if x is not None else self.mul(a, self.number(1 / y))
        return self.step("div", a, b)

    def neg(self, a: int) -> int:
        return self.sub(self.number(0), a)

    def power(self, a: int, b: int) -> int:
        """a^b: by multiplication for a whole b, by the square root for halves, else e^{b log a}."""
        x, y = self.rational(a), self.rational(b)
        if y is not None and y.denominator == 1:
            return self.whole(a, int(y), x)
        if y is not None and y.denominator == 2:
            return self.mul(self.whole(a, (y.numerator - 1) // 2, x), self.call("sqrt", a))
        if x is not None and x <= 0:
            raise InputError("f", f"has {x} to a power that is no whole number: write it with a base above 0")
        return self.call("exp", self.mul(b, self.call("log", a)))

    def whole(self, a: int, n: int, x: Fraction | None = None) -> int:
        """a to the whole power n."""
        if abs(n) > MOST_POWER:
            raise InputError("f", f"has the power {n}: powers go up to {MOST_POWER}")
        if x is not None and (x or n >= 0) and abs(n) < 100:
            return self.number(x**n)
        if n < 0:
            return self.div(self.number(1), self.whole(a, -n))
        return self.number(1) if n == 0 else a if n == 1 else self.step("pow", a, n)

    def call(self, name: str, a: int, order: Any = None) -> int:
        """A function of FUNCTIONS, WITH_ORDER or DISGUISED at step a; InputError for another name."""
        if name in FUNCTIONS:
            return self.step(name, a)
        if name in DISGUISED:
            return DISGUISED[name](self, a)
        if name == "bessel_j":
            return self.step(name, a, _order(order))
        raise InputError("f", f"has {name}, which is not known: the functions are {', '.join(NAMES)}")


def _order(order: int) -> int:
    if isinstance(order, int) and not isinstance(order, bool) and abs(order) <= 1000:
        return order
    raise InputError("f", f"has a Bessel function of the order {order!r}: give a whole number up to 1000")


def _asin(p: Program, a: int) -> int:
    inner = p.add(p.mul(p.i, a), p.call("sqrt", p.sub(p.number(1), p.whole(a, 2))))
    return p.neg(p.mul(p.i, p.call("log", inner)))


def _log1p(p: Program, a: int) -> int:
    return p.call("log", p.add(p.number(1), a))


def _atanh(p: Program, a: int) -> int:
    return p.div(p.sub(_log1p(p, a), _log1p(p, p.neg(a))), p.number(2))


def _ratio(top: str, bottom: str) -> Callable[[Program, int], int]:
    return lambda p, a: p.div(p.call(top, a) if top else p.number(1), p.call(bottom, a))


def _of_square(parameter: str) -> Callable[[Program, int], int]:
    """₀F₁(parameter; −a/4): cos √a for 1/2, sin √a / √a for 3/2, both entire in a."""
    return lambda p, a: p.step("hyp0f1", p.mul(p.number(Fraction(-1, 4)), a), parameter)


DISGUISED: dict[str, Callable[[Program, int], int]] = {
    "tan": _ratio("sin", "cos"),
    "cot": _ratio("cos", "sin"),
    "sec": _ratio("", "cos"),
    "csc": _ratio("", "sin"),
    "tanh": _ratio("sinh", "cosh"),
    "coth": _ratio("cosh", "sinh"),
    "gamma": _ratio("", "rgamma"),
    "erfc": lambda p, a: p.sub(p.number(1), p.call("erf", a)),
    "expm1": lambda p, a: p.sub(p.call("exp", a), p.number(1)),
    "log1p": _log1p,
    "asin": _asin,
    "acos": lambda p, a: p.sub(p.div(p.step("pi"), p.number(2)), _asin(p, a)),
    "atanh": _atanh,
    "asinh": lambda p, a: p.call("log", p.add(a, p.call("sqrt", p.add(p.whole(a, 2), p.number(1))))),
    "acosh": lambda p, a: p.call(
        "log", p.add(a, p.mul(p.call("sqrt", p.sub(a, p.number(1))), p.call("sqrt", p.add(a, p.number(1)))))
    ),
    "cos_sqrt": _of_square("1/2"),
    "sinc_sqrt": _of_square("3/2"),
}
NAMES = (*FUNCTIONS, *DISGUISED, "bessel_j")
"""Every function that an expression may name."""


@dataclass(frozen=True)
class Expression:
    """One or two outputs of a program: f = numerator, or numerator/denominator; only the steps that they need."""

    steps: tuple[Step, ...]
    numerator: int
    denominator: int | None = None

    def __str__(self) -> str:
        top = shown(self.steps, self.numerator)
        if self.denominator is None:
            return top
        return f"({top})/({shown(self.steps, self.denominator)})"


def taken(step: Step) -> tuple[int, ...]:
    """The earlier steps that a step takes."""
    if step[0] in LEAVES:
        return ()
    return (step[1], step[2]) if step[0] in OPERATIONS else (step[1],)


def dependent(steps: Sequence[Step]) -> list[bool]:
    """Which steps depend on z."""
    out: list[bool] = []
    for step in steps:
        out.append(step[0] == "z" or any(out[k] for k in taken(step)))
    return out


def reduced(steps: Sequence[Step], outputs: Sequence[int]) -> tuple[tuple[Step, ...], tuple[int, ...]]:
    """Only the steps that the outputs need, and the new places of the outputs."""
    needed = set(outputs)
    for k in range(max(outputs), -1, -1):
        if k in needed:
            needed.update(taken(steps[k]))
    place = {old: new for new, old in enumerate(sorted(needed))}
    kept = tuple(_renamed(steps[k], place) for k in sorted(needed))
    return kept, tuple(place[k] for k in outputs)


def _renamed(step: Step, place: dict[int, int]) -> Step:
    count = len(taken(step))
    return (step[0], *(place[k] for k in step[1 : 1 + count]), *step[1 + count :])


_SIGN = {"add": "+", "sub": "-", "mul": "*", "div": "/"}


def shown(steps: Sequence[Step], output: int, most: int = 400) -> str:
    """The expression as a text, cut where it grows long."""
    texts: list[str] = []
    for step in steps[: output + 1]:
        name = step[0]
        if name in LEAVES:
            text = str(step[1]) if name == "number" else name
            text = f"({text})" if "/" in text or "-" in text else text
        elif name in OPERATIONS:
            text = f"({texts[step[1]]} {_SIGN[name]} {texts[step[2]]})"
        elif name == "pow":
            text = f"{texts[step[1]]}**{step[2]}"
        else:
            text = f"{name}({', '.join([*map(str, step[2:]), texts[step[1]]])})"
        texts.append(text if len(text) <= most else f"[step {len(texts)}]")
    text = texts[output]
    return text[1:-1] if text.startswith("(") and _closes_last(text) else text


def _closes_last(text: str) -> bool:
    """Whether the bracket that opens the text closes at its end."""
    depth = 0
    for k, c in enumerate(text):
        depth += (c == "(") - (c == ")")
        if not depth:
            return k == len(text) - 1
    return False
