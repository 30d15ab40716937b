"""First-order Taylor pieces with a remainder, in float64 arrays: rigorous, vectorised over discs of one variable.

A `Jet` stands for functions f(t) on |t| ≤ r, a disc for each leading index: |f(t) − a − b t| ≤ e. The operations
+, −, ×, ÷ are correctly rounded; |z| and powers are taken to err by a few units in the last place. What they lose is
added to e with a wide margin. What cannot be bounded has e = ∞ or nan, and no comparison with it proves anything.

Complex operations, in units U of |result|: a product loses √5, with or without fused steps; a quotient by Smith's
method 6.5. Where a result underflows, the loss is below TINY. A sum of non-negative floats with less than 2¹² terms
loses a factor that `UP` covers, so bounds themselves are rounded as they come and then multiplied by UP.
"""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction
from typing import Any

import numpy as np

from mpsolve.errors import PrecisionError
from mpsolve.frozen import frozen
from mpsolve.numbers.arrays import Integers, Reals

U = 2.0**-53
"""Unit roundoff."""
UP = 1 + 2.0**-40
"""Covers the rounding of a sum of products of non-negative floats of a few hundred terms."""
TINY = 1e-290
"""Covers underflow: far above the least normal float, so that what is above it keeps its relative precision."""
_RANGE = 2.0**800
_WIDEST = 64.0
_TERMS = 16  # of the exponential series on |z| ≤ 1/2: the rest is below 2^−60


def nearest(x: Fraction) -> float:
    """The float nearest to an exact number, so within U of it relatively; PrecisionError where none is."""
    if x and not 1 / _RANGE <= abs(x) <= _RANGE:
        raise PrecisionError(f"the problem holds a number of the order 2^{_order(x)} in the units it is computed in")
    return float(x)


def _order(x: Fraction) -> int:
    return int(x.numerator).bit_length() - int(x.denominator).bit_length()


def powers_up_to(x: Reals, n: int) -> Reals:
    """1, x, …, x^(n−1) of bounds x ≥ 0 along a new last axis, from above (times UP) even where they underflow."""
    out = np.maximum(np.asarray(x)[..., None] ** np.arange(n), TINY)
    out[..., 0] = 1
    return out


@frozen
class Jet:
    """a, b: complex arrays; e ≥ 0: real array; r: radii, one for each leading index."""

    a: Any
    b: Any
    e: Any
    r: Any

    __array_ufunc__ = None

    @property
    def _r(self) -> Any:
        return self.r.reshape(self.r.shape + (1,) * (np.ndim(self.a) - 1))

    @property
    def size(self) -> Any:
        """An upper bound of |f|."""
        return (np.abs(self.a) + np.abs(self.b) * self._r + self.e) * UP

    def __getitem__(self, key: Any) -> Jet:
        """Along the axes after the leading one: jet[:, key]."""
        return Jet(self.a[key], self.b[key], self.e[key], self.r)

    def take(self, rows: Integers) -> Jet:
        """The discs with these leading indices."""
        return Jet(self.a[rows], self.b[rows], self.e[rows], self.r[rows])

    def taken(self, numbers: Any) -> Jet:
        """Along the last axis."""
        a, b, e = (np.take(x, numbers, -1) for x in (self.a, self.b, self.e))
        return Jet(a, b, e, self.r)

    def __neg__(self) -> Jet:
        return Jet(-self.a, -self.b, self.e, self.r)

    @np.errstate(all="ignore")
    def __add__(self, other: Any) -> Jet:
        a, b, e = (other.a, other.b, other.e) if isinstance(other, Jet) else (other, 0.0, 0.0)
        a, b = self.a + a, self.b + b
        r = self._r
        return Jet(a, b, (self.e + e + 2 * U * (np.abs(a) + np.abs(b) * r)) * UP + TINY, self.r)

    @np.errstate(all="ignore")
    def __mul__(self, other: Any) -> Jet:
        r = self._r
        if not isinstance(other, Jet):  # a number that is meant exactly up to 2 u
            size = np.abs(other)
            a, b = self.a * other, self.b * other
            return Jet(a, b, (self.e * size + 8 * U * (np.abs(a) + np.abs(b) * r)) * UP + TINY, self.r)
        a0, a1, b0, b1 = np.abs(self.a), np.abs(self.b), np.abs(other.a), np.abs(other.b)
        a, b = self.a * other.a, self.a * other.b + self.b * other.a
        e = a1 * b1 * (r * r) + (a0 + a1 * r) * other.e + (b0 + b1 * r + other.e) * self.e
        e = e + 8 * U * (a0 * b0 + (a0 * b1 + a1 * b0) * r)
        return Jet(a, b, e * UP + TINY, self.r)

    @np.errstate(all="ignore")
    def __matmul__(self, other: Jet) -> Jet:
        """Products of matrices: shapes (discs, n, k) and (discs, k, m)."""
        r = self._r
        a0, a1, b0, b1 = np.abs(self.a), np.abs(self.b) * r, np.abs(other.a), np.abs(other.b) * r
        a, b = self.a @ other.a, self.a @ other.b + self.b @ other.a
        lost = 16 * (self.a.shape[2] + 4) * U
        e = a1 @ b1 + (a0 + a1) @ other.e + self.e @ (b0 + b1 + other.e) + lost * ((a0 + a1) @ (b0 + b1))
        return Jet(a, b, e * UP + TINY, self.r)

    def inverse(self) -> Jet:
        """1/f; not bounded where f may vanish."""
        r = self._r
        with np.errstate(all="ignore"):
            c = 1 / self.a  # 1/(a + δ) = c − δ c² + c y²/(1 − y), |δ c| ≤ y; c loses 6.5 U, b 18 U
            b = -self.b * c * c
            size = np.abs(c) * (1 + 16 * U)
            y = (np.abs(self.b) * r + self.e) * size * UP
            e = size * (y * y / (1 - y) + self.e * size + 24 * U * (1 + y)) * UP + TINY
            e = np.where(y < 0.9, e, np.inf)
        return Jet(c, b, e, self.r)

    def exp(self) -> Jet:
        """e^f; not bounded where f varies by more than _WIDEST over the disc."""
        r = self._r
        with np.errstate(all="ignore"):
            value, relative = exponential(self.a)
            size = np.abs(value)
            y = (np.abs(self.b) * r + self.e) * UP
            beyond = y * y * (0.5 + 0.22 * y)  # e^y − 1 − y ≤ y²/2 + 0.22 y³ for y ≤ 1
            wide = y > 1
            if wide.any():  # a wave from far away: it may be weak all the same
                power, lost = exponential(np.where(wide & (y <= _WIDEST), y, 0.0))
                beyond = np.where(wide, power * (1 + lost), beyond)
            e = size * (self.e + beyond + (relative + 8 * U) * (1 + y)) * UP + TINY
            e = np.where((y <= _WIDEST) & np.isfinite(size), e, np.inf)
        return Jet(value, value * self.b, e, self.r)

    @np.errstate(all="ignore")
    def sum(self, axis: int) -> Jet:
        """Along an axis after the leading one."""
        terms = self.a.shape[axis]
        a, b = self.a.sum(axis), self.b.sum(axis)
        r = self.r.reshape(self.r.shape + (1,) * (a.ndim - 1))
        lost = (np.abs(self.a)).sum(axis) + (np.abs(self.b)).sum(axis) * r
        return Jet(a, b, (self.e.sum(axis) + 2 * terms * U * lost) * UP + TINY * bool(terms), self.r)


def joined(parts: Sequence[Jet], axis: int = -1) -> Jet:
    """Side by side along an axis after the leading one."""
    a, b, e = (np.concatenate([getattr(part, key) for part in parts], axis) for key in "abe")
    return Jet(a, b, e, parts[0].r)


def exponential(z: Any) -> tuple[Any, Reals]:
    """(e^z, a bound of its relative error where it is above TINY) from + − × ÷ alone, by halving and squaring.

    Horner's scheme: each step loses (√5 + 2) U |value w/k| + U |value|, at the end 7 U, so 12 U of |e^w| ≥ e^(−1/2).
    A squaring doubles it and adds √5 U: after n of them below 14.3·2ⁿ U, an eighth of the bound 2ⁿ·2⁻⁴⁶.
    """
    size = np.max(np.abs(z), initial=0.5, where=np.isfinite(z))
    steps = int(min(np.ceil(np.log2(size)) + 1, 40))  # 0 or more, as size ≥ 1/2
    w = z * 2.0**-steps
    good = np.abs(w) <= 0.5
    value = np.ones_like(w)
    for k in range(_TERMS, 0, -1):
        value = 1 + value * w / k
    for _ in range(steps):
        value = value * value
    return value, np.where(good, 2.0 ** (steps - 46), np.inf)
