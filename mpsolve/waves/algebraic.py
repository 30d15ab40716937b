"""Polynomials at an algebraic velocity: multiple roots and common roots exactly, their places in balls.

The velocity is a root of an irreducible polynomial m; numbers of the field are polynomials modulo m, so that equality
is decided. Balls come in last, where all roots are simple and precision alone tells them apart.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from fractions import Fraction
from functools import lru_cache
from typing import Any

from flint import fmpq_poly, fmpz_poly

from mpsolve.errors import PrecisionError
from mpsolve.numbers.balls import acb, acb_poly, arb, complex_roots, precision
from mpsolve.numbers.realroots import end_of
from mpsolve.proof.ladder import climb

_MOST_BITS = 1 << 14
_STEPS = 40  # of interval Newton, each of which doubles the digits


@dataclass(frozen=True)
class Algebraic:
    """The real root number `index`, in ascending order, of the irreducible m."""

    m: fmpz_poly
    index: int

    def ball(self, bits: int) -> Any:
        """A ball of about this many bits; a rational number is as exact as they allow."""
        return real_roots(self.m, bits)[self.index]


def real_roots(m: fmpz_poly, bits: int) -> tuple[arb, ...]:
    """All real roots of an irreducible polynomial in ascending order, as disjoint balls of about this many bits."""
    return _real_roots(tuple(int(c) for c in m.coeffs()), bits)


@lru_cache(maxsize=256)
def _real_roots(coefficients: tuple[int, ...], bits: int) -> tuple[arb, ...]:
    with precision(bits):
        return tuple(_isolated_reals(fmpz_poly(list(coefficients))))


def _isolated_reals(m: fmpz_poly) -> list[arb]:
    if m.degree() == 1:
        return [arb(-m[0]) / arb(m[1])]
    found = [arb(root.real) for root, _ in complex_roots(m) if root.imag == 0]
    return sorted(found, key=middle)


def middle(ball: Any) -> Fraction:
    """The middle of a ball, exactly: balls that are apart are in the order of their middles."""
    return end_of(ball, 0)


def trimmed(a: Sequence[fmpq_poly], m: fmpq_poly) -> list[fmpq_poly]:
    """The coefficients modulo m, without leading zeros."""
    out = [c % m for c in a]
    while out and not out[-1]:
        out.pop()
    return out


def monic(a: list[fmpq_poly], m: fmpq_poly) -> list[fmpq_poly]:
    _, inverse, _ = a[-1].xgcd(m)
    return trimmed([c * inverse for c in a], m)


def divided(a: list[fmpq_poly], b: list[fmpq_poly], m: fmpq_poly) -> tuple[list[fmpq_poly], list[fmpq_poly]]:
    """Quotient and rest by a monic b."""
    rest, quotient = list(a), [fmpq_poly([])] * max(len(a) - len(b) + 1, 0)
    while len(rest) >= len(b):
        shift, top = len(rest) - len(b), rest[-1]
        quotient[shift] = top
        for k, c in enumerate(b):
            rest[shift + k] = rest[shift + k] - top * c
        rest = trimmed(rest, m)
    return quotient, rest


def common(a: list[fmpq_poly], b: list[fmpq_poly], m: fmpq_poly) -> list[fmpq_poly]:
    """The monic greatest common divisor; [1] where the roots differ, [] of zeros."""
    while b:
        b = monic(b, m)
        a, b = b, divided(a, b, m)[1]
    return monic(a, m) if a else a


def slope(a: Sequence[fmpq_poly]) -> list[fmpq_poly]:
    """The derivative."""
    return [k * c for k, c in enumerate(a)][1:]


def multiple_roots(a: Sequence[fmpq_poly], m: fmpq_poly) -> list[fmpq_poly]:
    """The monic polynomial with each multiple root of a ≠ 0 once; [1] where there is none."""
    given = trimmed(a, m)
    twice = common(given, trimmed(slope(given), m), m)
    return divided(twice, common(twice, trimmed(slope(twice), m), m), m)[0]


def split(a: list[fmpq_poly], b: Sequence[fmpq_poly], m: fmpq_poly) -> tuple[list[fmpq_poly], list[fmpq_poly]]:
    """The part of a squarefree monic a that shares its roots with b, and the rest."""
    shared = common(a, trimmed(b, m), m)
    return shared, divided(a, shared, m)[0]


def places(a: list[fmpq_poly], at: Algebraic, bits: int) -> list[arb]:
    """The real roots of a squarefree polynomial over the field as balls, ascending; PrecisionError if not apart."""
    if len(a) < 2:
        return []

    def apart(bits: int) -> list[arb]:
        try:
            roots = isolated(embedded(a, at.ball(bits)))
        except ValueError:
            roots = []
        if not roots or not all(_decided(root, roots) for root in roots):
            raise PrecisionError(f"roots over an algebraic velocity are not told apart at {_MOST_BITS} bits")
        return sorted((arb(root.real) for root in roots if root.imag.contains(0)), key=middle)

    return climb(apart, bits, _MOST_BITS)


def embedded(a: Sequence[fmpq_poly], x: arb) -> acb_poly:
    """The polynomial in balls at the ball x of the velocity."""
    return acb_poly([fmpq_value(c, x) for c in a])


def fmpq_value(c: fmpq_poly, x: arb) -> arb:
    """c(x) in balls."""
    out = arb(0)
    for coefficient in reversed(c.coeffs()):
        out = out * x + arb(coefficient)
    return out


def isolated(f: Any) -> list[acb]:
    """All roots of a polynomial in balls, each as sharp as they allow; ValueError where they are not apart.

    Each ball holds one root, and a step of interval Newton keeps it.
    """
    across = f.derivative()
    return [_sharpened(f, across, root) for root in f.roots()]


def _sharpened(f: Any, across: acb_poly, root: acb) -> acb:
    for _ in range(_STEPS):
        bend = across(root)
        if bend.contains(0):
            break
        at = root.mid()
        step = at - f(at) / bend
        real, imag = step.real.intersection(root.real), step.imag.intersection(root.imag)
        root, before = acb(real, imag), root
        if not 2 * (root.real.rad() + root.imag.rad()) < before.real.rad() + before.imag.rad():
            break
    return root


def _decided(root: acb, roots: list[acb]) -> bool:
    """Whether the root is not real, or real because its conjugate can be no other."""
    if not root.imag.contains(0):
        return True
    return sum(bool(root.conjugate().overlaps(other)) for other in roots) == 1
