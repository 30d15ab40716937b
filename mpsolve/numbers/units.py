"""Units in texts: "360 km/h" is exactly 100 m/s, where a velocity is asked for.

A unit is a rational factor and a dimension, so a value stays exact; what has no rational factor (Hz for rad/s,
degrees) is refused with what to write instead. A library does not pay here: pint takes a third of a second to import,
six times what `import mpsolve` may take, and reads "35 kN/mm" into floats unless it is told otherwise.
"""

from __future__ import annotations

import re
from fractions import Fraction
from functools import lru_cache
from typing import Any, NoReturn

from mpsolve.errors import InputError
from mpsolve.numbers.exact import Exact
from mpsolve.numbers.unit_names import Dimension, unit_of
from mpsolve.numbers.written import HOW, Measured

Factor = tuple[Fraction, Dimension]

_F = Fraction
_POUND, _GRAVITY, _FOOT = _F("0.45359237"), _F("9.80665"), _F("0.3048")
_PREFIXED: dict[str, Factor] = {
    "g": (_F(1, 1000), (1, 0, 0)),
    "m": (_F(1), (0, 1, 0)),
    "s": (_F(1), (0, 0, 1)),
    "t": (_F(1000), (1, 0, 0)),
    "N": (_F(1), (1, 1, -2)),
    "Pa": (_F(1), (1, -1, -2)),
    "J": (_F(1), (1, 2, -2)),
}
_WHOLE: dict[str, Factor] = {
    "rad": (_F(1), (0, 0, 0)),
    "%": (_F(1, 100), (0, 0, 0)),
    "min": (_F(60), (0, 0, 1)),
    "h": (_F(3600), (0, 0, 1)),
    "kph": (_F(1000, 3600), (0, 1, -1)),
    "mph": (5280 * _FOOT / 3600, (0, 1, -1)),
    "mi": (5280 * _FOOT, (0, 1, 0)),
    "ft": (_FOOT, (0, 1, 0)),
    "in": (_FOOT / 12, (0, 1, 0)),
    "lb": (_POUND, (1, 0, 0)),
    "lbf": (_POUND * _GRAVITY, (1, 1, -2)),
    "kip": (1000 * _POUND * _GRAVITY, (1, 1, -2)),
    "kgf": (_GRAVITY, (1, 1, -2)),
    "bar": (_F(100_000), (1, -1, -2)),
}
_PREFIXES = {"G": 9, "M": 6, "k": 3, "d": -1, "c": -2, "m": -3, "µ": -6, "u": -6, "n": -9}
_CYCLES = {"Hz": "2π rad/s", "kHz": "2000π rad/s", "rpm": "2π/60 rad/s", "°": "π/180 rad", "deg": "π/180 rad"}
_COMMON = ("km/h", "kN/mm", "kN/m", "MN/m", "MN/m²", "kN m²", "N s/m²", "kN s/m", "kg/m", "mm", "km", "kN", "t", "kg")
_WRITTEN = {"kmh": "km/h", "kmph": "km/h", "kmhr": "km/h", "mps": "m/s", "kgm": "kg/m"}
_WRITTEN |= (
    dict.fromkeys(("ton", "tons", "tonne", "tonnes"), "t") | dict.fromkeys(("sec", "secs"), "s") | {"msec": "ms"}
)
_WRITTEN |= dict.fromkeys(("meter", "meters", "metre", "metres"), "m")
"""What people write, in lower case."""
_MOST = 8  # of an exponent
_SUPERSCRIPTS = str.maketrans("⁰¹²³⁴⁵⁶⁷⁸⁹⁻⁺", "0123456789-+")
_ALIKE = str.maketrans({"μ": "µ", "⋅": "·", "−": "-", "\u00a0": " ", "\u202f": " "})
# texts of patterns, which `re` keeps once they are used: most runs read no unit
_NUMBER = r"\s*([+-]?(?:[0-9_]+\s*/\s*[0-9_]+(?![0-9_.])|(?:[0-9_]+\.?[0-9_]*|\.[0-9_]+)(?:[eE][+-]?[0-9_]+)?))(.*)"
_UNDER = r"([0-9]+(?:\.[0-9]*)?|\.[0-9]+)\s*([^0-9.\s].*)"
_TIMES = r"[*·×]\s*([0-9]+(?:\.[0-9]*)?(?:[eE][+-]?[0-9]+)?|\.[0-9]+)(?=[\s(A-Za-zµ]|$)"
_SYMBOL = r"([A-Za-zµ]+|%|°)(?:\^|\*\*)?([+-]?[0-9]+|[⁻⁺]?[⁰¹²³⁴⁵⁶⁷⁸⁹]+)?"
_JOINED = r"([GMk]?N)(mm|m|s)(?![A-Za-z])"  # kNm², Ns/m
_COMMA = r"\s*[+-]?[0-9]+,[0-9]+\s*[^0-9]*"
_SPACED = r"\s*[+-]?[0-9]{1,3}( [0-9]{3})+(?![0-9])"


def split(text: str) -> tuple[str, str]:
    """The number and the unit of a text: ("360", "km/h"); the unit is "" where there is none."""
    tidy = text.translate(_ALIKE)
    parts = re.fullmatch(_NUMBER, tidy)
    return (parts[1], parts[2].strip()) if parts else (tidy.strip(), "")


def measured(value: Any, unit: str, key: str, told: str = "") -> Any:
    """`value` in `unit`, exactly, where it is a text with a unit of its own; all else unchanged.

    unit: what the parameter is measured in, "" for a bare number. told: what the parameter is, for the message.
    InputError under `key` where the unit is unknown, or of another kind.

    >>> measured("360 km/h", "m/s", "v"), measured("12.5 t", "kg", "M"), measured("0.1", "m/s", "v")
    (Fraction(100, 1), Fraction(12500, 1), '0.1')
    """
    if not isinstance(value, str):
        return value
    _refuse_look_alike(value, key)
    number, given = split(value)
    if not given:
        return number
    if re.match(r"/\s*[0-9.]", given):
        stated = "a ratio has two whole numbers: write it so, or with the distance in brackets, as 145 kg/(0.6 m)"
        _refuse(value, key, f"but {stated}")
    return Measured(Exact.parse(number, key).as_fraction() * _ratio(value, given, unit, key, told), value)


def in_unit(value: object, unit: str, key: str, told: str = "") -> Fraction:
    """The exact rational in `unit` that `value` stands for; InputError under `key` where it is none."""
    try:
        exact = Exact.parse(measured(value, unit, key, told), key)
    except InputError as error:  # a measured value is no root
        how = "write a decimal such as 0.67 or a ratio such as 67/100"
        how += f", with a unit such as {unit}" if unit else ""
        raise InputError(key, error.said.replace(HOW, how)) from None
    if not exact.is_rational:
        raise InputError(key, f"is {exact.short()}, which is irrational: give a decimal or a ratio p/q")
    return exact.as_fraction()


@lru_cache(maxsize=256)
def factor(unit: str) -> Factor:
    """The factor and the dimension of a unit such as "kN/mm" or "N s/m²"; ValueError says what is wrong with it."""
    unit = unit.translate(_ALIKE).strip()
    if not unit:
        return Fraction(1), (0, 0, 0)
    above, *below = unit.replace("(", " ( ").replace(")", " ) ").split("/")
    size, powers = (Fraction(1), (0, 0, 0)) if above.strip() == "1" and below else _product(above, False)
    for part in below:
        bracketed = part.strip().startswith("(") and part.strip().endswith(")")
        number, dimension = _bracket(part.strip(" ()")) if bracketed else _product(part, True)
        size /= number
        powers = _sum(powers, dimension, -1)
    return size, powers


def _bracket(text: str) -> Factor:
    """What stands in brackets under a stroke: units, with a number before them where there is one, as (0.6 m)."""
    parts = re.fullmatch(_UNDER, text)
    if parts is None:
        return _product(text, False)
    number = Fraction(parts[1])
    if not number:
        raise ValueError("divides by zero")
    size, dimension = _product(parts[2], False)
    return number * size, dimension


def _product(text: str, alone: bool) -> Factor:
    """A product of symbols; one only where it stands under a stroke without brackets."""
    size, text = Fraction(1), re.sub(_JOINED, r"\1 \2", text).replace("**", "^")
    if not alone:  # numbers between units, as in 210 GPa * 3038 cm^4
        for times in re.findall(_TIMES, text):
            size *= Fraction(times)
        text = re.sub(_TIMES, " ", text)
    words = text.replace("·", " ").replace("*", " ").replace(" ^", "^").split()
    if not words:
        raise ValueError("has a stroke with nothing on one side")
    if alone and len(words) > 1:
        raise ValueError(f"leaves open what stands under the stroke: write /({' '.join(words)})")
    if alone and re.match(r"[0-9.]", words[0]):
        raise ValueError(f"divides by {words[0]}, a number alone: write the distance as /(0.6 m), with its unit")
    powers = (0, 0, 0)
    for word in words:
        parts = re.fullmatch(_SYMBOL, word)
        if parts is None:
            raise _NoUnitError(word)
        number, dimension = _symbol(parts[1])
        power = int((parts[2] or "1").translate(_SUPERSCRIPTS))
        if abs(power) > _MOST:
            raise ValueError(f"has the exponent {power}: give one from −{_MOST} to {_MOST}")
        size, powers = size * number**power, _sum(powers, dimension, power)
    return size, powers


def _symbol(name: str) -> Factor:
    if name in _CYCLES:
        raise ValueError(
            f"is {_CYCLES[name]}, which no ratio gives exactly: write rad/s or rad, as many digits as wanted"
        )
    known = _WHOLE.get(name) or _PREFIXED.get(name)
    if known:
        return known
    prefix, base = name[:1], name[1:]
    if prefix in _PREFIXES and base in _PREFIXED:
        size, dimension = _PREFIXED[base]
        return size * Fraction(10) ** _PREFIXES[prefix], dimension
    raise _NoUnitError(name)


class _NoUnitError(ValueError):
    """A part of a unit is none."""

    def __init__(self, name: str) -> None:
        super().__init__(f"has the part {name!r}, which is no unit")
        self.name = name

    def told(self, unit: str) -> str:
        """What is wrong with the unit, and the one that is meant, as far as one can tell; case counts."""
        from difflib import get_close_matches

        low, names = self.name.lower(), [*_WHOLE, *(p + b for p in ("", *_PREFIXES) for b in _PREFIXED)]
        same = [_WRITTEN[low]] if low in _WRITTEN else [known for known in names if known.lower() == low]
        near = same or get_close_matches(self.name, names, n=1, cutoff=0.7)
        meant = (
            f"did you mean {unit.replace(self.name, near[0])}?"
            if near
            else f"units are {', '.join(_COMMON)} and the like"
        )
        return f"{self.name!r} is no unit: {meant}"


def _ratio(text: str, given: str, unit: str, key: str, told: str) -> Fraction:
    """How many `unit` a `given` is; 1 where they are written alike, as Hz and K, which are no SI products here."""
    if given == unit:
        return Fraction(1)
    try:
        size, dimension = factor(given)
    except _NoUnitError as error:
        raise InputError(key, f"is {_quoted(text)}, but {error.told(given)}") from None
    except ValueError as error:
        raise InputError(key, f"is {_quoted(text)}, whose unit {error}") from None
    own, wanted = factor(unit)
    if dimension != wanted:
        kind = unit_of(dimension) or "a bare number"
        other = f"whose unit is {kind}, but the {told or 'value'} is in {unit}: give it in {unit} or its like"
        if _sum(dimension, (0, 1, 0), -1) == wanted and any(layer in told for layer in _LAYERS):
            other += f"; what one rail seat has is divided by the distance of the sleepers, as {text.strip()}/(0.6 m)"
        _refuse(text, key, other if unit else f"but the {told or 'value'} has no unit: leave the unit out")
    return size / own


_LAYERS = ("pads", "sleepers", "ballast", "ground")
"""What is known at rail seats, and is given per metre of track."""


def _sum(a: Dimension, b: Dimension, times: int) -> Dimension:
    return a[0] + times * b[0], a[1] + times * b[1], a[2] + times * b[2]


def _refuse_look_alike(text: str, key: str) -> None:
    """Numbers as people write them, which are none here."""
    if re.match(_SPACED, text):
        _refuse(text, key, "whose spaces stand within the number: write it without spaces, or 1_000 for 1 000")
    if re.fullmatch(_COMMA, text):
        _refuse(text, key, "with a comma: write a point for the decimals, and no comma for thousands")


def _refuse(text: str, key: str, why: str) -> NoReturn:
    raise InputError(key, f"is {_quoted(text)}, {why}")


def _quoted(text: str) -> str:
    return repr(text if len(text) <= 40 else text[:37] + "…")
