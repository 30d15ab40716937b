"""No root far out below the cuts, for masses on a beam: section 8.5 of SPEC2.md, with bounds that are rationals."""

from __future__ import annotations

from fractions import Fraction
from itertools import pairwise
from math import cos, pi, sin
from typing import Any

import balls as b
from balls import ONE, Ball, ball, exp
from reading import Point, need
from taylor import Line, constant
from track import root_bounds
from waves import THIN, WIDE, Thin, Waves, linked

R2 = root_bounds(Fraction(2), 1, 2)
R5 = root_bounds(Fraction(5), 1, 2)
STEPS = 48
"""Discs round the circle."""


class Scaled:
    """What `Waves` needs of P̂⁴ + 1 − 2v û P̂ + ((T + mv²)/m) û² P̂² + (k'EI/m²) û⁴, û = u/c₀ in place of σ."""

    def __init__(self, beam: Any) -> None:
        one = Fraction(1)
        terms = {(4, 0): one, (0, 0): one, (1, 1): -2 * beam.v, (2, 2): (beam.T + beam.m * beam.v**2) / beam.m}
        terms[0, 4] = beam.k * beam.EI / beam.m**2
        self.d = {key: c for key, c in terms.items() if c}
        self.moving_n = {(0, 0): one}
        self.degree = 4


def _above(value: float | Fraction) -> Fraction:
    """A fraction of few digits that is not below."""
    value = Fraction(value)
    return Fraction(-((-value.numerator << 64) // value.denominator), 1 << 64)


def _bounds(beam: Any, R: Fraction) -> list[Fraction]:
    """b₁ … b₅ on |û| = R."""
    waves = Waves(Scaled(beam))  # type: ignore[arg-type]
    b.set_bits(THIN)
    half = ball(root_bounds(Fraction(1, 2), 1, 2)[0]).wide(2.0**-70)  # 1/√2
    eighth = half + half * Ball(0, 1)  # e^{iπ/4}
    targets = [-eighth, -(eighth.conj()), eighth, eighth.conj()]  # a, e, c, f at û = 0
    roots = waves.thin(ball(0), [z.complex() for z in targets])
    need(all(not (z - t).lower() > 0 for z, t in zip(roots, targets, strict=True)), "the waves at infinity")
    thin = Thin(ball(0), roots, [True, True, False, False])
    names = list(range(4))
    out = [0.0] * 5
    thin, names, _ = _step(waves, thin, names, (R / 2, Fraction(0)), False, (eighth, half))
    circle = [_on_circle(R, 2 * pi * k / STEPS) for k in range(STEPS)]
    ahead = [p[0] * q[1] - p[1] * q[0] > 0 < p[0] * q[0] + p[1] * q[1] for p, q in pairwise([*circle, circle[0]])]
    need(all(ahead), "the polygon does not go round")
    for k, end in enumerate([*circle, circle[0]]):
        thin, names, found = _step(waves, thin, names, end, k > 0, (eighth, half))
        out = [max(pair) for pair in zip(out, found, strict=True)]
    return [_above(value) for value in out]


def _on_circle(R: Fraction, t: float) -> Point:
    """A point of modulus ≥ R, above it by less than 2^−60 R: discs that are wider by 2^−20 reach round the circle."""
    u = Fraction(cos(t)), Fraction(sin(t))
    size = root_bounds(u[0] ** 2 + u[1] ** 2, 1, 2)[0]
    return R * u[0] / size, R * u[1] / size


def _step(
    waves: Waves, begin: Thin, names: list[int], end: Point, used: bool, constants: tuple[Ball, Ball]
) -> tuple[Thin, list[int], list[float]]:
    """One piece: the end, which root is which there, and the bounds on its disc."""
    eighth, half = constants
    last = ball(end[0], end[1])
    at = ((begin.at + last) * ball(Fraction(1, 2))).mid()
    r = max((begin.at - at).upper(), (last - at).upper()) * (1 + 2.0**-20)
    before = b.set_bits(WIDE)
    try:
        lines = waves.piece(at, r, [z.complex() for z in begin.roots])
    finally:
        b.set_bits(before)
    named = _names(begin.roots, names, [line.at(begin.at - at) for line in lines])
    there = [line.at(last - at) for line in lines]
    roots = waves.thin(last, waves.guesses(last.complex(), [z.complex() for z in there]))
    final = _names(there, named, roots)
    new = Thin(last, roots, [name < 2 for name in final])
    if not used:
        return new, final, [0.0] * 5
    P = [lines[named.index(k)] for k in range(4)]
    w = []
    for k, root in enumerate(P):
        c = constant(ONE if k < 2 else -ONE, r)
        for i, other in enumerate(P):
            if i != k:
                c = c * (root - other).inverse()
        w.append(c)
    a, e, c, f = w

    def departs(value: Line, target: Ball) -> float:
        return (value - constant(target, r)).upper()

    four, two = ball(4), ball(2)
    bounds = [
        departs(a + e, half * ball(Fraction(1, 2))),
        departs((a * c).times(Ball(0, -16)), ONE),
        departs((a + c).times(four * eighth.conj()), two),
        max(departs(P[1], -(eighth.conj())), departs(P[3], eighth.conj())),
        max(value.upper() for value in (a, e, c, f)),
    ]
    return new, final, bounds


def _names(ones: list[Ball], names: list[int], others: list[Ball]) -> list[int]:
    """The names of the others, by which of the ones each meets: two bits of them at a time."""
    low = linked(ones, [bool(n & 1) for n in names], others)
    high = linked(ones, [bool(n & 2) for n in names], others)
    return [int(x) + 2 * int(y) for x, y in zip(low, high, strict=True)]


def check_far(beam: Any, W: Fraction, rho: Fraction) -> None:
    """No root has |z| ≥ ρ below the cuts."""
    vehicle = beam.lower
    n = vehicle.bodies
    alone = n == vehicle.contacts and not any(vehicle.h)
    for i in range(n):
        used = [j for j in range(n) if i < vehicle.contacts and vehicle.B[i][j]] if alone else []
        alone = alone and len(used) == 1 and sum(bool(row[used[0]]) for row in vehicle.B) == 1
        off = [vehicle.M[i][j] for j in range(n) if j != i] if alone else [1]
        alone = alone and not any(off) and vehicle.M[i][i] > 0
    eta, M = beam.eta, vehicle.M
    masses = alone and all(
        vehicle.C[i][j] == -2 * eta * M[i][j] and vehicle.K[i][j] == eta**2 * M[i][j]
        for i in range(n)
        for j in range(n)
    )
    need(masses, "the vehicles are not masses of their own")
    c_low, c_high = root_bounds(beam.EI / beam.m, 1, 2)
    need(W > 0 and rho > c_high * W * W, "the reach is beyond the path")
    R = _above(1 / (W * c_low)) * Fraction(2**30 + 1, 2**30)
    W = 1 / (c_high * R)  # a little less: the bounds below hold from there on
    bound = (c_low * W * W) ** 2
    sizes = [abs(c) * bound**k for k, c in enumerate(beam.discriminant())]
    need(2 * sizes[-1] > sum(sizes), "branch points may lie beyond the reach")
    b1, b2, b3, b4, b5 = _bounds(beam, R)
    free = 1 - eta / (c_low * W * W)
    need(free > 0, "the reach is too small")
    s = _above(2 * R2[1] * b1 + free**-2 - 1)
    need(2 * s < 1 and 2 * b2 < 1 and 2 * b4 < 1, "the reach is too small")
    g = R2[1] / 2
    delta, h = _above((b2 + s) / (1 - s) * g), _above((b3 + 2 * b2) / (1 - b2))
    product = _cascade(len(vehicle.sites), g, delta, h)
    if vehicle.gap is None:
        return
    t = _above(2 * R2[1] * b5 / (1 - s))
    decay = W * (R2[0] / 2 - b4) * vehicle.gap
    small = _above(Fraction(exp(ball(-decay)).upper())) * t
    N = len(vehicle.sites)
    inner = 1 + (N - 1) * (t + small) ** 2
    power = inner ** ((N - 1) // 2) * (root_bounds(inner, 1, 2)[1] if (N - 1) % 2 else 1)
    need(N * root_bounds(Fraction(N - 1), 1, 2)[1] * small * power < product, "waves between masses may add up")


def _cascade(n: int, g: Fraction, delta: Fraction, h: Fraction) -> Fraction:
    """A bound below |det(1 + T)|."""
    Z, product = _above(g + delta), Fraction(1)
    for _ in range(n - 1):
        lost = (g + delta) * Z
        need(lost < 1, "too many masses for the reach")
        product *= 1 - lost
        if Z <= 1:
            square = 1 - (3 - R5[1]) * (1 - Z * Z) / (R2[1] + Z) ** 2
        else:
            need(R2[0] > Z, "too many masses for the reach")
            square = 1 + (Z * Z - 1) / (R2[0] - Z) ** 2
        first = root_bounds(_above(square), 1, 2)[1]
        Z = _above(first + (Z * (2 * delta + (g + delta) * h) + delta + first * Z * delta) / (1 - lost))
    return product
