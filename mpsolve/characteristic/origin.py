"""The receptance next to q = 0 where some waves come to P = 0 there: on floating ice, two.

Let D have no terms of an order below k in P and σ, and a term P^k. Then k roots are P = ζσ with E(ζ, σ) = 0,
E = D(ζσ, σ)/σ^k, and the others stay away from 0. Each of both kinds is told apart over a disc round σ = 0, the first
as ζ, and so is its residue N/D_P = σ^(l+1−k) N(ζσ, σ)/σ^l / E_ζ. For σ > 0 in the disc a root is decaying where
Re P < 0, or Re ζ < 0; as no p-root is imaginary in Re σ > 0 these are the roots of U there. So G continues to the
whole disc, though U and L have a common root at σ = 0 where the waves run to both sides (SPEC, section 4.8).
"""

from __future__ import annotations

from functools import cached_property
from typing import Any

import numpy as np

from mpsolve.characteristic.discs import Splittings, near_roots
from mpsolve.characteristic.residues import Receptances, Roots, isolated, summed, told_apart, weights
from mpsolve.characteristic.table import Table
from mpsolve.frozen import frozen
from mpsolve.numbers.arrays import Complexes, Reals, Truths
from mpsolve.numbers.jets import UP, Jet, U
from mpsolve.problem.reduced import Guide
from mpsolve.tracks.waveguide import Polynomial


def waves_meet_at_zero(guide: Guide) -> bool:
    """Whether D(P, σ) has no terms of first order: floating ice, a string without foundation and damping."""
    return _order(guide.D) > 1


@frozen
class Origin:
    """D, N: tables in P; E, F: those in ζ of D and N over powers of σ; power: of σ in the residues of slow roots.

    slow, fast: floats near ζ and P at σ = 0, those of U first; up: their numbers in U.
    """

    D: Table
    N: Table
    E: Table
    F: Table
    power: int
    slow: Complexes
    fast: Complexes
    up: tuple[int, int]

    @cached_property
    def at_zero(self) -> tuple[Complexes, Reals]:
        return self.D.in_time(_ZERO)

    def __call__(self, radius: float, distances: Any) -> Receptances:
        """G at each signed distance over |σ| ≤ radius."""
        slow, fast, good = self._roots(radius)
        if not good[0]:
            nothing = np.full((1, len(distances)), np.inf)
            return Receptances(Jet(nothing + 0j, nothing + 0j, nothing, np.array([radius])), good)
        sigma = Jet(np.zeros((1, 1), complex), np.ones((1, 1), complex), np.zeros((1, 1)), np.array([radius]))
        weight, zeta = weights(self.F, _ZERO, self.slow, slow)
        for _ in range(self.power):
            weight = sigma * weight
        other, P = weights(self.N, _ZERO, self.fast, fast)
        a, b = self.up
        return summed(_beside(weight, other, a, b), _beside(sigma * zeta, P, a, b), good, a + b, distances)

    def links(self, thin: Splittings, sigma: complex) -> bool:
        """Whether the pair of a thin splitting at σ is the one that G is made of on |σ'| ≤ |σ|.

        The discs of the splitting hold all p-roots, each on its side: no disc round a root of U meets one of L.
        """
        radius = float(abs(sigma) * UP)
        slow, fast, good = self._roots(radius)
        with np.errstate(all="ignore"):
            held, alone = told_apart(self.D, thin)
        if not (good[0] and alone[0] and thin.good[0]):
            return False
        z = np.concatenate([self.slow[0] * sigma, self.fast[0]])
        size = np.concatenate([slow.eps[0] * radius, fast.eps[0]]) + 8 * U * np.abs(z)
        a, b = self.up
        mine = np.concatenate([np.arange(len(self.slow[0])) < a, np.arange(len(self.fast[0])) < b])
        gap = np.abs(z[:, None] - thin.z) * (1 - 8 * U) - size[:, None] - held.eps
        across = mine[:, None] != (np.arange(thin.z.shape[1]) < thin.up)
        return bool((gap > 0)[across].all()) and a + b == thin.up

    def _roots(self, radius: float) -> tuple[Roots, Roots, Truths]:
        """The discs of ζ and of P, and whether all are told apart, on their sides of 0."""
        r = np.array([radius])
        with np.errstate(all="ignore"):  # on a disc that is far too large nothing is told apart
            slow = isolated(self.E, self.slow, *self.E.in_time(_ZERO), r)
            fast = isolated(self.D, self.fast, *self.at_zero, r)
        good = slow.done.all() & fast.done.all()
        for z, eps, up in ((self.slow[0], slow.eps[0], self.up[0]), (self.fast[0], fast.eps[0], self.up[1])):
            away = np.abs(z[:, None] - z) * (1 - 8 * U) - eps[:, None] - eps
            good &= (away > 0)[~np.eye(len(z), dtype=bool)].all()
            good &= (z.real + eps * UP < 0)[:up].all() and (z.real - eps * UP > 0)[up:].all()
        most = (np.abs(self.slow[0]) + slow.eps[0]).max() * radius * UP
        good &= ((np.abs(self.fast[0]) - fast.eps[0]) * (1 - 8 * U) > most).all()
        return slow, fast, np.array([good])


_ZERO = np.zeros(1, complex)


def origin(guide: Guide) -> Origin | None:
    """What is known next to q = 0 where waves come to P = 0; None where G is not bounded, or roots are not simple."""
    k, low = _order(guide.D), _order(guide.N)
    power = low + 1 - k
    if (k, 0) not in guide.D or power < 0:
        return None
    D, E = Table.of(guide.D), Table.of(_lowered(guide.D, k))
    at_rest = D.in_time(_ZERO)[0][:, 0, :]
    slow = _ordered(near_roots(E.in_time(_ZERO)[0][:, 0, : k + 1]))
    fast = _ordered(near_roots(at_rest[:, k:]))
    if not (np.isfinite(slow).all() and np.isfinite(fast).all()):
        return None
    up = (int((slow.real < 0).sum()), int((fast.real < 0).sum()))
    return Origin(D, Table.of(guide.N), E, Table.of(_lowered(guide.N, low)), power, slow, fast, up)


def _order(polynomial: Polynomial) -> int:
    return min(i + j for i, j in polynomial)


def _lowered(polynomial: Polynomial, order: int) -> Polynomial:
    """f(ζσ, σ)/σ^order in ζ and σ."""
    return {(i, i + j - order): c for (i, j), c in polynomial.items()}


def _ordered(z: Any) -> Any:
    return z[:, np.argsort(z[0].real)]


def _beside(one: Jet, other: Jet, a: int, b: int) -> Jet:
    """Both kinds of roots together, the first a and b of them in front."""

    def both(x: Any, y: Any) -> Any:
        return np.concatenate([x[:, :a], y[:, :b], x[:, a:], y[:, b:]], 1)

    return Jet(both(one.a, other.a), both(one.b, other.b), both(one.e, other.e), one.r)
