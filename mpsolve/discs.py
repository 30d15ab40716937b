"""Arrays of complex discs in float64: rigorous, vectorised, for proofs that need thousands of enclosures.

A `Discs` holds midpoints `m` (complex128) and radii `r` ≥ 0, and each operation returns discs that hold every
result. Only IEEE operations +, −, ×, ÷, √ are used, each of which is rounded correctly; what they lose is added to
the radius with a wide margin (`_EPS` is 32 units of roundoff). A result that cannot be bounded has r = ∞, never a
finite radius about a middle that is not finite, and never nan: `np.isfinite(z.r)` tells what is bounded.
"""

from __future__ import annotations

from math import hypot
from typing import Any

import numpy as np

from mpsolve.dual import Dual
from mpsolve.fields import laplace_det
from mpsolve.numbers.exact import Exact

_EPS = 2.0**-48
_UP = 1 + _EPS
_SMALL = 1e-150  # covers what underflow loses of |m|, where squares are below the normal numbers
_TINY = 1e-130  # the same of a result; no smaller number counts as proved to be away from 0
_TERMS = 16  # of the exponential series on |z| ≤ 1/2: the rest is below 2^−60


class Discs:
    """Discs of one shape. Combines with other discs, and with numbers or arrays that are meant exactly."""

    __array_ufunc__ = None  # numpy arrays leave operators to this class
    __slots__ = ("_size", "m", "r")

    def __init__(self, m: Any, r: Any = 0.0) -> None:
        self.m, self._size = np.asarray(m, dtype=complex), None
        r = np.fmin(np.asarray(r, dtype=float), np.inf)  # nan becomes ∞
        finite = np.isfinite(self.m)
        self.r = r if finite.all() else np.where(finite, r, np.inf)

    @property
    def size(self) -> Any:
        """An upper bound of |m|."""
        if self._size is None:
            self._size = _modulus(self.m)
        return self._size

    @property
    def upper(self) -> Any:
        """An upper bound of |z| over the disc."""
        return (self.size + self.r) * _UP

    @property
    def lower(self) -> Any:
        """A lower bound of |z| over the disc, 0 if it may hold 0."""
        # in this form it is nan, which proves nothing, where the square of |m| overflows
        return np.maximum(self.size - (self.size * (4 * _EPS) + self.r + _TINY), 0.0)

    def nonzero(self) -> Any:
        """True where the disc does not hold 0."""
        return self.lower > 0

    def __getitem__(self, key: Any) -> Discs:
        return _disc(self.m[key], np.broadcast_to(self.r, self.m.shape)[key])

    def __neg__(self) -> Discs:
        return _disc(-self.m, self.r)

    def __add__(self, other: Any) -> Any:
        if isinstance(other, Dual):
            return NotImplemented
        if isinstance(other, Discs):
            m = self.m + other.m
            return _disc(m, (self.r + other.r) * _UP + _modulus(m) * _EPS)
        m = self.m + other
        return _disc(m, self.r * _UP + _modulus(m) * _EPS)

    __radd__ = __add__

    def __sub__(self, other: Any) -> Any:
        return self + -other

    def __rsub__(self, other: Any) -> Any:
        return -self + other

    def __mul__(self, other: Any) -> Any:
        if isinstance(other, Dual):
            return NotImplemented
        a = self.size
        if isinstance(other, Discs):
            b = other.size
            r = (a * other.r + b * self.r + self.r * other.r) * _UP
            return _disc(self.m * other.m, r + (a * b * _EPS + _TINY))
        size = _modulus(other)
        # a·size overflows where the product of the middles may: a·_EPS·size would not
        return _disc(self.m * other, self.r * (size * _UP) + (a * size * _EPS + _TINY))

    __rmul__ = __mul__

    def inverse(self) -> Discs:
        """1/z: radius ∞ where the disc may hold 0."""
        with np.errstate(all="ignore"):
            square = self.m.real * self.m.real + self.m.imag * self.m.imag
            far, near = self.size * (1 - 4 * _EPS), self.lower
            r = self.r / (far * near) * (1 + 4 * _EPS) + _EPS / far + _TINY
            good = near > 0
            return Discs(np.where(good, self.m.conj() / np.where(good, square, 1), 0), np.where(good, r, np.inf))

    def __truediv__(self, other: Any) -> Any:
        if isinstance(other, Dual):
            return NotImplemented
        return self * (other.inverse() if isinstance(other, Discs) else Discs(other).inverse())

    def __rtruediv__(self, other: Any) -> Any:
        return self.inverse() * other

    def sqrt(self) -> Discs:
        """A branch of √z that is continuous on each disc; radius ∞ where the disc may hold 0."""
        x, y, size = self.m.real, self.m.imag, self.size
        with np.errstate(all="ignore"):
            u = np.sqrt((size + np.abs(x)) / 2)
            v = np.abs(y) / (2 * np.where(u > 0, u, 1))
            sign = np.where(y < 0, -1.0, 1.0)
            m = np.where(x >= 0, u + 1j * sign * v, v + 1j * sign * u)
            root = np.sqrt(self.size)
            r = self.r / (root + np.sqrt(self.lower)) * (1 + 8 * _EPS) + 8 * _EPS * root + _TINY
        return Discs(m, np.where(self.lower > 0, r, np.inf))

    def exp(self) -> Discs:
        """e^z; radius ∞ where r > 1 or |z| > 2^20."""
        with np.errstate(all="ignore"):
            halvings = np.ceil(np.log2(np.fmax(self.size, 0.25))) + 1  # any number is right; this one is quick
            steps = int(min(np.max(halvings, initial=0), 21))
            z = self.m * 2.0**-steps
            value = np.ones_like(z)
            for k in range(_TERMS, 0, -1):
                value = 1 + value * z / k
            for _ in range(steps):
                value = value * value
            # Horner's scheme on |z| ≤ 1/2 keeps a relative error below 2^−46, and each squaring doubles it
            relative = 2.0 ** (steps - 46)
            size = _modulus(value)
            good = (self.r <= 1) & (_modulus(z) <= 0.5) & (size < 1e100)
            r = size * (self.r * (1 + self.r) * (1 + relative) + relative) * _UP + _TINY
            return Discs(np.where(good, value, 0), np.where(good, r, np.inf))


def _disc(m: Any, r: Any) -> Discs:
    """Without the conversions of the constructor. Where m is not finite, r must be ∞ or nan, which becomes ∞."""
    disc = Discs.__new__(Discs)
    disc.m, disc.r, disc._size = m, np.fmin(r, np.inf), None
    return disc


def _modulus(z: Any) -> Any:
    """An upper bound of |z| that is within a few roundings."""
    if isinstance(z, (int, float, complex)):
        return hypot(z.real, z.imag) * _UP + _SMALL  # ∞ where abs would raise an error
    x, y = z.real, z.imag
    return np.sqrt(x * x + y * y) * _UP + _SMALL


def where(condition: Any, yes: Discs, no: Discs) -> Discs:
    return _disc(np.where(condition, yes.m, no.m), np.where(condition, yes.r, no.r))


def exponential_quotient(w: Discs) -> Discs:
    """(e^w − 1)/w, entire in w."""
    close = w.upper <= 2
    m, series = np.where(close, w.m, 0), np.ones_like(w.m)
    for k in range(2 * _TERMS, 1, -1):
        series = 1 + series * m / k
    # |E'| ≤ e^{|w|}/2 and |E| ≤ e^{|w|}, with e^{|w|} ≤ e² < 7.4 where |w| ≤ 2
    near = Discs(series, np.where(close, 3.7 * w.r + 7.4 * 2.0**-44, np.inf))
    far = (w.exp() - 1) * w.inverse()
    return where(near.r < far.r, near, far)


class DiscField:
    """The arithmetic of `Discs`, for formulas that are written over a field."""

    pi = Discs(np.pi, 2.0**-50)
    i = Discs(1j)
    det = staticmethod(laplace_det)

    def number(self, value: Exact) -> Discs:
        """A disc that holds the exact value."""
        middle = float(value)
        return Discs(middle, abs(middle) * 2.0**-50 + _TINY)

    def one_minus_exp(self, z: Any, x: Any) -> Any:
        """(1 − e^{izx})/z, entire in z."""
        w = z * x * self.i
        return exponential_quotient(w) * x * -self.i

    def nearest_pair_first(self, z: Any) -> Any:
        """The roots as they are: `root_discs` has them in this order."""
        return z

    def choose(self, _: Any, apart: Any, bordered: Any) -> Any:
        """Of both the narrower disc, box by box; what is not bounded has radius ∞."""
        pairs = zip(apart(), bordered(), strict=True)
        return [where(~(second.r <= first.r), first, second) for first, second in pairs]  # nan loses


class DualField(DiscField):
    """Dual numbers over discs that are away from collisions of p-roots."""

    def one_minus_exp(self, z: Any, x: Any) -> Any:
        return (1 - (z * x * self.i).exp()) / z

    def choose(self, _: Any, apart: Any, _bordered: Any) -> Any:
        return apart()
