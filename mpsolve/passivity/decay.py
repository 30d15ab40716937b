"""At infinity the receptance vanishes: exact exponents from the Newton polygon of D(P, σ − vP).

As σ → ∞ each P-root behaves as c σ^θ, θ a slope of the polygon and c a nonzero root of its edge polynomial; where
these are simple, the weight N/D_P is O(σ^ω) with ω = max over N of (iθ + j) − (edge value of D − θ), in every
direction of Re σ ≥ 0, and |e^{Pξ}| ≤ 1 on the root's own side. If ω < 0 on every edge, G → 0. Roots that are carried
along, P ~ σ/v with s = σ − vP of lower order, are looked at in s in the same way.

How fast the short waves of a track run is told in floats: where contacts are as fast, nothing bounds what it gives.
"""

from __future__ import annotations

from collections.abc import Mapping
from fractions import Fraction
from math import comb

import numpy as np
from flint import fmpq, fmpq_poly

from mpsolve.frozen import frozen
from mpsolve.numbers.realroots import as_fmpq
from mpsolve.numbers.several import multiply, plus
from mpsolve.problem.reduced import Guide
from mpsolve.tracks.waveguide import Polynomial, halves


@frozen
class Edge:
    """Roots ~ c σ^slope; `roots`: the polynomial of c, without roots 0; weight: the exponent of N/D_P there."""

    slope: Fraction
    roots: fmpq_poly
    weight: Fraction

    def without(self, c: Fraction) -> tuple[fmpq_poly, int]:
        """`roots` without the root c, and how often it was there."""
        poly, factor, count = self.roots, fmpq_poly([-as_fmpq(c), fmpq(1)]), 0
        while poly.degree() > 0 and not poly % factor:
            poly, count = poly // factor, count + 1
        return poly, count


def edges(D: Polynomial, N: Polynomial) -> tuple[Edge, ...]:
    """The edges of the Newton polygon of D at σ = ∞, in ascending slope, with the exponent of the weight on each."""
    top: dict[int, int] = {}
    for i, j in D:
        top[i] = max(top.get(i, 0), j)
    powers = sorted(top)
    at, out = powers[0], []
    while at != powers[-1]:
        theta, end = min((Fraction(top[at] - top[i], i - at), -i) for i in powers if i > at)
        value = at * theta + top[at]
        weight = max(i * theta + j for i, j in N) - (value - theta)
        out.append(Edge(theta, _edge_polynomial(D, at, -end, value, theta), weight))
        at = -end
    return tuple(out)


def _edge_polynomial(D: Polynomial, first: int, last: int, value: Fraction, theta: Fraction) -> fmpq_poly:
    orders = [value - i * theta for i in range(first, last + 1)]
    found = (D.get((first + k, int(order)), 0) if order.denominator == 1 else 0 for k, order in enumerate(orders))
    return fmpq_poly([as_fmpq(Fraction(c)) for c in found])


def vanishes(D: Polynomial, N: Polynomial, v: Fraction) -> bool:
    """True if G → 0 as σ → ∞ in Re σ ≥ 0 is proved; D and N in P and σ, no p-root identically 0."""
    if min(i for i, _ in D) != 0:
        return False
    carried = 0
    for edge in edges(D, N):
        poly = edge.roots
        if v and edge.slope == 1:
            poly, carried = edge.without(1 / v)
            if poly.degree() == 0:
                continue
        if edge.weight >= 0 or not _squarefree(poly):
            return False
    return not carried or _carried_vanish(in_s(D, v), in_s(N, v), carried)


def _carried_vanish(D: Polynomial, N: Polynomial, count: int) -> bool:
    """The same for the `count` roots s of lower order than σ; D and N in s and σ."""
    found = 0
    least = min(i for i, _ in D)
    for edge in edges(D, N):
        if edge.slope >= 1:
            break
        if edge.weight >= 0 or not _squarefree(edge.roots):
            return False
        found += edge.roots.degree()
    return least == 0 and found == count


def in_s(polynomial: Mapping[tuple[int, int], Fraction], v: Fraction) -> Polynomial:
    """The polynomial in s and σ at P = (σ − s)/v, v > 0."""
    out: Polynomial = {}
    for (i, j), c in polynomial.items():
        for k in range(i + 1):
            key = (k, i - k + j)
            out[key] = out.get(key, Fraction(0)) + c * comb(i, k) * (-1) ** k / v**i
    return {key: c for key, c in out.items() if c}


def _squarefree(poly: fmpq_poly) -> bool:
    return bool(poly.gcd(poly.derivative()).degree() == 0)


def overtakes(guide: Guide, v: Fraction | float) -> bool:
    """Some short wave of the track runs at a speed up to v."""
    return slowest_short_wave(guide) <= float(v)


def slowest_short_wave(guide: Guide) -> float:
    """The least speed of the waves as they become short; infinite where there is none.

    They are real roots of the terms of |D|², at P = ip and s = iΩ, of the highest degree in p and Ω together.
    """
    even, odd = halves(guide.D_rest)
    square = plus(multiply(even, even), {(i, j + 1): c for (i, j), c in multiply(odd, odd).items()})
    top, by_p = max(i + j for i, j in square), max(i for i, _ in square)
    speeds = np.zeros(2 * by_p + 1)
    for (i, j), c in square.items():
        if i + j == top:
            speeds[2 * i] = float(c)  # of (Ω/p)^(2 (by_p − i)), descending
    roots = np.roots(speeds)
    real = roots[(np.abs(roots.imag) < 1e-6 * np.abs(roots)) & (roots.real > 0)].real
    return float(real.min(initial=np.inf))
