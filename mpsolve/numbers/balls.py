"""Balls (flint.arb, flint.acb): the one place where flint's precision is set, and the arithmetic of proofs.

flint has one precision for the whole process: whoever computes with balls does so inside `precision(bits)`, and a
second thread waits. So does the verifier, which shares no code but takes the same lock.
"""

from __future__ import annotations

import threading
from collections.abc import Iterable, Iterator, Sequence
from contextlib import contextmanager
from fractions import Fraction
from functools import lru_cache, reduce
from typing import Any, cast

import flint
from flint import acb as acb
from flint import acb_mat as acb_mat
from flint import acb_poly as acb_poly
from flint import arb as arb
from flint import arb_mat as arb_mat

from mpsolve.errors import PrecisionError

_lock = vars(flint).setdefault("_precision_lock", threading.RLock())
_THIN = 30


@contextmanager
def precision(bits: int) -> Iterator[None]:
    """Balls are computed with this many bits inside the block; what was set before is put back after it."""
    with _lock:
        before = flint.ctx.prec
        flint.ctx.prec = bits
        try:
            yield
        finally:
            flint.ctx.prec = before


def bits_now() -> int:
    """The precision that is set."""
    return int(flint.ctx.prec)


@contextmanager
def terms(number: int) -> Iterator[None]:
    """Power series may have so many terms inside the block; what was set before is put back after it."""
    with _lock:
        before = flint.ctx.cap
        flint.ctx.cap = max(number, before)
        try:
            yield
        finally:
            flint.ctx.cap = before


def rational_ball(x: Fraction) -> Any:
    """The real ball of a rational, at the precision that is set."""
    return arb(flint.fmpq(x.numerator, x.denominator))


def complex_roots(f: flint.fmpz_poly | flint.fmpq_poly) -> list[tuple[acb, int]]:
    """Disjoint balls of all roots, those of real ones real, and their multiplicities."""
    return cast("list[tuple[acb, int]]", f.complex_roots())


def square(radius: Any) -> acb:
    """The square ball round 0 that holds the disc of this radius; radius: arb ≥ 0."""
    side = arb(0, radius.upper() if isinstance(radius, arb) else radius)
    return acb(side, side)


def least(values: Iterable[Any]) -> Any:
    """A real ball that holds the least of what these balls hold."""
    return reduce(arb.min, values)


def greatest(values: Iterable[Any]) -> Any:
    """A real ball that holds the greatest."""
    return reduce(arb.max, values)


def exact_ball(z: complex) -> acb:
    """A float as an exact complex ball."""
    return acb(z.real, z.imag)


def is_exact(z: acb) -> bool:
    """Whether the complex ball is a point."""
    return bool(z.real.is_exact() and z.imag.is_exact())


def is_thin(z: acb) -> bool:
    """Whether the ball is a point, or so small that it does not matter how often a formula names it."""
    return is_exact(z) or bool(z.rel_accuracy_bits() > _THIN)


class Balls:
    """The arithmetic of complex balls, at the precision that is set; matrices are acb_mat.

    An operation that balls cannot decide raises `PrecisionError`.
    """

    def number(self, x: Fraction) -> Any:
        return _number(x, bits_now())

    def evaluate(self, coefficients: Sequence[Fraction], z: Any) -> Any:
        """Σ c_j z^j, about the midpoint of z, so that a wide z costs no more than its width."""
        z = acb(z)
        row = _row(tuple(coefficients), bits_now())
        if len(coefficients) < 2 or is_exact(z):
            return row(z)
        middle = z.mid()
        return row(acb_poly([middle, 1]))(z - middle)

    def matrix(self, rows: Sequence[Sequence[Any]]) -> acb_mat:
        return acb_mat([list(row) for row in rows]) if len(rows) else acb_mat(0, 0)

    def times(self, a: Any, factor: Any) -> Any:
        return a * acb(factor)

    def product(self, a: Any, b: acb_mat) -> Any:
        return a * b

    def exp(self, a: Any) -> Any:
        return a.exp()

    def solve(self, a: Any, b: acb_mat) -> Any:
        try:
            return a.solve(b)
        except ZeroDivisionError:
            raise PrecisionError(
                "a matrix of balls may be singular: split the piece or raise the precision"
            ) from None

    def entry(self, a: Any, i: int, j: int) -> Any:
        return a[i, j]

    def det(self, a: Any) -> Any:
        return a.det()


@lru_cache(maxsize=4096)
def _number(x: Fraction, bits: int) -> Any:  # noqa: ARG001 — part of the key
    return rational_ball(x)


@lru_cache(maxsize=4096)
def _row(coefficients: tuple[Fraction, ...], bits: int) -> acb_poly:  # noqa: ARG001 — part of the key
    return acb_poly([rational_ball(c) for c in coefficients])
