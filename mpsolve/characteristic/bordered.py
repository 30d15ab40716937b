"""The characteristic matrix of a reduced problem on discs: det is Δ̂ up to a constant.

Direct contacts (tight, alone on their body) are eliminated: y_i = −(Gλ)_j/b. Unknowns are the other bodies and λ;
rows are all bodies, then the contacts that are not direct. In the full matrix (row j, column y_i) holds b, alone in
its row among the bodies; column operations clear the rest of the row, so the determinants differ by the factor ±b.
"""

from __future__ import annotations

from dataclasses import dataclass
from fractions import Fraction
from functools import cached_property
from typing import Any

import numpy as np

from mpsolve.characteristic.discs import receptances, split
from mpsolve.characteristic.table import Table
from mpsolve.numbers.jets import TINY, UP, Jet, U, nearest
from mpsolve.problem.reduced import Reduced


@dataclass(frozen=True)
class Direct:
    """Contact `contact` moves with body `body` alone: Bᵀ has the single entry `b` there."""

    body: int
    contact: int
    b: Fraction


@dataclass(frozen=True)
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

    def evaluate(self, m: Any, r: Any, up: int, nodes: Any = None) -> tuple[Any, Jet, Any]:
        """(splittings, G between the places as jets of shape (discs, places, places), where it is bounded)."""
        s = split(self.D, m, r, up, nodes)
        distances, pairs = self.distances
        values = receptances(self.N, self.D, s, distances)
        return s, values.jet[:, pairs], values.good

    def matrix(self, G: Jet, m: Any) -> Jet:
        """The reduced characteristic matrix on the discs round m, from G between the places."""
        contact = np.array(self.reduced.index)
        G = G[:, contact[:, None], contact[None, :]]
        S = self._pencil(m, G.r)
        bodies = [d.body for d in self.direct]
        rest = [i for i in range(len(self.B)) if i not in bodies]
        right = self._constant(-self.B, G.r)
        if bodies:
            factors = np.array([-nearest(1 / d.b) for d in self.direct])  # each rounded: within the 2 u of `*`
            right = right + (S[:, :, bodies] * factors) @ G[:, [d.contact for d in self.direct], :]
        top = _beside(S[:, :, rest], right)
        indirect = [j for j in range(len(contact)) if j not in [d.contact for d in self.direct]]
        if not indirect:
            return top
        compliance = self._constant(np.diag(self.h)[indirect], G.r)
        low = _beside(self._constant(self.B.T[np.ix_(indirect, rest)], G.r), G[:, indirect, :] + compliance)
        return _joined(top, low, 1)

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
        return _joined(column, self._constant(np.zeros((len(indirect), 1)), r), 1)

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

    def _constant(self, matrix: Any, r: Any) -> Jet:
        a = np.broadcast_to(matrix.astype(complex), (len(r), *matrix.shape))
        return Jet(a, np.zeros(a.shape, complex), 2 * U * np.abs(a), r)


def direct_contacts(reduced: Reduced) -> tuple[Direct, ...]:
    """The contacts that are tight and alone on a body that has no other contact."""
    out = []
    for j in range(reduced.contacts):
        bodies = [i for i, row in enumerate(reduced.B) if row[j]]
        if reduced.h[j] == 0 and len(bodies) == 1 and sum(map(bool, reduced.B[bodies[0]])) == 1:
            out.append(Direct(bodies[0], j, reduced.B[bodies[0]][j]))
    return tuple(out)


def _beside(left: Jet, right: Jet) -> Jet:
    return _joined(left, right, 2)


def _joined(one: Jet, other: Jet, axis: int) -> Jet:
    a, b, e = (np.concatenate([getattr(one, key), getattr(other, key)], axis) for key in "abe")
    return Jet(a, b, e, other.r)
