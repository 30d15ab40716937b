"""The characteristic matrix of a beam under loads that stand still, in a variable s that has no branch point.

At rest D = EI (P² + s P + π)(P² − s P + π), π = (s² + T/EI)/2, m z² = k − EI π²: all is a function of s, U has the
roots Re P < 0 where Re s > 0, and both branch points (s = 0, π = 0) are points like others. With p, q the waves of U,
p(0) = q'(0) = 1, p'(0) = q(0) = 0, and K the solution of D K = 0 that begins with x³/6EI,
G(x − y) = (p(x) p(−y) − π q(x) q(−y))/2EIπs, and K(y − x) more if x < y. Two more unknowns take the fraction out of
the matrix (SPEC2, at rest).
"""

from __future__ import annotations

from fractions import Fraction
from functools import cached_property
from math import factorial, sqrt
from typing import Any

import numpy as np

from mpsolve.characteristic.bordering import Bordering
from mpsolve.characteristic.disc_matrix import Arrays
from mpsolve.frozen import frozen
from mpsolve.numbers.jets import UP, Jet, U, joined, nearest

_TERMS, _MORE = 24, 4  # of the series of the waves, and for each unit of ρ x, ρ a bound of |P|
_WIDEST = 30.0


@frozen
class Resting(Arrays):
    """The arrays of the undamped problem of one half of a sheet, v = 0; places count from the middle."""

    @cached_property
    def beam(self) -> tuple[Fraction, Fraction, Fraction, Fraction]:
        """EI, T/EI, k and m."""
        D = self.reduced.guide.D
        return D[4, 0], D.get((2, 0), Fraction(0)) / D[4, 0], D[0, 0], D[0, 2]

    @property
    def single(self) -> bool:
        """Whether there is one place, so that one more unknown will do."""
        return len(self.reduced.places) == 1

    @cached_property
    def _bordered(self) -> tuple[Bordering, Any]:
        return self._bordering(1 if self.single else 2)

    def over(self, middle: Any, r: Any) -> Jet:
        """Matrices over |s − middle| ≤ r whose determinants are −4 (EI)² π s² Δ̂ (2 EI π s Δ̂ for one place)."""
        EI, A, k, m = self.beam
        s = Jet(middle.astype(complex), np.ones(len(r), complex), np.zeros(len(r)), r)
        pi = _plus(s * s, A) * 0.5
        tau = _root(_plus(pi * pi, -k / EI) * nearest(EI / m)) * 1j  # σ = iz, and −z² = (EI π² − k)/m
        rho = (s.size + np.sqrt(pi.size) + sqrt(abs(float(A)))) * (1 + 1e-9)
        (border, table), places = self._bordered, self.reduced.places
        x = np.array([nearest(places[i] - (places[0] + places[-1]) / 2) for i in self.reduced.index])
        gaps = np.array([nearest(max(-y, Fraction(0))) for y in border.distances])
        widest = np.max(rho * max(gaps.max(), np.abs(x).max()), initial=0.0)
        p, q, K = self._waves(s, pi, int(_TERMS + _MORE * min(widest, _WIDEST)))
        waves = [p] if self.single else [p, q]
        ahead, behind = ([_summed(f, sign * x, n, rho) for n, f in enumerate(waves)] for sign in (1, -1))
        parts = ((s, 0 * EI), (s * pi, 2 * EI), (s, -2 * EI))
        zero, first, second = ((one * nearest(c))[:, None] for one, c in parts)
        corner = [first] if self.single else [first, zero, zero, second]
        g = joined([_summed(K, gaps, 3, rho), *ahead, *(-f for f in behind), *corner])
        matrix: Jet = border.matrix(_composed(table, tau), g, joined)
        return matrix

    def _waves(self, s: Jet, pi: Jet, terms: int) -> tuple[list[Jet], list[Jet], list[Jet]]:
        """The derivatives at x = 0 of p, q, and of K."""
        EI, A, *_ = self.beam
        one, zero = s * 0.0 + 1.0, s * 0.0
        p, q, K = [one, zero], [zero, one], [zero, zero, zero, one * nearest(1 / EI)]
        square = pi * pi
        for n in range(terms - 2):
            for f in (p, q):
                f.append(-(s * f[n + 1] + pi * f[n]))
            if n < terms - 4:
                K.append(-(K[n + 2] * nearest(A) + square * K[n]) if n % 2 else zero)
        return p, q, K


def _composed(table: Any, tau: Jet) -> Jet:
    """Polynomials in σ at σ = τ, jets in s."""
    one = tau[:, None]
    rows = [Jet(zero := np.zeros((len(tau.r), len(c)), complex), zero, zero.real, tau.r) + c for c in table]
    total: Jet = rows[2]
    for row in rows[1::-1]:
        total = total * one + row
    return total


def _root(f: Jet) -> Jet:
    """√(−f), the real part positive; not bounded where f may vanish or turns far."""
    c = np.sqrt(-f.a)
    y = (np.abs(f.b) * f.r + f.e) / np.abs(f.a) * UP
    size = np.abs(c) * (1 + 4 * U)
    # |√(1 + x) − 1 − x/2| ≤ y²/8 (1 − y)^(−3/2)
    e = size * (y * y / 8 / (1 - y) ** 1.5 + 0.6 * f.e / np.abs(f.a) + 16 * U * (1 + y)) * UP
    with np.errstate(all="ignore"):
        return Jet(c, -f.b / (2 * c), np.where(y < 0.7, e, np.inf), f.r)


def _plus(f: Jet, number: Fraction) -> Jet:
    """A sum that may cancel."""
    total = f + nearest(number)
    return Jet(total.a, total.b, total.e + 4 * U * abs(float(number)), f.r)


def _summed(f: list[Jet], x: Any, order: int, rho: Any) -> Jet:
    """Σ f_n xⁿ/n! at each x, where |f_n| ≤ ρ^(n − order) |f_order|."""
    n = np.arange(len(f))
    with np.errstate(all="ignore"):
        power = x[None, :] ** n[:, None] / np.array([float(factorial(k)) for k in n])[:, None]
    a, b, e = (np.stack([getattr(one, key) for one in f], 1) for key in "abe")
    size = np.abs(power)
    r = f[0].r[:, None]
    last, y = len(f), rho[:, None] * np.abs(x)[None, :]
    with np.errstate(all="ignore"):  # of terms of which each is at most half of the one before
        tail = 4 * np.abs(a[:, order, None]) * np.abs(x) ** order * y ** (last - order) / float(factorial(last))
        lost = 4 * len(f) * U * ((np.abs(a) + np.abs(b) * r) @ size)
        return Jet(a @ power, b @ power, (e @ size + lost + np.where(y < _WIDEST, tail, np.inf)) * UP, f[0].r)
