"""The waves of the track: p-roots in discs that follow σ, their sides, and the receptances, in two ways.

Roots. Let z_k(t) = z_k + z'_k t be moving nodes. By partial fractions d/(lead·Π(P − z_i)) = 1 + Σ W_i/(P − z_i) with
W_i = d(z_i)/(lead·Π_{j≠i}(z_i − z_j)). Where Σ|W_i|/|P − z_i| < 1 on the circle |P − z_k| = ε_k with no other node
in it, the disc holds as many roots as nodes (Rouché): one. Disjoint discs hold all n.
Sides. Discs of two pieces of σ hold the same roots at a common σ; where each disc of one meets just one of the other,
the root is the same.
Amplitudes. w = Σ_U c_k e^{P_k ξ} ahead of the load and Σ_L c_k e^{P_k ξ} behind it solve d(∂, σ)w = N(∂, σ)δ if the
jumps of w^(j) at 0 are the coefficients h_j of N/d = Σ h_j P^{−j−1} (j < n): a linear system, used at single points.
On discs c_k = ±N/(lead·Π_{i≠k}(P_k − P_i)).
"""

from __future__ import annotations

from fractions import Fraction
from typing import Any

import balls as b
from balls import ONE, ZERO, Ball, UnclearError, ball, exp, from_complex, up
from exact import Terms
from reading import Point
from taylor import Line, constant, solve
from track import Track

THIN, WIDE = 128, 72
"""Bits at single points and on discs."""


def by_powers(p: Terms) -> list[list[Fraction]]:
    """The coefficients of P^i, as lists of those of σ^j."""
    out: list[list[Fraction]] = [[] for _ in range(1 + max(i for i, _ in p))]
    for (i, j), c in p.items():
        out[i].extend([Fraction(0)] * (j + 1 - len(out[i])))
        out[i][j] = c
    return out


def sigma(q: Point) -> Ball:
    """σ = iq."""
    return ball(-q[1], q[0])


def horner(coefficients: list[Any], at: Any, zero: Any) -> Any:
    out = zero
    for c in reversed(coefficients):
        out = out * at + c
    return out


def aberth(c: list[complex], guesses: list[complex]) -> list[complex]:
    """Float roots of Σ c_i P^i. Nothing rests on them."""
    z = list(guesses)
    for _ in range(200):
        largest = 0.0
        for k in range(len(z)):
            value, slope = 0j, 0j
            for x in reversed(c):
                slope = slope * z[k] + value
                value = value * z[k] + x
            if value == 0:
                continue
            newton = slope / value - sum(1 / (z[k] - y) for i, y in enumerate(z) if i != k and y != z[k])
            if newton:
                z[k] -= 1 / newton
                largest = max(largest, abs(1 / newton) / (abs(z[k]) + 1e-300))
        if largest < 1e-15:
            break
    return z


class Thin:
    """The p-roots at one σ, in balls, and which are of U."""

    def __init__(self, at: Ball, roots: list[Ball], upper: list[bool]) -> None:
        self.at, self.roots, self.upper = at, roots, upper


class Waves:
    """Roots and receptances of one track."""

    def __init__(self, track: Track) -> None:
        self.d, self.N, self.n = by_powers(track.d), by_powers(track.moving_n), track.degree
        self.kept: dict[int, tuple[list[list[Ball]], list[list[Ball]]]] = {}

    def balls(self) -> tuple[list[list[Ball]], list[list[Ball]]]:
        if b.bits not in self.kept:
            self.kept[b.bits] = tuple([[ball(c) for c in row] for row in p] for p in (self.d, self.N))  # type: ignore[assignment]
        return self.kept[b.bits]

    def guesses(self, at: complex, near: list[complex] | None) -> list[complex]:
        c = [sum(complex(float(x)) * at**j for j, x in enumerate(row)) for row in self.d]
        if near is None:
            radius = max(abs(x / c[-1]) ** (1 / (self.n - i)) for i, x in enumerate(c[:-1]))
            near = [radius * complex(0.8, 0.6) * complex(0.3, 0.954) ** k * (1 + 0.01 * k) for k in range(self.n)]
        return aberth(c, near)

    def enclosed(self, at: Ball, r: float, z: list[Ball], slopes: list[Ball]) -> list[Line]:
        """The roots as lines in t over |σ − at| ≤ r. Raises UnclearError if they are not proved apart."""
        D, _ = self.balls()
        s, zero = Line(at, ONE, 0.0, r), constant(ZERO, r)
        rows = [horner([constant(c, r) for c in row], s, zero) for row in D]
        nodes = [Line(y, w, 0.0, r) for y, w in zip(z, slopes, strict=True)]
        over = rows[-1].inverse()
        weights, apart = [], [[0.0] * self.n for _ in z]
        for k, node in enumerate(nodes):
            W = horner(rows, node, zero) * over
            for i, other in enumerate(nodes):
                if i != k:
                    gap = node - other
                    apart[k][i] = gap.lower()
                    W = W * gap.inverse()
            weights.append(W.upper())
        return [Line(z[k], slopes[k], e, r) for k, e in enumerate(_radii(weights, apart))]

    def thin(self, at: Ball, near: list[complex]) -> list[Ball]:
        """The roots at one point, in small balls, in the order of the guesses."""
        D, _ = self.balls()
        rows = [horner(row, at, ZERO) for row in D]
        z = [from_complex(y) for y in near]
        for _ in range(max(2, b.bits.bit_length() - 4)):
            z = [
                (y - horner(rows, y, ZERO) / horner([c * ball(i) for i, c in enumerate(rows)][1:], y, ZERO)).mid()
                for y in z
            ]
        return [line.a.wide(line.rest) for line in self.enclosed(at, 0.0, z, [ZERO] * self.n)]

    def piece(self, at: Ball, r: float, near: list[complex]) -> list[Line]:
        """The roots over a disc."""
        where = at.complex()
        z = self.guesses(where, near)
        slopes = []
        for y in z:
            part = [sum(complex(float(x)) * j * where ** (j - 1) for j, x in enumerate(row) if j) for row in self.d]
            whole = [sum(complex(float(x)) * where**j for j, x in enumerate(row)) for row in self.d]
            below = sum(i * c * y ** (i - 1) for i, c in enumerate(whole) if i)
            if below == 0:
                raise UnclearError("two p-roots meet")
            slopes.append(from_complex(-sum(c * y**i for i, c in enumerate(part)) / below))
        return self.enclosed(at, r, [from_complex(y) for y in z], slopes)

    def start(self, at: Ball) -> Thin:
        """At σ > 0: the sides by the signs of Re P."""
        roots = self.thin(at, self.guesses(at.complex(), None))
        return Thin(at, roots, [sign < 0 for sign in self.signs(roots)])

    def signs(self, roots: list[Ball]) -> list[int]:
        """The signs of Re P, none 0."""
        out = [y.sign() for y in roots]
        if 0 in out:
            raise UnclearError("a p-root may be imaginary")
        return out

    def follow(self, begin: Thin, end: Point) -> tuple[Thin, list[Line], Ball, float]:
        """From one point to the next: the end, and the roots on the disc between, with its middle and radius."""
        last = sigma(end)
        at = ((begin.at + last) * ball(Fraction(1, 2))).mid()
        ends = begin.at - at, last - at
        r = max(t.upper() for t in ends) * (1 + 2.0**-40)
        near = [y.complex() for y in begin.roots]
        before = b.set_bits(WIDE)
        try:
            lines = self.piece(at, r, near)
        finally:
            b.set_bits(before)
        upper = linked(begin.roots, begin.upper, [line.at(ends[0]) for line in lines])
        roots = self.thin(last, self.guesses(last.complex(), [line.at(ends[1]).complex() for line in lines]))
        there = linked([line.at(ends[1]) for line in lines], upper, roots)
        order = sorted(range(self.n), key=lambda k: not upper[k])
        return Thin(last, roots, there), [lines[k] for k in order], at, r

    def amplitudes(self, thin: Thin) -> list[Ball]:
        """Of e^{Pξ} in G for each root, from the jumps."""
        D, N = self.balls()
        d = [horner(row, thin.at, ZERO) for row in D]
        top = [horner(row, thin.at, ZERO) for row in N] + [ZERO] * self.n
        over = d[-1].inverse()
        h: list[Ball] = []
        for j in range(self.n):
            rest = top[self.n - 1 - j]
            for i in range(j):
                rest = rest - d[self.n - (j - i)] * h[i]
            h.append(rest * over)
        row, rows = [ONE if u else -ONE for u in thin.upper], []
        for _ in range(self.n):
            rows.append(row)
            row = [x * y for x, y in zip(row, thin.roots, strict=True)]
        return [x[0] for x in solve(rows, [[x] for x in h])]

    def receptances(self, thin: Thin, gaps: list[Fraction]) -> dict[Fraction, Ball]:
        """G at single distances."""
        c, out = self.amplitudes(thin), {}
        for gap in gaps:
            total, distance = ZERO, ball(gap)
            for amplitude, root, u in zip(c, thin.roots, thin.upper, strict=True):
                if u == (gap >= 0):
                    total = total + amplitude * exp(root * distance)
            out[gap] = total
        return out

    def receptance_lines(
        self, lines: list[Line], ups: int, at: Ball, r: float, gaps: list[Fraction]
    ) -> dict[Fraction, Line]:
        """G over a disc; the first roots are those of U."""
        D, N = self.balls()
        s, zero = Line(at, ONE, 0.0, r), constant(ZERO, r)
        lead = horner([constant(c, r) for c in D[-1]], s, zero).inverse()
        rows = [horner([constant(c, r) for c in row], s, zero) for row in N]
        amplitudes = []
        for k, root in enumerate(lines):
            c = horner(rows, root, zero) * lead
            for i, other in enumerate(lines):
                if i != k:
                    c = c * (root - other).inverse()
            amplitudes.append(c if k < ups else -c)
        out = {}
        for gap in gaps:
            total = zero
            for k, (c, root) in enumerate(zip(amplitudes, lines, strict=True)):
                if (k < ups) == (gap >= 0):
                    total = total + (c * root.times(ball(gap)).exp() if gap else c)
            out[gap] = total
        return out


def _radii(weights: list[float], apart: list[list[float]]) -> list[float]:
    """ε_k with |W_k|/ε_k + Σ|W_i|/(|z_k − z_i| − ε_k) < 1, discs disjoint; or UnclearError."""
    out, n = [], len(weights)
    for k, w in enumerate(weights):
        others = [i for i in range(n) if i != k]
        e = max(1.1 * w, 1e-280)
        for _ in range(3):
            if not all(apart[k][i] > 1.01 * e for i in others):
                raise UnclearError("p-roots are not apart")
            g = sum(weights[i] / (apart[k][i] - e) for i in others)
            if not g < 0.9:
                raise UnclearError("p-roots are not apart")
            e = max(1.02 * w / (1 - g), 1e-280)
        if not all(apart[k][i] > 1.01 * e for i in others):
            raise UnclearError("p-roots are not apart")
        if not up(w / e + sum(up(weights[i] / ((apart[k][i] - e) * (1 - 2.0**-40))) for i in others)) < 1:
            raise UnclearError("p-roots are not apart")
        out.append(e)
    if not all(up(out[i] + out[k]) < apart[k][i] for k in range(n) for i in range(n) if i != k):
        raise UnclearError("p-roots are not apart")
    return out


def linked(ones: list[Ball], marks: list[bool], others: list[Ball]) -> list[bool]:
    """The marks of the others, each of which must meet just one of the ones."""
    taken = []
    for y in others:
        met = [k for k, z in enumerate(ones) if not (z - y).lower() > 0]
        if len(met) != 1:
            raise UnclearError("p-roots cannot be told from each other")
        taken.append(met[0])
    if len(set(taken)) != len(ones):
        raise UnclearError("p-roots cannot be told from each other")
    return [marks[k] for k in taken]
