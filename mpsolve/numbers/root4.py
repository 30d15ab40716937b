"""Fourth roots of rationals: those that are rational, and the others in so many digits or bits."""

from __future__ import annotations

import math
from decimal import MAX_EMAX, MIN_EMIN, ROUND_HALF_EVEN, Context, Decimal
from fractions import Fraction
from typing import Any

_GUARD_BITS, _GUARD_DIGITS = 20, 6


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


def raw_root(signed: Fraction, rational: Fraction | None, precision: int) -> Any:
    """The same as an mpmath raw number of `precision` bits, within one unit in the last place."""
    from mpmath import libmp  # costs as much at start as the rest of this package

    if rational is not None:
        return libmp.from_rational(rational.numerator, rational.denominator, precision, "n")
    fine = precision + _GUARD_BITS
    size = libmp.from_rational(abs(signed.numerator), signed.denominator, fine)
    root = libmp.mpf_nthroot(size, 4, fine)
    return libmp.mpf_pos(libmp.mpf_neg(root) if signed < 0 else root, precision, "n")
