"""Velocities as algebraic numbers: those at which a polynomial in v vanishes, exactly within a range."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass
from fractions import Fraction
from typing import Any, TypeVar

from flint import arb, fmpq_poly, fmpz_poly

from mpsolve.errors import ContradictionError, PrecisionError
from mpsolve.numbers.balls import precision, rational_ball
from mpsolve.numbers.exact import Exact
from mpsolve.proof.ladder import climb
from mpsolve.waves.algebraic import Algebraic, real_roots

T = TypeVar("T")

_MOST_BITS = 1 << 14


@dataclass(frozen=True)
class Place:
    """A velocity: its square w, and x, which is w itself for ω = 0 and v else."""

    w: Algebraic
    x: Algebraic

    def velocity(self, bits: int) -> Any:
        with precision(bits):
            return self.w.ball(bits).sqrt()

    @property
    def exact(self) -> Exact | None:
        """v where its square or its fourth power is rational, v > 0."""
        m = self.w.m
        if m.degree() == 1:
            return Exact.sqrt(-Fraction(int(m[0]), int(m[1])))
        if m.degree() == 2 and not m[1]:
            return Exact.root4(-Fraction(int(m[0]), int(m[2])))
        return None

    def annuls(self, f: fmpq_poly) -> bool:
        """Whether f(x) is 0."""
        return not f % fmpq_poly(self.x.m)


def still() -> Place:
    """v = 0."""
    zero = Algebraic(fmpz_poly([0, 1]), 0)
    return Place(zero, zero)


def places_of(f: fmpq_poly, squared: bool, low: Fraction, high: Fraction, bits: int) -> Iterator[tuple[Place, int]]:
    """The roots v > 0 of f in low ≤ v ≤ high, with their multiplicities; f is over v², or even or odd in v."""
    if not f or f.degree() == 0:
        return
    _, factors = (f if squared else _in_squares(f)).numer().factor()
    for m, power in factors:
        for k, ball in _real(m, bits):
            w = Algebraic(m, k)
            if ball > 0 and _inside(w, low, high, bits):
                yield Place(w, w if squared else _square_root(w)), power


def _real(m: fmpz_poly, bits: int) -> list[tuple[int, arb]]:
    """The roots with their numbers, all but 0 told apart from 0."""

    def apart(bits: int) -> list[tuple[int, arb]] | None:
        found = real_roots(m, bits)
        return list(enumerate(found)) if all(ball > 0 or ball < 0 or not m[0] for ball in found) else None

    return _told(apart, bits, "a root that is not 0 is not told apart from 0")


def _inside(w: Algebraic, low: Fraction, high: Fraction, bits: int) -> bool:
    """Whether low² ≤ w ≤ high², exactly: an irrational number meets neither."""
    if w.m.degree() == 1:
        exact = -Fraction(int(w.m[0]), int(w.m[1]))
        return low**2 <= exact <= high**2

    def between(bits: int) -> bool | None:
        ball, least, most = w.ball(bits), rational_ball(low**2), rational_ball(high**2)
        return True if least < ball < most else False if ball < least or most < ball else None

    return _told(between, bits, "an irrational velocity is not told apart from an end")


def _told(attempt: Callable[[int], T | None], bits: int, fault: str) -> T:
    """What is told with so many bits, or more; the fault is that nothing is."""

    def tried(bits: int) -> T:
        found = attempt(bits)
        if found is None:
            raise PrecisionError(fault)
        return found

    try:
        return climb(tried, bits, _MOST_BITS * 4)
    except PrecisionError as error:
        raise ContradictionError(f"{error}: please report this as a fault") from None


def _in_squares(f: fmpq_poly) -> fmpq_poly:
    """g with f(v) = v^k g(v²)."""
    coefficients = f.coeffs()
    first = next(k for k, c in enumerate(coefficients) if c)
    if any(coefficients[first + 1 :: 2]):
        raise ContradictionError("the two directions of the force differ: please report this as a fault")
    return fmpq_poly(coefficients[first::2])


def _square_root(w: Algebraic) -> Algebraic:
    """√w among the roots of the factors of m(x²)."""
    spread = [0] * (2 * w.m.degree() + 1)
    spread[::2] = [int(c) for c in w.m.coeffs()]
    _, factors = fmpz_poly(spread).factor()

    def only(bits: int) -> Algebraic:
        root = w.ball(bits).sqrt()
        each = ((m, k, ball) for m, _ in factors for k, ball in enumerate(real_roots(m, bits)))
        near = [Algebraic(m, k) for m, k, ball in each if ball.overlaps(root)]
        if len(near) != 1:
            raise PrecisionError("the square root of an algebraic number is not told apart from others")
        return near[0]

    return climb(only, 64, _MOST_BITS)
