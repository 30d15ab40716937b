"""No root on the edge far out, for masses on a beam, and how arg Δ turns there: section 8.5 of SPEC2.md."""

from __future__ import annotations

from fractions import Fraction
from itertools import pairwise
from typing import Any

from balls import ONE, PI, ZERO, arg, ball, exp
from reading import need
from track import root_bounds
from waves import Thin, Waves

PARTS = 32
"""Of the range of y = 1/λ²."""


class Range:
    """All numbers from low to high."""

    def __init__(self, low: Fraction | int, high: Fraction | int) -> None:
        self.low, self.high = Fraction(low), Fraction(high)

    def __add__(self, other: Range) -> Range:
        return Range(self.low + other.low, self.high + other.high)

    def __sub__(self, other: Range) -> Range:
        return Range(self.low - other.high, self.high - other.low)

    def __mul__(self, other: Range) -> Range:
        ends = [x * y for x in (self.low, self.high) for y in (other.low, other.high)]
        return Range(min(ends), max(ends)).short()

    def __truediv__(self, other: Range) -> Range:
        need(other.low > 0, "a quantity far out may be 0")
        return self * Range(1 / other.high, 1 / other.low)

    def short(self) -> Range:
        """With few digits."""
        return Range(-_above(-self.low), _above(self.high))

    def root(self) -> Range:
        need(self.low > 0, "a quantity far out may not be positive")
        return Range(root_bounds(self.low, 1, 2)[0], root_bounds(self.high, 1, 2)[1]).short()


def _above(value: float | Fraction) -> Fraction:
    """A fraction of few digits that is not below."""
    value = Fraction(value)
    return Fraction(-((-value.numerator << 64) // value.denominator), 1 << 64)


def _just(x: Fraction | int) -> Range:
    return Range(x, x)


def _waves(nu2: Fraction, g: Fraction, kappa: Fraction, y: Range) -> tuple[Range, Range, Range]:
    """q, C² and h of section 8.5 over a part."""
    S = _just(4)
    for _ in range(16):
        tried = Range(S.low - (S.high - S.low) / 2 - Fraction(1, 2**40), S.high * 2 - S.low + Fraction(1, 2**40))
        e = y * (_just(4 * nu2) / tried - _just(g))
        S = e * e + _just(4) * (_just(1) - _just(kappa) * y * y)
        need(S.low > 0, "the waves far out")
        if tried.low <= S.low and S.high <= tried.high:
            break
    else:
        need(False, "the waves far out")
    s, square = S.root(), _just(4 * nu2) * y / S
    x = square - _just(2 * g) * y
    plus, less = _just(2) * s + x, _just(2) * s - x
    need(less.low > 0, "the waves far out")
    uneven = (s + square) * (s + square) / (S + _just(2) * square * (square - _just(g) * y))
    return less / plus, uneven, plus.root() / _just(2)


def _masses(beam: Any) -> list[tuple[Fraction, Fraction]]:
    """(place, mass), ascending: every body is a mass with a contact of its own."""
    vehicle, eta = beam.lower, beam.eta
    n, M, B = vehicle.bodies, vehicle.M, vehicle.B
    alone = n == vehicle.contacts and not any(vehicle.h)
    both = [(i, j) for i in range(n) for j in range(n)] if alone else []
    alone = alone and all(sum(map(bool, row)) == 1 for row in (*B, *zip(*B, strict=True)))
    alone = alone and all(M[i][i] > 0 if i == j else not M[i][j] for i, j in both)
    bare = all(vehicle.C[i][j] == -2 * eta * M[i][j] and vehicle.K[i][j] == eta**2 * M[i][j] for i, j in both)
    need(alone and bare, "the vehicles are not masses of their own")
    out = {place: Fraction(0) for place in vehicle.sites}
    for i, j in both:
        if B[i][j]:
            out[vehicle.places[j]] += M[i][i] / B[i][j] ** 2
    return sorted(out.items())


def check_far(beam: Any, rho: Fraction, waves: Waves, thin: Thin) -> tuple[int, int]:
    """By how much arg Δ changes from ρ on to infinity and to −i∞, and its error: no root is on the edge beyond ρ."""
    masses, eta = _masses(beam), beam.eta
    need(rho > eta, "the reach is too small")
    c0 = Range(*root_bounds(beam.EI / beam.m, 1, 2))
    top = _above(c0.high / rho)
    nu2 = beam.m * beam.v**2 / beam.EI
    ends = [Range(top * k / PARTS, top * (k + 1) / PARTS) for k in range(PARTS)]
    parts = [_waves(nu2, beam.T / beam.EI + nu2, beam.k / beam.EI, y) for y in ends]
    low, high = min(q.low for q, _, _ in parts), max(q.high for q, _, _ in parts)
    C2, h = max(c.high for _, c, _ in parts), min(d.low for _, _, d in parts)
    a = 2 * eta * rho / (rho**2 - eta**2)
    need(1 + low > (1 + a**2) * C2, "the reach is too small")
    r = _above(1 / root_bounds(1 + low, 1, 2)[0])
    product = _cascade(len(masses), r, a)
    x = Fraction(0)
    if len(masses) > 1:
        gap = min(q - p for (p, _), (q, _) in pairwise(masses))
        decay = root_bounds(rho / c0.high, 1, 2)[0] * h * gap
        small = _above(r * root_bounds(high, 1, 2)[1] * Fraction(exp(ball(-decay)).upper()))
        most = r * (root_bounds(C2, 1, 2)[1] + (root_bounds(C2 - 1, 1, 2)[1] if C2 > 1 else 0))
        n = len(masses)
        row = _above(root_bounds(1 + (n - 1) * (most + small) ** 2, 1, 2)[1])
        x = _above(n * root_bounds(Fraction(n - 1), 1, 2)[1] * small * row ** (n - 1) / product)
        need(x < 1, "waves between masses may add up")
    total, error = _argument(masses, waves, thin, eta, rho)
    beside, wrong = arg(ball(root_bounds(1 - x**2, 1, 2)[0], x))  # no less than arcsin x
    return -total, error + beside + wrong


def _cascade(n: int, r: Fraction, a: Fraction) -> Fraction:
    """A bound below |det(1 + T)|."""
    Z, product = r, Fraction(1)
    for _ in range(n - 1):
        left = 1 - r * Z
        need(left > 0, "too many masses for the reach")
        product *= left
        first = (Z + r) / (1 + r * Z) if Z <= 1 else root_bounds(1 + (1 - r**2) * (Z**2 - 1) / left**2, 1, 2)[1]
        Z = _above(first + 2 * a * Z / left)
    return product


def _argument(
    masses: list[tuple[Fraction, Fraction]], waves: Waves, thin: Thin, eta: Fraction, rho: Fraction
) -> tuple[int, int]:
    """The continuous argument at ρ but for evanescent waves, and its error."""
    amplitudes = waves.amplitudes(thin)
    free = []
    for upper, sign in ((True, -1), (False, 1)):
        side = [k for k, u in enumerate(thin.upper) if u == upper]
        free.append([k for k in side if thin.roots[k].sign() != sign])
        need(len(free[-1]) == 1, "the waves far out are not told apart")
    (i,), (j,) = free
    step, ahead, behind = thin.roots[i] - thin.roots[j], amplitudes[i], amplitudes[j]
    at_contact = ZERO
    for c, u in zip(amplitudes, thin.upper, strict=True):
        at_contact = at_contact + c if u else at_contact
    sigma = ball(-eta, rho)
    total = error = 0
    arriving, last = ZERO, masses[-1][0]
    for place, mass in reversed(masses):
        arriving = arriving * exp(step * ball(last - place))
        d = at_contact + (ball(mass) * sigma * sigma).inverse()
        over = d.inverse()
        factor = ONE + behind * over * arriving
        for value, times, less in ((sigma, 2, 0), (-d, 1, PI), (factor, 1, 0)):
            angle, wrong = arg(value)
            total, error = total + times * angle - less, error + times * wrong
        arriving = (arriving * (ONE - (ahead + behind) * over) - ahead * over) / factor
        last = place
    return total, error + 100
