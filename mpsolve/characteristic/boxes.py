"""D and its splitting for a family over boxes of (q, parameters), rigorous, as Taylor models.

Over a box the pair U·L = D/lead is found at nodes as on discs (`characteristic.discs`): the contraction holds for
complex u with |u_i| ≤ 1, so U and L are analytic there. At the middle of the box, on the real q-axis, the roots of U
are proved to have Re P < 0 and those of L Re P > 0, which no track that is damped loses for real q: so U is the
factor of the waves that decay ahead, at every real point of the box.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from typing import Any

import numpy as np

from mpsolve.characteristic.discs import Splittings, contraction, linked, side_nodes
from mpsolve.characteristic.start import start
from mpsolve.numbers.arrays import Complexes, Integers, Reals
from mpsolve.numbers.float64 import gaps
from mpsolve.numbers.forms import Forms
from mpsolve.numbers.jets import TINY, UP, U
from mpsolve.numbers.quadratic import Quadratic
from mpsolve.problem.family import Family
from mpsolve.problem.free_track import FreePolynomial

_APART = 0.7  # of how far a box moves two roots that meet: how far their nodes are put from their middle


@dataclass(frozen=True)
class Boxes:
    """Boxes in (q̂, x̂): middles and half-widths, shape (variables, boxes); variable 0 is q̂.

    More generally it is t with σ̂ = origin + way·t, along a line on which no cut lies; or with q̂ = t + slope·x̂₁, for
    parallelograms: of each box the slope.
    """

    m: Any
    r: Any
    origin: complex = 0.0
    way: complex = 1j
    slope: Reals | None = None

    @property
    def count(self) -> int:
        return int(self.m.shape[1])

    def take(self, rows: Integers) -> Boxes:
        slope = None if self.slope is None else self.slope[rows]
        return Boxes(self.m[:, rows], self.r[:, rows], self.origin, self.way, slope)

    @property
    def variables(self) -> tuple[Complexes, Complexes]:
        """(y, ρ) with y + ρ u = (σ̂, x̂) over the box; with slopes ρ is a matrix for each box, see `Forms`."""
        y, rho = self.m.astype(complex), self.r.astype(complex)
        if self.slope is None or not self.slope.any():
            y[0] = self.origin + self.way * y[0]
            rho[0] *= self.way
            return y, rho
        along = self.slope * self.m[1]
        y[0] = self.origin + self.way * (self.m[0] + along)
        full = np.zeros((len(y), *rho.shape), complex)
        full[np.arange(len(y)), np.arange(len(y))] = rho
        full[0, 0] = self.way * (self.r[0] + 8 * U * (np.abs(self.m[0]) + np.abs(along)))
        full[0, 1] = self.way * self.slope * self.r[1]
        return y, full


@dataclass(frozen=True)
class Wave:
    """What is known of D over boxes.

    D: its coefficients in P as models, shape (boxes, degree + 1); low: |lead| is at least this. z: nodes, the first
    `up` of U; tight: bounds of |a_k|; good: where all is proved. strain[v]: how far variable v moves p-roots,
    relative to the distance of the next root of the other side.
    """

    D: Quadratic
    z: Any
    up: int
    tight: Reals
    low: Reals
    good: Any
    strain: Reals

    def take(self, rows: Any) -> Wave:
        """Those of some boxes."""
        z, tight, low, good = (part[rows] for part in (self.z, self.tight, self.low, self.good))
        return Wave(self.D[rows], z, self.up, tight, low, good, self.strain[:, rows])


@dataclass(frozen=True)
class FreeTrack:
    """D, N and v of a family as forms in (σ̂, x̂)."""

    family: Family

    @cached_property
    def variables(self) -> int:
        return 1 + len(self.family.paths)

    @cached_property
    def up(self) -> int:
        """n₊, proved at the point of the base: constant as long as no p-root becomes real and none is lost."""
        return start(self.family.guide(self.family.ring.point)).up

    @cached_property
    def D(self) -> Forms:
        return self._by_powers(self.family.D)

    @cached_property
    def N(self) -> Forms:
        return self._by_powers(self.family.N)

    def _by_powers(self, polynomial: FreePolynomial) -> Forms:
        rows: list[dict[tuple[int, ...], Any]] = [{} for _ in range(max(i for i, _ in polynomial) + 1)]
        for (i, j), several in polynomial.items():
            rows[i] |= {(j, *exponents): c for exponents, c in several}
        return Forms.of(rows, self.variables)

    def nodes(self, D: Quadratic) -> tuple[Complexes, Reals]:
        """(floats near the roots at the middles, those of U first; |lead| is at least this over each box)."""
        lead = D[:, -1]
        return side_nodes(D.k[0][:, None, :], self.up), (np.abs(lead.a) - lead.spread) * (1 - 64 * U)

    def split(self, boxes: Boxes) -> Wave:
        """The splitting over each box."""
        y, rho = boxes.variables
        D, still, up = self.D(y, rho), self.D(y, 0 * rho), self.up
        n = D.k.shape[-1] - 1
        z0, low = self.nodes(D)
        lead = D[:, n]
        z = _spread(D, z0, low, up)
        value, size = at(D, z), gaps(z, 1)
        box, tight, done = contraction(_weights(value, size, low), size, up)
        thin = _thin(still, z0, low, up)
        zero = np.zeros(boxes.count)
        wide = Splittings(zero, zero, z, up, box, tight, done, zero, zero)
        good = done & linked(wide, thin) & _told_apart(z0, up, thin.tight)
        upper = np.arange(n) < up
        other = np.where(upper[:, None] != upper[None, :], size, np.inf).min(2)
        strain = (np.abs(value.b) / (size.prod(2) * np.abs(lead.a)[:, None] * other)[None]).max(2)
        strain = np.where(low > 0, strain, np.abs(lead.b) / np.abs(lead.a))
        return Wave(D, z, up, tight, low, good, strain)


def at(polynomial: Quadratic, z: Any) -> Quadratic:
    """The values at P = z, shape (boxes, points); coefficients ascending in the last axis."""
    n = polynomial.k.shape[-1]
    powers = np.ones((z.shape[0], n, z.shape[1]), complex)
    for i in range(1, n):
        powers[:, i] = powers[:, i - 1] * z
    size = np.abs(powers)
    k = (polynomial.k[:, :, None, :] @ powers)[:, :, 0]
    whole = (np.abs(polynomial.k).sum(0)[:, None, :] @ size)[:, 0]
    e = (polynomial.e[:, None, :] @ size)[:, 0] + 64 * (n + 2) * U * whole
    return Quadratic(k, e * UP + TINY, polynomial.m)


def _weights(value: Quadratic, size: Reals, low: Reals) -> Reals:
    """Bounds of |W_k|, ∞ where there is none."""
    below = size.prod(2) * low[:, None]
    W = value.size / below * (1 + 64 * size.shape[1] * U) * UP + TINY
    return np.where((low[:, None] > 0) & (below > TINY), W, np.inf)


def _thin(still: Quadratic, z: Any, low: Reals, up: int) -> Splittings:
    """The pair at the middles of the boxes."""
    size, zero = gaps(z, 1), np.zeros(len(z))
    box, tight, done = contraction(_weights(at(still, z), size, low), size, up)
    return Splittings(zero, zero, z, up, box, tight, done, zero, zero)


def _told_apart(z: Any, up: int, tight: Reals) -> Any:
    """The roots of U have Re P < 0, those of L Re P > 0: each lies within (their number) |a_k| of some node."""
    upper = z[:, :up].real + up * tight[:, :up] * UP
    lower = z[:, up:].real - (z.shape[1] - up) * tight[:, up:] * UP
    return (upper < 0).all(1) & (lower > 0).all(1)


def _spread(D: Quadratic, z: Any, low: Reals, up: int) -> Any:
    """Nodes of one side that are closer than the box moves their roots are put that far apart."""
    z = z.copy()
    size, moved = gaps(z, 1), at(D, z).spread
    for side in (range(up), range(up, z.shape[1])):
        for i in side:
            for k in range(i + 1, side.stop):
                rest = size[:, i].prod(1) / size[:, i, k] * low
                reach = _APART * np.sqrt(moved[:, i] / np.where(rest > 0, rest, np.inf))
                step, middle = (z[:, i] - z[:, k]) / 2, (z[:, i] + z[:, k]) / 2
                length = np.abs(step)
                short = (length < reach) & np.isfinite(reach)
                way = np.where(length > 0, step / np.where(length > 0, length, 1), 1j)
                z[:, i] = np.where(short, middle + reach * way, z[:, i])
                z[:, k] = np.where(short, middle - reach * way, z[:, k])
    return z
