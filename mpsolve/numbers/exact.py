"""Real numbers whose fourth power is rational: the parameters of a rational physical case.

Every dimensionless parameter in (10)–(12) of such a case is a fourth root of a rational number, with a
sign. Kept in that form, a case is recorded and compared without any rounding.
"""

from __future__ import annotations

import math
import numbers
from collections.abc import Iterable
from decimal import MAX_EMAX, MIN_EMIN, ROUND_HALF_UP, Context, Decimal
from fractions import Fraction
from functools import total_ordering
from typing import Any, NoReturn, TypeAlias, final

from mpsolve.errors import InputError
from mpsolve.numbers import written
from mpsolve.numbers.balls import precision, rational_ball
from mpsolve.numbers.multiprecision import middle
from mpsolve.numbers.root4 import decimal_root, rational_root

Number: TypeAlias = "Exact | int | float | str | Fraction | Decimal"

_FLOAT_DIGITS, _GUARD_BITS = 20, 20


@final
@total_ordering
class Exact:
    """An immutable real x whose fourth power is rational, held exactly; `Exact(value)` parses `value`.

    Held as the rational x|x|³, which is increasing and multiplicative: order, products and quotients are
    exact. A sum exists only where the terms have a rational ratio.

    >>> Exact("0.67") < Exact("root4(1/4)"), Exact("root4(16/81)")
    (True, Exact('2/3'))
    """

    __slots__ = ("_rational", "_signed")
    _signed: Fraction
    _rational: Fraction | None

    def __new__(cls, value: Number = 0, key: str = "value") -> Exact:
        return cls.parse(value, key)

    @classmethod
    def parse(cls, value: object, key: str = "value") -> Exact:
        """Return `value` exactly as written; a float stands for its shortest decimal text (0.1 is 1/10).

        Takes Exact, int, Fraction, Decimal, float, a NumPy scalar, or text: "0.67", "67/100", "-1.5e-3",
        "root4(123/456)". Raises InputError under `key` for all else: bool, nan, infinity, numbers beyond
        `MAX_DIGITS`.
        """
        if isinstance(value, Exact):
            return value
        if isinstance(value, numbers.Rational) and not isinstance(value, bool):
            fraction = Fraction(int(value.numerator), int(value.denominator))
            return cls._from_fraction(written.bounded(fraction, written.MAX_DIGITS, key))
        if isinstance(value, float):
            return cls._from_text(float.__repr__(value), key)
        if isinstance(value, (str, Decimal, numbers.Real)) and not isinstance(value, bool):
            return cls._from_text(str(value), key)
        raise InputError(key, f"is of type {type(value).__name__}, not a number: " + written.HOW)

    @classmethod
    def root4(cls, radicand: Fraction | int) -> Exact:
        """Return the real fourth root of a rational ≥ 0, exactly; ValueError below 0."""
        if radicand < 0:
            raise ValueError(f"{radicand} has no real fourth root")
        return cls._from_signed(Fraction(radicand))

    @classmethod
    def sqrt(cls, radicand: Fraction | int) -> Exact:
        """Return the square root of a rational ≥ 0, exactly; ValueError below 0."""
        if radicand < 0:
            raise ValueError(f"{radicand} has no real square root")
        return cls._from_signed(Fraction(radicand) ** 2)

    @classmethod
    def _from_text(cls, text: str, key: str) -> Exact:
        if len(text) > written.MAX_TEXT:
            raise InputError(key, f"has {len(text)} characters, more than the {written.MAX_TEXT} that are read")
        parts = written.SIGNED.fullmatch(text.strip())
        if parts is None:
            written.refuse_text(text, key)
        if parts["plain"] is not None:
            size = written.unsigned(parts["plain"], text, written.MAX_DIGITS, key)
            return cls._from_fraction(-size if parts["sign"] == "-" else size)
        radicand = written.unsigned(parts["radicand"], text, written.MAX_RADICAND_DIGITS, key)
        return cls._from_signed(-radicand if parts["sign"] == "-" else radicand)

    @classmethod
    def _from_fraction(cls, value: Fraction) -> Exact:
        return cls._assemble(value * abs(value) ** 3, value)

    @classmethod
    def _from_signed(cls, signed: Fraction) -> Exact:
        return cls._assemble(signed, rational_root(signed))

    @classmethod
    def _assemble(cls, signed: Fraction, rational: Fraction | None) -> Exact:
        self = object.__new__(cls)
        object.__setattr__(self, "_signed", signed)
        object.__setattr__(self, "_rational", rational)
        return self

    def __setattr__(self, name: str, *_: object) -> NoReturn:
        raise AttributeError(f"an Exact cannot be changed: {name}")

    __delattr__ = __setattr__

    def __reduce__(self) -> tuple[Any, tuple[Fraction, Fraction | None]]:
        return Exact._assemble, (self._signed, self._rational)

    @property
    def is_rational(self) -> bool:
        """True if and only if x itself is rational."""
        return self._rational is not None

    def as_fraction(self) -> Fraction:
        """Return x as a Fraction, exactly; ValueError if x is irrational."""
        if self._rational is None:
            raise ValueError(f"{self.short()} = {self} is irrational")
        return self._rational

    @property
    def fourth_power(self) -> Fraction:
        """x⁴, exactly."""
        return abs(self._signed)

    @property
    def sign(self) -> int:
        """-1, 0 or 1, exactly."""
        return (self._signed > 0) - (self._signed < 0)

    def __bool__(self) -> bool:
        return self._signed != 0

    def __eq__(self, other: object) -> bool:
        exact = _coerced(other)
        return NotImplemented if exact is None else self._signed == exact._signed

    def __lt__(self, other: Exact | int | Fraction) -> bool:
        exact = _coerced(other)
        return NotImplemented if exact is None else self._signed < exact._signed

    def __hash__(self) -> int:
        return hash(("root4", self._signed)) if self._rational is None else hash(self._rational)

    def __neg__(self) -> Exact:
        return Exact._assemble(-self._signed, None if self._rational is None else -self._rational)

    def __abs__(self) -> Exact:
        return -self if self._signed < 0 else self

    def __mul__(self, other: Exact | int | Fraction) -> Exact:
        exact = _coerced(other)
        return NotImplemented if exact is None else Exact._from_signed(self._signed * exact._signed)

    __rmul__ = __mul__

    def __truediv__(self, other: Exact | int | Fraction) -> Exact:
        exact = _coerced(other)
        return NotImplemented if exact is None else Exact._from_signed(self._signed / exact._signed)

    def __rtruediv__(self, other: int | Fraction) -> Exact:
        exact = _coerced(other)
        return NotImplemented if exact is None else exact / self

    def __add__(self, other: Exact | int | Fraction) -> Exact:
        """Return the sum, exactly; ValueError where its fourth power is irrational."""
        exact = _coerced(other)
        if exact is None:
            return NotImplemented
        if not exact:
            return self
        ratio = self / exact
        if ratio._rational is None:
            raise ValueError(f"{self} and {exact} have no rational ratio: their sum is no fourth root")
        return Exact._from_fraction(ratio._rational + 1) * exact

    __radd__ = __add__

    def __sub__(self, other: Exact | int | Fraction) -> Exact:
        exact = _coerced(other)
        return NotImplemented if exact is None else self + -exact

    def __rsub__(self, other: int | Fraction) -> Exact:
        exact = _coerced(other)
        return NotImplemented if exact is None else exact + -self

    def __float__(self) -> float:
        """Return x within 1.2e-16 relative, if not below the normal doubles; OverflowError above."""
        if self._rational is not None:
            return float(self._rational)
        found = float(decimal_root(self._signed, self._rational, _FLOAT_DIGITS))
        if math.isinf(found):
            raise OverflowError(f"{self} is beyond the range of floats")
        return found

    def __str__(self) -> str:
        """Return the canonical text, from which `Exact.parse` gives x back."""
        root = f"{'-' if self._signed < 0 else ''}root4({self.fourth_power})"
        return root if self._rational is None else str(self._rational)

    def __repr__(self) -> str:
        return f"Exact('{self}')"

    def short(self, digits: int = 6) -> str:
        """Return x rounded to `digits` significant digits, for people to read."""
        context = Context(prec=digits, rounding=ROUND_HALF_UP, Emax=MAX_EMAX, Emin=MIN_EMIN)
        rounded = context.normalize(decimal_root(self._signed, self._rational, 2 * digits + _FLOAT_DIGITS))
        return written.short_text(rounded, digits)

    def beside(self, bound: int) -> str:
        """Return x as `short`, with as many digits as tell it from the bound, or the exact text."""
        for digits in (6, 12, 24, 48):
            text = self.short(digits)
            if self == bound or text != str(bound):
                return text
        return str(self)

    def ball(self) -> Any:
        """Return a ball that contains x, at the present `flint.ctx.prec`."""
        if self._rational is not None:
            return rational_ball(self._rational)
        root = rational_ball(self.fourth_power).root(4)
        return -root if self._signed < 0 else root

    def mpf(self, context: Any) -> Any:
        """Return x within one unit in the last place of `context`, an mpmath multiprecision context."""
        with precision(context.prec + _GUARD_BITS):
            return +middle(context, self.ball())


def exact_list(values: Iterable[Number] | Number, key: str) -> tuple[Exact, ...]:
    """One number, or each of many, as `Exact.parse` reads them; InputError names the one that is none."""
    scalar: Any = values
    if getattr(values, "ndim", None) == 0:  # a NumPy array without dimensions holds one number
        scalar = scalar[()]
    given = [scalar] if isinstance(scalar, (str, bytes)) or not isinstance(scalar, Iterable) else list(scalar)
    return tuple(Exact.parse(value, f"{key}[{j}]") for j, value in enumerate(given, 1))


def _coerced(value: object) -> Exact | None:
    """Return an Exact, int or Fraction as Exact; None for a type that carries no exact meaning here."""
    if isinstance(value, Exact):
        return value
    return Exact._from_fraction(Fraction(value)) if isinstance(value, (int, Fraction)) else None
