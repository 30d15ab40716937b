"""The characteristic matrix of a reduced problem on discs: det is Δ̂ up to a constant (see `bordering`)."""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction
from functools import cached_property
from typing import Any

import numpy as np

from mpsolve.characteristic.bordering import Bordering, distances_of
from mpsolve.characteristic.discs import Splittings, split
from mpsolve.characteristic.residues import receptances, waves
from mpsolve.characteristic.table import Table
from mpsolve.frozen import frozen
from mpsolve.numbers.arrays import Complexes, Integers, Reals, Truths
from mpsolve.numbers.jets import TINY, UP, Jet, U, joined, nearest
from mpsolve.problem.reduced import Reduced


@frozen
class Arrays:
    """A reduced problem as float arrays; each entry is the exact one rounded to nearest."""

    reduced: Reduced

    @cached_property
    def D(self) -> Table:
        return Table.of(self.reduced.guide.D)

    @cached_property
    def N(self) -> Table:
        return Table.of(self.reduced.guide.N)

    @cached_property
    def _alone(self) -> tuple[Bordering, Reals]:
        return self._bordering(0)

    @cached_property
    def _beside(self) -> tuple[Bordering, Any]:
        return self._bordering(1)

    def _bordering(self, waves: int) -> tuple[Bordering, Reals]:
        border = Bordering.of(self.reduced, waves=waves)
        return border, self._table(border.polynomials)

    def _table(self, polynomials: Sequence[Sequence[Fraction]]) -> Reals:
        """Their coefficients in σ, shape (3, polynomials)."""
        return np.array([self._about(*f, *[Fraction(0)] * (3 - len(f))) for f in polynomials]).T

    def _about(self, *f: Fraction) -> list[float]:
        return list(map(nearest, f))

    @cached_property
    def distances(self) -> tuple[Reals, Integers]:
        """The signed distances of pairs of places, once each, and for each pair of places its number."""
        exact, pairs = distances_of(self.reduced.places)
        return np.array([nearest(x) for x in exact]), np.array(pairs)

    @property
    def shift(self) -> complex:
        """The P from which the waves are counted."""
        return 0j

    def evaluate(
        self, m: Complexes, r: Reals, up: int, nodes: Complexes | None = None
    ) -> tuple[Splittings, Jet, Truths]:
        """(splittings, G between the places as jets of shape (discs, places, places), where it is bounded)."""
        s = split(self.D, m, r, up, nodes)
        distances, pairs = self.distances
        values = receptances(self.N, self.D, s, distances)
        return s, values.jet[:, pairs], values.good

    def without_pole(
        self, m: Complexes, r: Reals, up: int, nodes: Complexes, at: complex
    ) -> tuple[Splittings, Jet, Jet, Truths]:
        """(splittings, H, g, where they are bounded): G(ξ) = e^{at·ξ}(g + H(ξ)), g = G(0), whatever `at` is.

        Next to a branch point where one pair of roots meets, at P = `at`, g alone has a pole; H is at least bounded.
        """
        s = split(self.D, m, r, up, nodes)
        distances, pairs = self.distances
        weight, p, alone = waves(self.N, self.D, s)
        parts = []
        for x in distances:
            side, sign = (slice(0, up), 1.0) if x >= 0 else (slice(up, None), -1.0)
            moved = (p[:, side] + (self.shift - at)) * x
            one, lost = ((moved.exp() + -1.0) * weight[:, side] * sign).sum(1), 4 * U * abs(at * x)
            turned = one * np.exp(at * x)
            size = np.abs(turned.a) + np.abs(turned.b) * s.r
            parts.append(Jet(turned.a, turned.b, turned.e + lost * size, s.r))
        H, g = joined([part[:, None] for part in parts]), weight[:, :up].sum(1)
        good = alone & s.good & np.isfinite(H.e).all(1) & np.isfinite(g.e)
        return s, H[:, pairs], g, good

    def beside_pole(self, H: Jet, g: Jet, m: Complexes, at: complex) -> Jet:
        """A matrix with the determinant Δ̂/g up to a constant, from H and g of `without_pole`."""
        places = np.array([nearest(self.reduced.places[k]) for k in self.reduced.index])
        v, back = (_constant(np.exp(sign * at * places), H.r, 4 * U * np.abs(at * places)) for sign in (1, -1))
        return self._filled(self._beside, m, [self._by_distance(H), v, -back, g.inverse()[:, None]])

    def matrix(self, G: Jet, m: Complexes) -> Jet:
        """The reduced characteristic matrix on the discs round m, from G between the places."""
        return self._filled(self._alone, m, [self._by_distance(G)])

    def _by_distance(self, G: Jet) -> Jet:
        contact = np.array(self.reduced.index)
        first, second = self._alone[0].one_each
        return G[:, contact[first], contact[second]]

    def _filled(self, bordering: tuple[Bordering, Reals], m: Complexes, g: list[Jet]) -> Jet:
        border, table = bordering
        filled: Jet = border.matrix(_polynomials(table, m, g[0].r), joined(g), joined)
        return filled

    def shaken(self, contact: int, m: Complexes, r: Reals) -> Jet:
        """The right side of `matrix`·x for an unevenness of the rail under one contact, shape (discs, n, 1).

        It has the size 1, or for a direct contact the size b/S of its body where that is coupled to no other body: as
        b/S times the unevenness acts like a unit force, it has a meaning at σ = 0 too.
        """
        border, n = self._alone[0], self.reduced.bodies
        held = {one.contact: one for one in border.direct}
        indirect = [j for j in range(self.reduced.contacts) if j not in held]
        column = [(Fraction(0),)] * (n + len(indirect))
        if contact not in held:
            column[n + indirect.index(contact)] = (Fraction(1),)
        else:
            body, b = held[contact].body, held[contact].b
            column[:n] = [tuple(-rows[i][body] / b for rows in self.reduced.S) for i in range(n)]
            if not any(any(f) for i, f in enumerate(column) if i != body):
                column[body] = (Fraction(-1),)
        return _polynomials(self._table(column), m, r)[:, :, None]

    @property
    def first_force(self) -> int:
        """The number of the unknown of `matrix` that is the first contact's force; those of the others follow it."""
        return len(self._alone[0].kept)


def _polynomials(table: Reals, m: Complexes, r: Reals) -> Jet:
    """On the discs, from coefficients of which each is rounded to nearest."""
    c0, c1, c2 = table
    z, radius = m[:, None], r[:, None]
    size = np.abs(c0) + np.abs(c1 * z) + np.abs(c2 * z * z) + (np.abs(c1) + 2 * np.abs(c2 * z)) * radius
    e = (np.abs(c2) * radius * radius + 32 * U * size) * UP + TINY
    return Jet(c0 + c1 * z + c2 * z * z, c1 + 2 * c2 * z, e, r)


def _constant(values: Any, r: Reals, lost: Any) -> Jet:
    """lost: a bound of relative errors beside those of rounding."""
    a = np.broadcast_to(values.astype(complex), (len(r), *values.shape))
    return Jet(a, np.zeros(a.shape, complex), (2 * U + lost) * np.abs(a), r)
