"""The characteristic matrix of a reduced problem on discs: det is Δ̂ up to a constant.

Direct contacts (tight, alone on their body) are eliminated: y_i = −(Gλ)_j/b. Unknowns are the other bodies and λ;
rows are all bodies, then the contacts that are not direct. In the full matrix (row j, column y_i) holds b, alone in
its row among the bodies; column operations clear the rest of the row, so the determinants differ by the factor ±b.
"""

from __future__ import annotations

from fractions import Fraction
from functools import cached_property
from typing import Any

import numpy as np

from mpsolve.characteristic.discs import split
from mpsolve.characteristic.residues import receptances, waves
from mpsolve.characteristic.table import Table
from mpsolve.frozen import frozen
from mpsolve.numbers.jets import TINY, UP, Jet, U, nearest
from mpsolve.problem.reduced import Reduced


@frozen
class Direct:
    """Contact `contact` moves with body `body` alone: Bᵀ has the single entry `b` there."""

    body: int
    contact: int
    b: Fraction


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
    def S(self) -> Any:
        return np.array([[[nearest(x) for x in row] for row in rows] for rows in self.reduced.S])

    @cached_property
    def B(self) -> Any:
        return np.array([[nearest(x) for x in row] for row in self.reduced.B])

    @cached_property
    def h(self) -> Any:
        return np.array([nearest(x) for x in self.reduced.h])

    @cached_property
    def direct(self) -> tuple[Direct, ...]:
        return direct_contacts(self.reduced)

    @cached_property
    def distances(self) -> tuple[Any, Any]:
        """The signed distances of pairs of places, once each, and for each pair of places its number."""
        places = self.reduced.places
        exact = sorted({a - b for a in places for b in places})
        number = {x: k for k, x in enumerate(exact)}
        pairs = np.array([[number[a - b] for b in places] for a in places])
        return np.array([nearest(x) for x in exact]), pairs

    @property
    def shift(self) -> complex:
        """The P from which the waves are counted."""
        return 0j

    def evaluate(self, m: Any, r: Any, up: int, nodes: Any = None) -> tuple[Any, Jet, Any]:
        """(splittings, G between the places as jets of shape (discs, places, places), where it is bounded)."""
        s = split(self.D, m, r, up, nodes)
        distances, pairs = self.distances
        values = receptances(self.N, self.D, s, distances)
        return s, values.jet[:, pairs], values.good

    def without_pole(self, m: Any, r: Any, up: int, nodes: Any, at: complex) -> tuple[Any, Jet, Jet, Any]:
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
        a, b, e = (np.stack([getattr(part, key) for part in parts], 1) for key in "abe")
        g = weight[:, :up].sum(1)
        good = alone & s.good & np.isfinite(e).all(1) & np.isfinite(g.e)
        return s, Jet(a, b, e, s.r)[:, pairs], g, good

    def beside_pole(self, H: Jet, g: Jet, m: Any, at: complex) -> Jet:
        """A matrix with the determinant Δ̂/g up to a constant, from H and g of `without_pole`."""
        contact = np.array(self.reduced.index)
        places = np.array([nearest(x) for x in self.reduced.places])[contact]
        H = H[:, contact[:, None], contact[None, :]]
        v, back = (self._constant(np.exp(sign * at * places), H.r, 4 * U * np.abs(at * places)) for sign in (1, -1))
        above = self._rows(joined(H, v[:, :, None], 2), m)
        width = above.a.shape[2] - len(contact) - 1
        low = joined(self._constant(np.zeros(width), H.r), -back, 1)
        corner = g.inverse()
        return joined(above, joined(low, corner[:, None], 1)[:, None, :], 1)

    def matrix(self, G: Jet, m: Any) -> Jet:
        """The reduced characteristic matrix on the discs round m, from G between the places."""
        contact = np.array(self.reduced.index)
        return self._rows(G[:, contact[:, None], contact[None, :]], m)

    def _rows(self, G: Jet, m: Any) -> Jet:
        """The rows of bodies and of contacts that are not direct; G may have more columns than contacts."""
        more = np.zeros((len(self.B), G.a.shape[2] - len(self.reduced.index)))
        S = self._pencil(m, G.r)
        bodies = [d.body for d in self.direct]
        rest = [i for i in range(len(self.B)) if i not in bodies]
        right = self._constant(np.hstack([-self.B, more]), G.r)
        if bodies:
            factors = np.array([-nearest(1 / d.b) for d in self.direct])  # each rounded: within the 2 u of `*`
            right = right + (S[:, :, bodies] * factors) @ G[:, [d.contact for d in self.direct], :]
        top = _beside(S[:, :, rest], right)
        contacts = len(self.reduced.index)
        indirect = [j for j in range(contacts) if j not in [d.contact for d in self.direct]]
        if not indirect:
            return top
        compliance = self._constant(np.hstack([np.diag(self.h), more[:1].repeat(contacts, 0)])[indirect], G.r)
        low = _beside(self._constant(self.B.T[np.ix_(indirect, rest)], G.r), G[:, indirect, :] + compliance)
        return joined(top, low, 1)

    def shaken(self, contact: int, m: Any, r: Any) -> Jet:
        """The right side of `matrix`·x for an unevenness of the rail under one contact, shape (discs, n, 1).

        It has the size 1, or for a direct contact the size b/S of its body where that is coupled to no other body: as
        b/S times the unevenness acts like a unit force, it has a meaning at σ = 0 too.
        """
        held = {d.contact: d for d in self.direct}
        indirect = [j for j in range(len(self.h)) if j not in held]
        n = len(self.B) + len(indirect)
        if contact not in held:
            unit = np.zeros((n, 1))
            unit[len(self.B) + indirect.index(contact)] = 1
            return self._constant(unit, r)
        body = held[contact].body
        others = [i for i in range(len(self.B)) if i != body]
        if not self.S[:, others, body].any():
            unit = np.zeros((n, 1))
            unit[body] = -1
            return self._constant(unit, r)
        column = self._pencil(m, r)[:, :, body : body + 1] * -nearest(1 / held[contact].b)
        return joined(column, self._constant(np.zeros((len(indirect), 1)), r), 1)

    @property
    def first_force(self) -> int:
        """The number of the unknown of `matrix` that is the first contact's force; those of the others follow it."""
        return len(self.B) - len(self.direct)

    def _pencil(self, m: Any, r: Any) -> Jet:
        """S on the discs."""
        S0, S1, S2 = self.S[:, None]
        z = m[:, None, None]
        radius = r[:, None, None]
        size = np.abs(S0) + np.abs(S1 * z) + np.abs(S2 * z * z) + (np.abs(S1) + 2 * np.abs(S2 * z)) * radius
        e = (np.abs(S2) * radius * radius + 32 * U * size) * UP + TINY
        return Jet(S0 + S1 * z + S2 * z * z, S1 + 2 * S2 * z, e, r)

    def _constant(self, matrix: Any, r: Any, lost: Any = 0.0) -> Jet:
        """lost: a bound of relative errors beside those of rounding."""
        a = np.broadcast_to(matrix.astype(complex), (len(r), *matrix.shape))
        return Jet(a, np.zeros(a.shape, complex), (2 * U + lost) * np.abs(a), r)


def direct_contacts(reduced: Reduced) -> tuple[Direct, ...]:
    """The contacts that are tight and alone on a body that has no other contact."""
    out = []
    for j in range(reduced.contacts):
        bodies = [i for i, row in enumerate(reduced.B) if row[j]]
        if reduced.h[j] == 0 and len(bodies) == 1 and sum(map(bool, reduced.B[bodies[0]])) == 1:
            out.append(Direct(bodies[0], j, reduced.B[bodies[0]][j]))
    return tuple(out)


def _beside(left: Jet, right: Jet) -> Jet:
    return joined(left, right, 2)


def joined(one: Jet, other: Jet, axis: int) -> Jet:
    a, b, e = (np.concatenate([getattr(one, key), getattr(other, key)], axis) for key in "abe")
    return Jet(a, b, e, other.r)
