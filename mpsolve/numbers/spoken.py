"""Numbers for people: three or four figures, and the unit in which an engineer says them ("252 km/h", "12.5 t").

What is printed here is never read back and decides nothing; files and JSON keep every digit.
"""

from __future__ import annotations

from decimal import ROUND_HALF_EVEN, Context, Decimal
from fractions import Fraction
from typing import Any

from mpsolve.errors import PrecisionError
from mpsolve.numbers.units import factor

FIGURES = 4
_EXPONENT = 6  # from here on, and below 10⁻⁴, a number is written with one
_SPOKEN: dict[str, tuple[tuple[Fraction, str], ...]] = {
    "m/s": ((Fraction(0), "km/h"),),
    "kg": ((Fraction(1000), "t"),),
    "m": ((Fraction(1000), "km"), (Fraction(1, 10), "m"), (Fraction(0), "mm")),
    "s": ((Fraction(1, 10), "s"), (Fraction(1, 10**4), "ms"), (Fraction(0), "µs")),
    "N": ((Fraction(10**6), "MN"), (Fraction(1000), "kN")),
    "N/m": ((Fraction(10**6), "kN/mm"), (Fraction(1000), "kN/m")),
    "N/m²": ((Fraction(10**6), "MN/m²"), (Fraction(1000), "kN/m²")),
    "N m²": ((Fraction(10**6), "MN m²"), (Fraction(1000), "kN m²")),
    "N m": ((Fraction(10**6), "MN m"), (Fraction(1000), "kN m")),
    "N s/m": ((Fraction(1000), "kN s/m"),),
    "N s/m²": ((Fraction(1000), "kN s/m²"),),
}
"""For each unit the ones that it is said in: the first whose least value is reached, else the unit itself."""


def rounded(x: Any, figures: int = FIGURES) -> str:
    """A number with at most so many figures and no zeros at its end: an int, a Fraction, a float or a ball.

    A ball gives the figures that hold for all of it; one that fixes none is "0" if it holds 0, else "≈" its middle.

    >>> rounded(Fraction(2, 3)), rounded(473_812), rounded(0.00001234567)
    ('0.6667', '473800', '1.235e-5')
    """
    if hasattr(x, "mid"):
        from mpsolve.numbers.decimals import fixed_digits

        try:
            return _plain(Decimal(fixed_digits(x, figures)))
        except PrecisionError:
            return "0" if x.contains(0) else f"≈{rounded(float(x.mid()), 1)}"
    context = Context(prec=figures, rounding=ROUND_HALF_EVEN)
    exact = Fraction(x)
    return _plain(context.divide(Decimal(exact.numerator), Decimal(exact.denominator)))


def spoken(x: Any, unit: str, figures: int = FIGURES) -> str:
    """A value in SI with the unit that people use for its size.

    >>> spoken(70, "m/s"), spoken(12500, "kg"), spoken(Fraction(16, 10**4), "s"), spoken(Fraction(5, 2), "Hz")
    ('252 km/h', '12.5 t', '1.6 ms', '2.5 Hz')
    """
    value, other = in_spoken(x, unit)
    return f"{rounded(value, figures)} {other}".strip()


def beside(x: Any, unit: str, figures: int = FIGURES) -> str:
    """The value in its unit, and in the one that people use where that is another: "70 m/s (252 km/h)"."""
    own = f"{rounded(x, max(figures, 6))} {unit}".strip()
    other = spoken(x, unit, figures)
    return own if said_in(x, unit) == unit or not x else f"{own} ({other})"


def said_in(x: Any, unit: str) -> str:
    """The unit in which a value in `unit` is said."""
    size = abs(float(x)) if not isinstance(x, Fraction) else abs(x)
    return next((other for least, other in _SPOKEN.get(unit, ()) if size >= least), unit)


def decimal(x: Fraction) -> str:
    """The exact decimal of x, or its ratio where it has none.

    >>> decimal(Fraction(1813, 2)), decimal(Fraction(1, 3))
    ('906.5', '1/3')
    """
    rest, places = x.denominator, 0
    while rest % 10 == 0 or rest % 5 == 0 or rest % 2 == 0:
        rest = rest // 10 if rest % 10 == 0 else rest // 5 if rest % 5 == 0 else rest // 2
        places += 1
    if rest > 1:
        return str(x)
    digits = str(abs(x) * 10**places).rjust(places + 1, "0")
    sign = "-" if x < 0 else ""
    return sign + (f"{digits[:-places]}.{digits[-places:]}" if places else digits)


def in_spoken(x: Any, unit: str) -> tuple[Any, str]:
    """The value in the unit that people use, and that unit."""
    other = said_in(x, unit)
    return _times(x, other, unit), other


def _times(x: Any, other: str, unit: str) -> Any:
    if other == unit:
        return x
    ratio = factor(unit)[0] / factor(other)[0]
    if hasattr(x, "mid"):
        return x * ratio.numerator / ratio.denominator
    return Fraction(x) * ratio


def _plain(x: Decimal) -> str:
    """Without an exponent where that is short, and without zeros at the end of the decimals."""
    if not x:
        return "0"
    exponent = x.adjusted()
    digits = x.normalize()
    if -4 <= exponent < _EXPONENT:
        return f"{digits:f}"
    mantissa = f"{digits.scaleb(-exponent):f}"
    return f"{mantissa}e{exponent}"
