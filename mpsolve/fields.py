"""Three arithmetics with the same operations: float64 arrays, mpmath numbers, and balls (flint.acb).

A formula is written once, over a `Field`; which of the three it runs in is an explicit argument.
The precision of flint is set by `mpsolve.numbers.balls` only. mpmath's global context is never used.
"""

from __future__ import annotations

import cmath
import math
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from typing import Any, Protocol

import flint
import mpmath
import numpy as np

from mpsolve.errors import PrecisionError
from mpsolve.numbers.balls import precision
from mpsolve.numbers.exact import Exact

Waves = tuple[Any, Any, Any]


class Field(Protocol):
    """What the formulas need of an arithmetic."""

    pi: Any
    i: Any

    def number(self, value: Exact) -> Any: ...
    def exp(self, z: Any) -> Any: ...
    def sqrt(self, z: Any) -> Any: ...
    def real_sqrt(self, x: Any) -> Any:
        """√x of a real x ≥ 0, real."""

    def upper(self, s: Any) -> Any:
        """±s with positive imaginary part."""

    def dominant_sum(self, a2: Any, a1: Any, a0: Any) -> Any:
        """√y with the largest imaginary part over the roots y of y³ + a2 y² + a1 y + a0."""

    def largest_real_root(self, a2: Any, a1: Any, a0: Any) -> Any:
        """The largest real root of y³ + a2 y² + a1 y + a0, real coefficients."""

    def waves(self, sigma: Any, delta2: Any, x: Any) -> Waves:
        """With δ² = delta2: e^{iσx} cos δx, e^{iσx} sin(δx)/δ and e^{iσx} (x cos δx − sin(δx)/δ)/(2δ²)."""

    def det(self, rows: Sequence[Sequence[Any]]) -> Any: ...


# --- float64 -----------------------------------------------------------------------------------------------


class Float64:
    """numpy complex128 arrays of any shape (broadcast together)."""

    pi = np.pi
    i = 1j

    def number(self, value: Exact) -> float:
        return float(value)

    def exp(self, z: Any) -> Any:
        return np.exp(z)

    def sqrt(self, z: Any) -> Any:
        return np.sqrt(np.asarray(z, dtype=complex))

    def real_sqrt(self, x: Any) -> Any:
        return np.sqrt(x)

    def upper(self, s: Any) -> Any:
        return np.where(np.imag(s) < 0, -s, s)

    def dominant_sum(self, a2: Any, a1: Any, a0: Any) -> Any:
        candidates = [self.upper(self.sqrt(y)) for y in cardano(a2, a1, a0)]
        best = candidates[0]
        for s in candidates[1:]:
            best = np.where(np.imag(s) > np.imag(best), s, best)
        return best

    def ranked_sum(self, a2: Any, a1: Any, a0: Any, rank: int) -> Any:
        """As `dominant_sum`, but the one of this rank (0, 1, 2) by imaginary part, the largest first."""
        sums = np.stack(np.broadcast_arrays(*(self.upper(self.sqrt(y)) for y in cardano(a2, a1, a0))))
        return np.take_along_axis(sums, np.argsort(-sums.imag, axis=0)[rank : rank + 1], 0)[0]

    def largest_real_root(self, a2: Any, a1: Any, a0: Any) -> Any:
        roots = np.stack(np.broadcast_arrays(*cardano(a2, a1, a0)))
        real = np.abs(roots.imag) <= 1e-7 * np.max(np.abs(roots), axis=0)
        return np.max(np.where(real, roots.real, -np.inf), axis=0)

    def waves(self, sigma: Any, delta2: Any, x: Any) -> Waves:
        z = delta2 * x * x
        near = np.abs(z) < 1e-2
        delta = np.sqrt(np.where(near, 1.0, delta2) + 0j)
        plus, minus = np.exp(1j * (sigma + delta) * x), np.exp(1j * (sigma - delta) * x)
        cos, sin = (plus + minus) / 2, (plus - minus) / (2j * delta)
        third = (x * cos - sin) / (2 * delta * delta)
        if not near.any():
            return cos, sin, third
        # Taylor in z = δ²x²: |z| < 1e-2 leaves an error below 1e-17
        cos, sin, third, near, sigma, z, x = (
            np.array(v) for v in np.broadcast_arrays(cos, sin, third, near, sigma, z, x)
        )
        carrier, x = np.exp(1j * sigma[near] * x[near]), x[near]
        near_cos, near_sinc, near_third = _taylor_waves(z[near], 7)
        cos[near], sin[near], third[near] = carrier * near_cos, carrier * x * near_sinc, carrier * x**3 * near_third
        return cos, sin, third

    def one_minus_exp(self, z: Any, x: Any) -> Any:
        """(1 − e^{izx})/z, entire in z; 1 − e^{iv} = −2i e^{iv/2} sin(v/2) near 0."""
        v = z * x
        near = np.abs(v) < 1e-3
        if not near.any():
            return (1 - np.exp(1j * v)) / z
        series = -1j * x * (1 + 1j * v / 2 * (1 + 1j * v / 3 * (1 + 1j * v / 4 * (1 + 1j * v / 5))))
        return np.where(near, series, (1 - np.exp(1j * v)) / np.where(near, 1, z))

    def det(self, rows: Sequence[Sequence[Any]]) -> Any:
        if len(rows) <= 2:
            return laplace_det(rows)
        shape = np.broadcast_shapes(*(np.shape(v) for row in rows for v in row))
        stacked = np.stack([np.stack([np.broadcast_to(v, shape) for v in row], -1) for row in rows], -2)
        return np.linalg.det(stacked)


def cardano(a2: Any, a1: Any, a0: Any) -> tuple[Any, Any, Any]:
    """The three roots of y³ + a2 y² + a1 y + a0 in float64 arrays, each polished by two Newton steps."""
    a2, a1, a0 = (np.asarray(a, dtype=complex) for a in (a2, a1, a0))
    p, q = a1 - a2 * a2 / 3, a2 * (2 * a2 * a2 / 27 - a1 / 3) + a0
    root = np.sqrt(q * q / 4 + p**3 / 27)
    cube = np.where(np.abs(-q / 2 + root) >= np.abs(-q / 2 - root), -q / 2 + root, -q / 2 - root)
    u = np.where(cube == 0, 0, np.exp(np.log(np.where(cube == 0, 1, cube)) / 3))
    turns = np.exp(2j * np.pi / 3 * np.arange(3)).reshape(3, *(1,) * u.ndim)
    v = u * turns
    y = v - p / (3 * np.where(v == 0, 1, v)) - a2 / 3
    for _ in range(2):
        slope = (3 * y + 2 * a2) * y + a1
        y = y - np.where(slope == 0, 0, ((y + a2) * y + a1) * y + a0) / np.where(slope == 0, 1, slope)
    return y[0], y[1], y[2]


def _taylor_waves(z: Any, terms: int) -> Waves:
    """cos √z, sin √z/√z and (cos √z − sin √z/√z)/(2z) by their entire series, cut after `terms` terms."""
    cos = sinc = third = 0
    power, factorial = z * 0 + 1, 1  # (−z)^k and (2k+1)!
    for k in range(terms):
        cos = cos + power * (2 * k + 1) / factorial
        sinc = sinc + power / factorial
        # d/dz sinc: the term k of sinc gives −k (−z)^{k−1}/(2k+1)!; shifted by one
        factorial *= (2 * k + 2) * (2 * k + 3)
        third = third - power * (k + 1) / factorial
        power = power * (-z)
    return cos, sinc, third


def laplace_det(rows: Sequence[Sequence[Any]]) -> Any:
    """A determinant by expansion along its first row, without a division."""
    if len(rows) == 1:
        return rows[0][0]
    if len(rows) == 2:
        return rows[0][0] * rows[1][1] - rows[0][1] * rows[1][0]
    total = 0
    for k, entry in enumerate(rows[0]):
        minor = [[*row[:k], *row[k + 1 :]] for row in rows[1:]]
        total = total + (-1) ** k * (entry * laplace_det(minor))
    return total


# --- mpmath ------------------------------------------------------------------------------------------------


class MP:
    """mpmath at `bits` bits, in a context of its own."""

    def __init__(self, bits: int) -> None:
        if bits < 53:
            raise ValueError(f"{bits} bits asked of mpmath: give at least 53, or use Float64")
        self.context = mpmath.MPContext()
        self.context.prec = bits
        self.bits = bits
        self.pi = +self.context.pi
        self.i = self.context.mpc(0, 1)

    def number(self, value: Exact) -> Any:
        return value.mpf(self.context)

    def exp(self, z: Any) -> Any:
        return self.context.exp(z)

    def sqrt(self, z: Any) -> Any:
        return self.context.sqrt(z)

    def real_sqrt(self, x: Any) -> Any:
        return self.context.sqrt(x)

    def upper(self, s: Any) -> Any:
        return -s if self.context.im(s) < 0 else s

    def dominant_sum(self, a2: Any, a1: Any, a0: Any) -> Any:
        with self.context.workprec(3 * self.bits):
            s = max((self.upper(self.sqrt(y)) for y in self._cardano(a2, a1, a0)), key=lambda s: self.context.im(s))
        return +s

    def ranked_sum(self, a2: Any, a1: Any, a0: Any, rank: int) -> Any:
        """As `dominant_sum`, but the one of this rank (0, 1, 2) by imaginary part, the largest first."""
        with self.context.workprec(3 * self.bits):
            sums = [self.upper(self.sqrt(y)) for y in self._cardano(a2, a1, a0)]
            s = sorted(sums, key=lambda s: -self.context.im(s))[rank]
        return +s

    def _cardano(self, a2: Any, a1: Any, a0: Any) -> list[Any]:
        """The three roots, at the present precision; nearly equal ones are good to a third of it."""
        context = self.context
        p, q = a1 - a2 * a2 / 3, a2 * (2 * a2 * a2 / 27 - a1 / 3) + a0
        root = context.sqrt(q * q / 4 + p**3 / 27)
        cube = max(-q / 2 + root, -q / 2 - root, key=abs)
        if not cube:
            return [context.mpc(-a2 / 3)] * 3
        u = context.exp(context.log(cube) / 3)
        turns = [context.expjpi(context.mpf(2 * k) / 3) for k in range(3)]
        return [u * t - p / (3 * u * t) - a2 / 3 for t in turns]

    def largest_real_root(self, a2: Any, a1: Any, a0: Any) -> Any:
        with self.context.workprec(3 * self.bits):
            roots = self._cardano(a2, a1, a0)
            scale = max(abs(y) for y in roots)
            real = max(y.real for y in roots if abs(self.context.im(y)) <= scale * 2.0 ** (-self.bits // 2))
        return +real

    def waves(self, sigma: Any, delta2: Any, x: Any) -> Waves:
        z = delta2 * x * x
        if abs(z) < 0.25:  # the third of the waves is a difference that loses the bits of 1/|z|
            terms = 2
            while 2 * terms + math.lgamma(2 * terms + 1) / math.log(2) < self.bits + 4:  # |z|^k/(2k)! < 2^−bits
                terms += 1
            carrier = self.exp(self.i * sigma * x)
            cos, sinc, third = _taylor_waves(z, terms)
            return carrier * cos, carrier * x * sinc, carrier * x**3 * third
        delta = self.sqrt(delta2)
        plus, minus = self.exp(self.i * (sigma + delta) * x), self.exp(self.i * (sigma - delta) * x)
        cos, sin = (plus + minus) / 2, (plus - minus) / (2 * self.i * delta)
        return cos, sin, (x * cos - sin) / (2 * delta2)

    def det(self, rows: Sequence[Sequence[Any]]) -> Any:
        if len(rows) <= 2:
            return laplace_det(rows)
        return self.context.det(self.context.matrix([list(row) for row in rows]))


# --- balls -------------------------------------------------------------------------------------------------


class Ball:
    """flint.acb enclosures at `bits` bits; made by `ball_arithmetic` only, which sets the precision."""

    def __init__(self, bits: int) -> None:
        self.bits = bits
        self.pi = flint.arb.pi()
        self.i = flint.acb(0, 1)

    def number(self, value: Exact) -> flint.arb:
        return value.ball()

    def exp(self, z: Any) -> Any:
        return z.exp()

    def sqrt(self, z: Any) -> Any:
        """A continuous branch of √z on the ball; `PrecisionError` when the ball holds 0."""
        z = flint.acb(z)
        if z.contains(0):
            raise PrecisionError(f"a square root's argument {z.str(5)} may be 0: split the piece")
        return z.sqrt() if z.real > 0 or not z.imag.contains(0) else self.i * (-z).sqrt()

    def real_sqrt(self, x: Any) -> Any:
        return flint.arb(x).sqrt()

    def upper(self, s: Any) -> Any:
        if s.imag > 0:
            return s
        if s.imag < 0:
            return -s
        raise PrecisionError(f"the sign of Im {s.str(5)} is open: split the piece or raise the precision")

    def dominant_sum(self, a2: Any, a1: Any, a0: Any) -> Any:
        """As a candidate only: the caller proves that both roots of the factor are above the axis."""
        mid = [flint.acb(a).mid() for a in (a2, a1, a0)]
        seed = _seed_root([complex(m) for m in mid])
        if seed is None:
            seed = max(_isolated_roots([*mid[::-1], 1]), key=_sum_height).mid()
        return self.upper(self.sqrt(simple_root([flint.acb(a0), flint.acb(a1), flint.acb(a2)], seed, self.bits)))

    def largest_real_root(self, a2: Any, a1: Any, a0: Any) -> Any:
        """Proved: all three roots are isolated in disjoint balls, the real ones as real roots."""
        coefficients = [flint.arb(a0), flint.arb(a1), flint.arb(a2)]
        every, real = [], []
        for y in _isolated_roots([a.mid() for a in coefficients] + [1]):
            if y.imag.contains(0):
                real.append(simple_root(coefficients, y.real.mid(), self.bits))
                every.append(flint.acb(real[-1]))
            else:
                every.append(simple_root([flint.acb(a) for a in coefficients], y.mid(), self.bits))
                if every[-1].imag.contains(0):
                    raise PrecisionError("a root of a real cubic may be real or not: raise the precision")
        if any(a.overlaps(b) for k, a in enumerate(every) for b in every[:k]):
            raise PrecisionError("two roots of a real cubic are too close: raise the precision")
        return max(real, key=lambda y: float(y.mid()))  # disjoint balls: their midpoints order them

    def waves(self, sigma: Any, delta2: Any, x: Any) -> Waves:
        z = delta2 * x * x
        if z.abs_upper() < 0.25:
            carrier = (self.i * sigma * x).exp()
            cos, sinc, third = self._taylor(z)
            return carrier * cos, carrier * x * sinc, carrier * x**3 * third
        delta = self.sqrt(delta2)
        plus, minus = (self.i * (sigma + delta) * x).exp(), (self.i * (sigma - delta) * x).exp()
        cos, sin = (plus + minus) / 2, (plus - minus) / (2 * self.i * delta)
        return cos, sin, (x * cos - sin) / (2 * delta2)

    def _taylor(self, z: Any) -> Waves:
        """The series with its remainder: |z| < 1/4, so the tail is below twice its first term."""
        size, bound, terms = z.abs_upper(), flint.arb(1), 0
        tiny = flint.arb(2) ** (-self.bits)
        while bound > tiny:
            terms += 1
            bound = bound * size / (2 * terms * (2 * terms - 1))  # |z|^k/(2k)! bounds term k of all three
        tail = flint.arb(0, (2 * bound).upper())
        cos, sinc, third = _taylor_waves(z, max(terms, 1))
        error = flint.acb(tail, tail)
        return cos + error, sinc + error, third + error

    def det(self, rows: Sequence[Sequence[Any]]) -> Any:
        if len(rows) <= 4:  # Gaussian elimination divides by pivots, which widens wide balls
            return laplace_det(rows)
        return flint.acb_mat([list(row) for row in rows]).det()

    def one_minus_exp(self, z: Any, x: Any) -> Any:
        """(1 − e^{izx})/z, entire in z; −ix e^{iw} sinc w with w = zx/2 near 0."""
        w = z * x / 2
        if w.abs_lower() > 0.5:
            return (1 - (2 * self.i * w).exp()) / z
        return -self.i * x * (self.i * w).exp() * w.sinc()

    def nearest_pair_first(self, z: Any) -> Any:
        """Names (a, c) the upper and lower p-root that are closest (an honest choice at any outcome)."""
        orders = [type(z)(u, v, w, x) for u, v in ((z.a, z.b), (z.b, z.a)) for w, x in ((z.c, z.e), (z.e, z.c))]
        return min(orders, key=lambda o: float(abs(o.a.mid() - o.c.mid())))

    def choose(self, z: Any, apart: Any, bordered: Any) -> Any:
        """`apart()` where no upper p-root is next to a lower one, else `bordered()`."""
        far = (z.a - z.c).abs_lower() > 0.2 * (z.b - z.e).abs_upper()
        return apart() if far else bordered()


@contextmanager
def ball_arithmetic(bits: int) -> Iterator[Ball]:
    """A `Ball` field whose precision holds inside the block, and is put back after it."""
    with precision(bits):
        yield Ball(bits)


def _seed_root(coefficients: Sequence[complex]) -> complex | None:
    """A float approximation to the dominant root y, or None where float64 cannot tell it from the others."""
    a2, a1, a0 = coefficients
    try:
        p, q = a1 - a2 * a2 / 3, a2 * (2 * a2 * a2 / 27 - a1 / 3) + a0
        root = cmath.sqrt(q * q / 4 + p**3 / 27)
        cube = max(-q / 2 + root, -q / 2 - root, key=abs)
        if cube == 0:
            return None
        u = cmath.exp(cmath.log(cube) / 3)
        turns = (1, cmath.exp(2j * cmath.pi / 3), cmath.exp(-2j * cmath.pi / 3))
        ys = sorted((u * t - p / (3 * u * t) - a2 / 3 for t in turns), key=lambda y: -abs(cmath.sqrt(y).imag))
    except OverflowError:
        return None
    gap = abs(cmath.sqrt(ys[0]).imag) - abs(cmath.sqrt(ys[1]).imag)
    return ys[0] if gap > 1e-6 * abs(cmath.sqrt(ys[0])) else None


def real_pairing(c2: Any, c1: Any, c0: Any, bits: int) -> tuple[Any, Any]:
    """Real s, h with p⁴ + c2 p² + c1 p + c0 = (p² − s p + t)(p² + s p + t'), t − t' = h, t + t' = s² + c2.

    c1 ≥ 0. Of the real roots y = s² ≥ 0 of the resolvent cubic the best separated one is taken. Raises
    `PrecisionError` when none can be isolated.
    """
    a2, a1 = 2 * c2, c2 * c2 - 4 * c0
    if c1.is_zero():
        return _even_pairing(c2, c0)
    seed = _best_separated_root(float(a2.mid()), float(a1.mid()), -(float(c1.mid()) ** 2))
    y = simple_root([-c1 * c1, a1, a2], flint.arb(seed), bits)
    h2 = (y + c2) ** 2 - 4 * c0
    if h2 > 0 and not h2 < y:  # s and h share the product c1: take the root of the larger one
        h = h2.sqrt()
        return c1 / h, h
    if y > 0:
        s = y.sqrt()
        return s, c1 / s
    raise PrecisionError("the p-roots on the cut cannot be paired: split the piece")


def _even_pairing(c2: Any, c0: Any) -> tuple[Any, Any]:
    """`real_pairing` of p⁴ + c2 p² + c0: (p² + t)(p² + t') with s = 0, or with h = 0."""
    h2 = c2 * c2 - 4 * c0
    if c0 > 0 and not h2 > c2 * c2 / 2:
        y = 2 * c0.sqrt() - c2
        if y > 0:
            return y.sqrt(), flint.arb(0)
    if h2 > 0:
        return flint.arb(0), h2.sqrt()
    raise PrecisionError("the p-roots on the cut cannot be paired: split the piece")


def _best_separated_root(a2: float, a1: float, a0: float) -> float:
    """A float approximation to the non-negative real root of the cubic with the largest slope."""
    p, q, shift = a1 - a2 * a2 / 3, a2 * (2 * a2 * a2 / 27 - a1 / 3) + a0, -a2 / 3
    discriminant = q * q / 4 + p**3 / 27
    if discriminant > 0:
        root = math.sqrt(discriminant)
        u = math.cbrt(-q / 2 - math.copysign(root, q))
        roots = [u - p / (3 * u) + shift if u else shift]
    else:
        angle = math.acos(max(-1.0, min(1.0, -q / 2 / math.sqrt(max(-(p**3) / 27, 1e-300))))) / 3
        size = 2 * math.sqrt(max(-p / 3, 0.0))
        roots = [size * math.cos(angle + turn * math.tau / 3) + shift for turn in (0, 1, -1)]
    floor = -1e-9 * max(abs(y) for y in roots)
    kept = [y for y in roots if y >= floor] or [max(roots)]
    return max(kept, key=lambda y: abs((3 * y + 2 * a2) * y + a1))


def _isolated_roots(coefficients: Sequence[Any]) -> list[Any]:
    try:
        return list(flint.acb_poly(list(coefficients)).roots())
    except ValueError:
        raise PrecisionError("two roots of a cubic are too close to tell apart: raise the precision") from None


def _sum_height(y: Any) -> float:
    return abs(complex(y.mid().sqrt()).imag)


def simple_root(coefficients: Sequence[Any], seed: Any, bits: int) -> Any:
    """A ball proved to hold, for every choice in the coefficient balls, one simple root near `seed`.

    The polynomial is monic; `coefficients` go from the constant term up, without the leading 1. Works over
    flint.acb and, with real coefficients and a real seed, flint.arb (the root is then real). Newton from
    the seed on the midpoints, precision doubling, then interval Newton with interior containment. Raises
    `PrecisionError` when the proof fails.
    """
    number = type(coefficients[0])
    mids = [c.mid() for c in coefficients]
    y, reached = number(seed), 40
    while reached < bits:
        reached = min(2 * reached, bits)
        with precision(max(reached, 64) if reached < bits else bits):
            value, slope = _horner(mids, y)
            y = (y - value / slope).mid()
        if not y.is_finite():
            raise PrecisionError("Newton's method for a p-root sum left the finite plane: split the piece")
    value, slope = _horner(coefficients, y)
    step = value / slope
    if not step.is_finite():
        raise PrecisionError("two p-root pairings meet inside the ball: split the piece")
    tiny = abs(y).upper() * flint.arb(2) ** (4 - bits)
    radius = 2 * flint.arb(abs(step).upper()) + tiny
    for _ in range(6):
        spread = flint.arb(0, radius.upper())
        ball = y + (spread if number is flint.arb else flint.acb(spread, spread))
        slope = _horner(coefficients, ball)[1]
        image = y - value / slope
        if image.is_finite() and ball.contains_interior(image):
            return image
        radius = 2 * radius
    raise PrecisionError("a p-root sum could not be isolated in its ball: split the piece or raise the precision")


def _horner(coefficients: Sequence[Any], y: Any) -> tuple[Any, Any]:
    """Value and slope of the monic polynomial."""
    value, slope = y * 0 + 1, y * 0
    for c in reversed(coefficients):
        slope = slope * y + value
        value = value * y + c
    return value, slope
