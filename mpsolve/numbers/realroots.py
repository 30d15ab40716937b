"""Signs of rational polynomials on the half-line y ≥ 0, decided exactly: FLINT isolates the real roots by proof."""

from __future__ import annotations

from fractions import Fraction
from itertools import pairwise

from flint import arb, fmpq, fmpq_poly, fmpz_poly

from mpsolve.errors import PrecisionError
from mpsolve.numbers.balls import complex_roots
from mpsolve.numbers.packed import dyadic


def as_fmpq(x: Fraction) -> fmpq:
    return fmpq(x.numerator, x.denominator)


def sign_at(f: fmpq_poly, x: Fraction) -> int:
    """−1, 0 or 1, exactly."""
    value = f(as_fmpq(x))
    return int(value > 0) - int(value < 0)


def positive_roots(f: fmpq_poly) -> list[tuple[arb, int]]:
    """The roots y > 0 of f ≠ 0 in ascending order, as disjoint balls, each with its multiplicity."""
    found = []
    for ball in _roots(f):
        _, factors = f.numer().factor_squarefree()
        found.append((ball, next(power for factor, power in factors if _vanishes_in(factor, ball))))
    return found


def samples(f: fmpq_poly) -> list[Fraction]:
    """A rational point in each open interval between 0, the positive roots of f ≠ 0, and infinity."""
    roots = _roots(f)
    if not roots:
        return [Fraction(1)]
    ends = [(Fraction(0), Fraction(0)), *((end_of(ball, -1), end_of(ball, 1)) for ball in roots)]
    return [short_between(below[1], above[0]) for below, above in pairwise(ends)] + [
        short_between(ends[-1][1], 4 * ends[-1][1])
    ]


def is_positive(f: fmpq_poly) -> bool:
    """Whether f > 0 for every y ≥ 0."""
    coefficients = f.coeffs()
    if not coefficients or not coefficients[0] > 0:
        return False
    return all(c >= 0 for c in coefficients) or not _roots(f)


def negative_point(f: fmpq_poly) -> Fraction | None:
    """A rational y > 0 with f(y) < 0, or None where f ≥ 0 for all y ≥ 0."""
    if all(c >= 0 for c in f.coeffs()):
        return None
    return next((y for y in samples(f) if sign_at(f, y) < 0), None)


def _roots(f: fmpq_poly) -> list[arb]:
    """Disjoint balls of the positive roots, all to the right of 0, each with one root of the radical of f."""
    g = f.numer()
    while g[0] == 0:
        g = g.right_shift(1)
    if all(c >= 0 for c in g.coeffs()) or all(c <= 0 for c in g.coeffs()):
        return []
    g = g // g.gcd(g.derivative())
    roots = (root for root, _ in complex_roots(g * fmpz_poly([0, 1])))
    real = [arb(root.real) for root in roots if root.imag == 0 and root.real != 0]
    if any(not (ball > 0 or ball < 0) for ball in real):
        raise PrecisionError("real roots are not told apart from 0: this stands against what FLINT promises")
    return sorted((ball for ball in real if ball > 0), key=lambda ball: end_of(ball, 0))


def _vanishes_in(factor: fmpz_poly, ball: arb) -> bool:
    """Whether the squarefree factor has the one root of the radical that lies in the ball."""
    low, high = end_of(ball, -1), end_of(ball, 1)
    if low == high:
        return sign_at(fmpq_poly(factor), low) == 0
    return sign_at(fmpq_poly(factor), low) * sign_at(fmpq_poly(factor), high) <= 0


def short_between(low: Fraction, high: Fraction) -> Fraction:
    """A short dyadic number near the middle of an interval."""
    unit = Fraction(1)
    while unit * 4 > high - low:
        unit /= 2
    while unit * 16 < high - low:
        unit *= 2
    return round((low + high) / 2 / unit) * unit


def end_of(ball: arb, side: int) -> Fraction:
    """The middle (side 0) or an end of a ball, exactly."""
    return dyadic(ball.mid()) + side * dyadic(ball.rad())
