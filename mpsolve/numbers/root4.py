"""Fourth roots of rationals: those that are rational, and the others in so many digits."""

from __future__ import annotations

import math
from decimal import MAX_EMAX, MIN_EMIN, ROUND_HALF_EVEN, Context, Decimal
from fractions import Fraction

_GUARD_DIGITS = 6


def rational_root(signed: Fraction) -> Fraction | None:
    """The rational x with x|x|³ = `signed`, or None if there is none."""
    numerator, denominator = _integer_root(abs(signed.numerator)), _integer_root(signed.denominator)
    if numerator is None or denominator is None:
        return None
    return Fraction(-numerator if signed < 0 else numerator, denominator)


def _integer_root(n: int) -> int | None:
    """The integer r ≥ 0 with r⁴ = n, or None if n ≥ 0 is no perfect fourth power."""
    root = math.isqrt(math.isqrt(n))
    return root if root**4 == n else None


def decimal_root(signed: Fraction, rational: Fraction | None, digits: int) -> Decimal:
    """The x with x|x|³ = `signed`, which is `rational` if that is given, to one unit in the last of the digits."""
    context = Context(prec=digits + _GUARD_DIGITS, rounding=ROUND_HALF_EVEN, Emax=MAX_EMAX, Emin=MIN_EMIN)
    exact = abs(signed) if rational is None else rational
    near = context.divide(Decimal(exact.numerator), Decimal(exact.denominator))
    if rational is not None:
        return near
    near = context.sqrt(context.sqrt(near))
    return near.copy_negate() if signed < 0 else near
