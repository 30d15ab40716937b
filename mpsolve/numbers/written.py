"""Numbers as texts: what is read within limits, and how a decimal is printed short."""

from __future__ import annotations

import re
from decimal import Decimal
from fractions import Fraction
from typing import Any, NoReturn

from mpsolve.errors import InputError

MAX_TEXT = 20_000
"""Longest text of one number, in characters."""
MAX_DIGITS = 400
"""Most decimal digits in the numerator or denominator of a number that is given as a rational."""
MAX_RADICAND_DIGITS = 4_000
"""The same for the radicand of a fourth root, which may be M⁴k/(4EI m⁴) of such numbers, with ten factors."""
_UNSIGNED = r"(?P<mantissa>[0-9_]+\.?[0-9_]*|\.[0-9_]+)(?:[eE](?P<exponent>[+-]?[0-9_]+))?"
_RATIO = r"(?P<numerator>[0-9_]+)\s*/\s*(?P<denominator>[0-9_]+)"
_NUMBER = re.compile(rf"(?:{_RATIO}|{_UNSIGNED})")
SIGNED = re.compile(r"(?P<sign>[+-]?)(?:root4\(\s*(?P<radicand>[^()]*?)\s*\)|(?P<plain>[^()]+))")
_BAD_UNDERSCORE = re.compile(r"(?<![0-9])_|_(?![0-9])")
_LONG = 40
"""Characters of a text that fits into a sentence."""
_WITHOUT_UNIT = re.compile(r"[\s0-9+\-._/eE]*(root4\(.*)?")
HOW = "write a decimal such as 0.67, a ratio such as 67/100, or root4(p/q)"


class Measured(Fraction):
    """An exact value, and the text with a unit of its own that gave it."""

    __slots__ = ("text",)
    text: str

    def __new__(cls, value: Fraction, text: str) -> Measured:
        self = super().__new__(cls, value)
        self.text = text
        return self

    def __repr__(self) -> str:
        return repr(Fraction(self))

    def __reduce__(self) -> Any:
        return Fraction, (self.numerator, self.denominator)

    def __deepcopy__(self, _: object = None) -> Measured:
        return self

    __copy__ = __deepcopy__


def as_given(given: object, short: str) -> str:
    """How a message tells a number back: as the text with a unit that gave it, else `short`."""
    text = given.text if isinstance(given, Measured) else given
    if not isinstance(text, str) or len(text) > _LONG or _WITHOUT_UNIT.fullmatch(text):
        return short
    return text.strip()


def short_text(rounded: Decimal, digits: int) -> str:
    """A decimal without zeros at its end; with an exponent below 10^−5 (or a third of the digits), from 10^digits."""
    if not rounded:
        return "0"
    sign, figures, _ = rounded.as_tuple()
    exponent = rounded.adjusted()
    least = min(-(digits // 3), -5)
    if least < exponent < digits:
        return f"{rounded:f}"
    text = "".join(map(str, figures))
    mantissa = text[0] + (f".{text[1:]}" if len(text) > 1 else "")
    return f"{'-' if sign else ''}{mantissa}e{exponent:+d}"


def unsigned(text: str, whole: str, digits: int, key: str) -> Fraction:
    """Return the unsigned decimal or ratio `text` of at most `digits` digits; `whole` is for the message."""
    parts = _NUMBER.fullmatch(text)
    if parts is None or _BAD_UNDERSCORE.search(text):
        refuse_text(whole, key)
    try:
        power = int(parts["exponent"] or 0)
        top = Fraction((parts["numerator"] or parts["mantissa"]).replace("_", ""))
        bottom = int(parts["denominator"] or 1)
    except ValueError:  # Python refuses to read integers beyond its own limit of digits
        raise InputError(key, f"{_shown(whole)} has too many digits: give at most {digits}") from None
    if abs(power) > digits:
        raise InputError(key, f"{_shown(whole)} has an exponent beyond ±{digits}: give a smaller one")
    if not bottom:
        raise InputError(key, f"{_shown(whole)} divides by zero: give a denominator above 0")
    return bounded(top / bottom * Fraction(10) ** power, digits, key)


def bounded(value: Fraction, digits: int, key: str) -> Fraction:
    if max(abs(value.numerator), value.denominator) >= 10**digits:
        raise InputError(key, f"needs more than {digits} digits as a ratio of integers: give fewer digits")
    return value


def refuse_text(text: str, key: str) -> NoReturn:
    if text.strip().lstrip("+-").lower() in ("nan", "snan", "inf", "infinity"):
        raise InputError(key, f"{_shown(text)} is not finite: give a finite number")
    raise InputError(key, f"{_shown(text)} is not a number: {HOW}")


def _shown(text: str) -> str:
    """Return `text` quoted and cut to a length that fits into a sentence."""
    return repr(text if len(text) <= _LONG else text[: _LONG - 3] + "…")
