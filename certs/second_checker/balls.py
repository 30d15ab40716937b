"""Complex balls on Python's integers: a midpoint (a + ib)·2^e with an exact meaning, and a radius that only grows.

Every operation gives a ball that holds all results for numbers in the balls given. Radii are floats, each rounded up:
a handful of IEEE operations on numbers ≥ 0 err by less than the factor 1 + 2^−45, and by less than 10^−300 if tiny.
"""

from __future__ import annotations

from fractions import Fraction
from math import ldexp, sqrt

MORE, LESS, TINY = 1 + 2.0**-45, 1 - 2.0**-45, 1e-300
bits = 64
"""The working precision. `set_bits` changes it."""


class UnclearError(ArithmeticError):
    """A ball is too wide to tell."""


def set_bits(number: int) -> int:
    """Set the precision; the one before comes back."""
    global bits
    before, bits = bits, number
    return before


def up(x: float) -> float:
    """A bound for the exact value whose float computation gave x ≥ 0."""
    return x * MORE + TINY


def size(a: int, b: int, e: int) -> float:
    """|a + ib|·2^e up to the factors LESS and MORE."""
    k = max(a.bit_length(), b.bit_length()) - 200
    if k > 0:
        a, b, e = a >> k, b >> k, e + k  # an error below 2^-190 of the modulus
    x, y = float(a), float(b)
    try:
        return ldexp(sqrt(x * x + y * y), e)
    except OverflowError:
        raise UnclearError("a number is too large") from None


class Ball:
    """All complex numbers within r of (a + ib)·2^e."""

    __slots__ = ("a", "b", "e", "r")

    def __init__(self, a: int, b: int = 0, e: int = 0, r: float = 0.0) -> None:
        k = max(a.bit_length(), b.bit_length()) - bits
        if k > 0:
            a, b, e = a >> k, b >> k, e + k
            r = up(r + ldexp(1.5, e))
        self.a, self.b, self.e, self.r = a, b, e, r

    def upper(self) -> float:
        """A bound for all moduli."""
        return up(size(self.a, self.b, self.e) + self.r)

    def lower(self) -> float:
        """A number that no modulus is below; 0 if 0 may be in the ball."""
        return max(0.0, (size(self.a, self.b, self.e) * LESS - self.r * MORE) * LESS - TINY)

    def wide(self, r: float) -> Ball:
        """The ball of radius greater by r."""
        return Ball(self.a, self.b, self.e, up(self.r + r))

    def mid(self) -> Ball:
        """The midpoint alone."""
        return Ball(self.a, self.b, self.e)

    def conj(self) -> Ball:
        """The conjugate."""
        return Ball(self.a, -self.b, self.e, self.r)

    def real(self) -> Ball:
        """The real part."""
        return Ball(self.a, 0, self.e, self.r)

    def complex(self) -> complex:
        """The midpoint in floats, for guesses."""
        return (
            complex(ldexp(float(self.a >> k), self.e + k), ldexp(float(self.b >> k), self.e + k))
            if (k := max(0, max(self.a.bit_length(), self.b.bit_length()) - 200))
            else complex(ldexp(float(self.a), self.e), ldexp(float(self.b), self.e))
        )

    def sign(self) -> int:
        """The sign of the real part, or 0 if it cannot be told."""
        part = Ball(self.a, 0, self.e, self.r)
        return 0 if part.lower() <= 0 else (1 if self.a > 0 else -1)

    def __neg__(self) -> Ball:
        return Ball(-self.a, -self.b, self.e, self.r)

    def __add__(self, other: Ball) -> Ball:
        x, y = (self, other) if self.e >= other.e else (other, self)
        k = x.e - y.e
        r = up(self.r + other.r)
        if not (x.a or x.b):
            return Ball(y.a, y.b, y.e, r)
        if k > 3 * bits:  # y, of some bits, is far below what x resolves
            floor = x.e - 2 * bits
            return Ball(
                (x.a << 2 * bits) + (y.a >> floor - y.e),
                (x.b << 2 * bits) + (y.b >> floor - y.e),
                floor,
                up(r + ldexp(1.5, floor)),
            )
        return Ball((x.a << k) + y.a, (x.b << k) + y.b, y.e, r)

    def __sub__(self, other: Ball) -> Ball:
        return self + -other

    def __mul__(self, other: Ball) -> Ball:
        r = 0.0
        if self.r or other.r:
            x, y = size(self.a, self.b, self.e), size(other.a, other.b, other.e)
            r = up(up(x) * other.r + up(y) * self.r + self.r * other.r)
        a, b, c, d = self.a, self.b, other.a, other.b
        return Ball(a * c - b * d, a * d + b * c, self.e + other.e, r)

    def inverse(self) -> Ball:
        """1/self. Raises UnclearError if 0 may be in the ball."""
        low = self.lower()
        if not low > 0:
            raise UnclearError("a divisor may be 0")
        square = self.a * self.a + self.b * self.b
        k = bits + square.bit_length()
        a, b = (self.a << k) // square, (-self.b << k) // square
        r = ldexp(1.5, -k - self.e)
        if self.r:
            r = up(r + self.r / (low * low) * MORE)
        return Ball(a, b, -k - self.e, up(r))

    def __truediv__(self, other: Ball) -> Ball:
        return self * other.inverse()


ZERO, ONE = Ball(0), Ball(1)


def ball(x: Fraction | int, y: Fraction | int = 0) -> Ball:
    """x + iy."""
    out = []
    for part in (Fraction(x), Fraction(y)):
        n, d = part.numerator, part.denominator
        if d & (d - 1) == 0:
            out.append(Ball(n, 0, 1 - d.bit_length()))
        else:
            k = max(0, bits + d.bit_length() - n.bit_length() + 2)
            out.append(Ball((n << k) // d, 0, -k, up(ldexp(1.0, -k))))
    return out[0] + out[1] * Ball(0, 1) if out[1].a or out[1].r else out[0]


def from_complex(z: complex) -> Ball:
    """The float z, exactly."""
    return ball(Fraction(z.real), Fraction(z.imag))


def exp(z: Ball) -> Ball:
    """e^z: of z/2^k by its series, then squared k times."""
    if not z.upper() < 1e6:
        raise UnclearError("an exponent is too large")
    k = max(0, int(z.upper()).bit_length() + 8)
    before = set_bits(bits + k + 16)
    try:
        mid = Ball(z.a, z.b, z.e - k)
        out, term, n = ONE, ONE, 1
        while n < 400:
            term = term * mid * ball(Fraction(1, n))
            out, n = out + term, n + 1
            if term.upper() < ldexp(1.0, -bits):
                break
        out = out.wide(2 * term.upper())  # |mid| < 1/2: the rest is below a geometric series
        for _ in range(k):
            out = out * out
    finally:
        set_bits(before)
    if z.r:
        if not z.r < 1:
            raise UnclearError("an exponent is too wide")
        out = out.wide(up(out.upper() * z.r * (1 + z.r)))  # e^r − 1 ≤ r(1 + r) for r < 1
    return Ball(out.a, out.b, out.e, out.r)


FIXED = 96
"""Angles are integers times 2^-FIXED with bounds for what is wrong."""


def _arctan(n: int, d: int) -> int:
    """arctan(n/d)·2^FIXED for 0 ≤ n ≤ d, up to 2^12 of such units: twice halved, then its series."""
    from math import isqrt

    work = FIXED + 32
    one = 1 << work
    t = (n << work) // d
    for _ in range(3):
        t = (t << work) // (one + isqrt((one << work) + t * t))
    total, power, square, k = 0, t, t * t >> work, 1
    while power:
        total += power // k if k % 4 == 1 else -(power // k)
        power, k = power * square >> work, k + 2
    return (8 * total) >> 32


PI = 4 * _arctan(1, 1)


def arg(z: Ball) -> tuple[int, int]:
    """The principal argument in units of 2^-FIXED, and a bound for its error; UnclearError next to x ≤ 0."""
    low = z.lower()
    if not low > 0:
        raise UnclearError("an argument of what may be 0")
    x, y = abs(z.a), abs(z.b)
    angle = _arctan(y, x) if y <= x else PI // 2 - _arctan(x, y)
    if z.a < 0:
        angle = PI - angle
        if not Ball(0, z.b, z.e, z.r).lower() > 0:
            raise UnclearError("an argument next to the cut")
    if z.b < 0:
        angle = -angle
    spread = Fraction(z.r) / Fraction(low) * 2  # arcsin x ≤ πx/2
    return angle, (1 << 14) + int(spread * (1 << FIXED)) + 1
