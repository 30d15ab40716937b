"""Boxes of (q̂, x̂, ŷ) in which the real roots form one arc at most, and enclosures of the arc piece by piece.

The reduced determinant s is a Taylor model over a box somewhat wider than that of which is spoken, |u_i| ≤ 1 (see
`vanishing`). If s is injective in two of the variables for each value of the third, its zeros in |u_i| ≤ 1/2 are a
graph over that one, the pivot t; which one serves best is tried. With J the slopes by the two others at a point u*
and t*, u = u* − J⁻¹(s* + hτ) + ε, τ = t − t*, each zero obeys

    ε = −J⁻¹ (the terms of second order in (u − u*, τ) + the rest),

so a bound of |u − u*| gives one of |ε|, which gives a better one of |u − u*|: all zeros with |τ| ≤ half a piece lie
in the last. Where a bound is mapped into itself, within |u_i| < 1/2, there is a zero for each τ (Brouwer): the arc
passes.

A box that touches q = 0 is taken with its mirror image and has two models, of the roots at q = 0 and of those beside
it (see `mirrored`): one arc at most of each kind.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np

from mpsolve.characteristic.boxes import Boxes
from mpsolve.characteristic.free_matrix import FreeMatrix
from mpsolve.numbers.arrays import Integers, Reals, Truths
from mpsolve.numbers.jets import UP, U
from mpsolve.numbers.quadratic import Quadratic, pairs
from mpsolve.proof.subdivide import OPEN
from mpsolve.proof.vanishing import Scalar, guess, nonzero, scalar
from mpsolve.ranges.judge import ARC, Judge
from mpsolve.ranges.mirrored import at_zero, beside_zero
from mpsolve.ranges.ridge import REGULAR, solved, solved_size, unevenness

SHARE = 0.4
"""Of a model's box: that of which is spoken."""
HALF = 0.5  # of a model's box: where the zeros are a graph
PIECES = 10
_STEPS = 8
_NOISE = 2.0**-42  # of the coefficients: covers the rounding of values, slopes and steps
_NEXT = 2.0**-10  # of the width of a box along q: in which roots at q = 0 are looked for
_LARGEST = 2.0**-2  # of the whole: boxes that are tried
_HOPE = 1.3
_ANY = np.full(2, np.inf)
_ORDER = np.array([[1, 2, 0], [0, 2, 1], [0, 1, 2]])  # by pivot, which comes last


@dataclass(frozen=True)
class Arcs:
    """Models, the pivot as the last variable. m, r: of the models' boxes, (q̂, x̂, ŷ) along the first axis.

    low, high: of the boxes of which is spoken; at_zero: whether of roots with q = 0 alone; regular: where the zeros
    are one arc at most.
    """

    low: Any
    high: Any
    m: Any
    r: Any
    pivot: Integers
    s: Quadratic
    at_zero: Truths
    regular: Truths

    def place(self, u: Reals, t: Reals) -> Reals:
        """(q̂, x̂, ŷ) of the others and the pivot, in shares of the models' boxes; sizes alike, without the middles."""
        out = np.empty((3, *np.shape(t)))
        columns = np.arange(out.shape[1])
        for k, value in enumerate((u[0], u[1], t)):
            out[_ORDER[self.pivot, k], columns] = value
        return out

    def along(self, value: Any) -> Any:
        """Of (q̂, x̂, ŷ) that of the pivot."""
        return np.take_along_axis(value, self.pivot[None], 0)[0]

    def take(self, rows: Any) -> Arcs:
        """Those of some models."""
        low, high, m, r = (part[:, rows] for part in (self.low, self.high, self.m, self.r))
        return Arcs(low, high, m, r, self.pivot[rows], self.s[rows], self.at_zero[rows], self.regular[rows])

    @property
    def blurred(self) -> Any:
        """By how much in (q̂, x̂, ŷ) arcs are not told by the models, about."""
        g0, g1, _ = self.s.b
        return self.place(solved_size(g0, g1, self.s.e), np.zeros(len(self.pivot))) * self.r

    def pieces(self, t: Any, half: Any) -> Pieces:
        """The arcs for t − half ≤ pivot ≤ t + half."""
        return _pieces(self.s, t, half)


def arcs(matrix: FreeMatrix, low: Reals, high: Reals, thin: Reals = _ANY) -> tuple[Arcs, Truths]:
    """(The arcs of boxes between corners, shape (3, boxes); which boxes hold no zeros but theirs).

    thin: how well arcs are to be known in x̂ and ŷ. Boxes without zeros have none; those at q = 0 come last.
    """
    m = low / 2 + high / 2
    half = np.maximum(high - m, m - low) * UP
    touching = low[0] == 0
    m[0], half[0] = np.where(touching, 0.0, m[0]), np.where(touching, high[0], half[0])
    r = half / SHARE * UP
    rows = np.arange(low.shape[1])
    zero = rows[touching]
    rows = np.concatenate([rows, zero])
    kind = np.arange(len(rows)) >= low.shape[1]
    r = r[:, rows]
    r[0] *= np.where(kind, _NEXT, 1.0)
    found = arcs_over(matrix, m[:, rows], r, kind, low[:, rows], high[:, rows])
    none = nonzero(wider(found.s, SHARE)).nonzero
    closed = np.ones(low.shape[1], bool)
    fine = found.regular & (found.blurred[1:] <= thin[:, None]).all(0)
    np.logical_and.at(closed, rows, none | fine)
    return found.take(np.flatnonzero(~none)), closed


def arcs_over(matrix: FreeMatrix, m: Any, r: Any, zero: Any = False, low: Any = None, high: Any = None) -> Arcs:
    """Of models over boxes with these middles and half-widths. zero: of which the roots at q = 0 are meant."""
    zero = np.broadcast_to(zero, m.shape[1])
    s = models(matrix, m, r, zero)
    turned = [_turned(s, pivot) for pivot in range(3)]
    uneven = np.stack([unevenness(one) for one in turned])
    pivot = uneven.argmin(0)
    k = np.choose(pivot[None], [one.k for one in turned])
    least = np.take_along_axis(uneven, pivot[None], 0)[0]
    return Arcs(low, high, m, r, pivot, Quadratic(k, s.e, 3), zero, least < REGULAR)


def models(matrix: FreeMatrix, m: Reals, r: Reals, zero: Truths) -> Quadratic:
    """Of the reduced determinant; round q = 0 of roots there (`zero`) or of those beside it. e = ∞: not bounded."""
    k, e = np.zeros((10, m.shape[1]), complex), np.full(m.shape[1], np.inf)
    mirrored = m[0] == 0
    for real in (False, True):
        rows = np.flatnonzero(mirrored == real)
        if len(rows):
            A, G = matrix(Boxes(m[:, rows], r[:, rows]))
            found = scalar(A, G.good, real=real)
            s = found.s
            if real:
                here, beside = at_zero(s), beside_zero(s)
                s = Quadratic(np.where(zero[rows], here.k, beside.k), np.where(zero[rows], here.e, beside.e), 3)
            k[:, rows], e[rows] = s.k, np.where(found.good, s.e, np.inf)
    return Quadratic(k, e, 3)


def wider(s: Quadratic, times: float) -> Quadratic:
    """The same polynomials over boxes so many times as wide; the rest holds for smaller ones."""
    return Quadratic(s.k * np.array([1.0] + [times] * 3 + [times * times] * 6)[:, None], s.e, 3)


def _turned(s: Quadratic, pivot: int) -> Quadratic:
    """The same with the pivot last."""
    order = _ORDER[pivot]
    each = [pairs(3).index((min(order[i], order[j]), max(order[i], order[j]))) for i, j in pairs(3)]
    return Quadratic(s.k[[0, *(1 + order), *(4 + np.array(each))]], s.e, 3)


@dataclass
class ArcJudge(Judge):
    """A judge that also closes boxes in which the zeros are one arc at most.

    thin: how well this is to be known, in shares of the whole.
    """

    thin: float = np.inf

    def __call__(self, low: Any, high: Any) -> tuple[Any, Any]:
        kind, axis, rest = self.judged(low, high)
        small = (high - low <= _LARGEST * 2 * self.width[:, None]).all(0)
        rows = np.flatnonzero((kind == OPEN) & small & (_likely(rest) | (low[0] == 0)))
        if len(rows):
            kind[rows[arcs(self.matrix, low[:, rows], high[:, rows], self.thin * 2 * self.width[1:])[1]]] = ARC
        return kind, axis


def _likely(found: Scalar) -> Any:
    """Whether a wider box may be regular, as far as the model over the box itself tells."""
    s = wider(found.s, 1 / SHARE)
    s = Quadratic(s.k, s.e * SHARE**-3, 3)
    return found.good & (np.min([unevenness(_turned(s, pivot)) for pivot in range(3)], 0) < _HOPE * REGULAR)


@dataclass(frozen=True)
class Pieces:
    """Zeros lie within `around` of centre + lean τ, shapes (2, boxes), in shares of the models' boxes.

    passes: whether there is one for each τ.
    """

    centre: Reals
    lean: Reals
    around: Reals
    passes: Truths


def _pieces(s: Quadratic, t: Any, half: Any) -> Pieces:
    a, b0, b1, b2, c00, c01, c02, c11, c12, c22 = s.k
    with np.errstate(all="ignore"):
        there = np.stack([a + (b2 + c22 * t) * t, b0 + c02 * t, b1 + c12 * t, c00, c01, c11])
        u = np.clip(np.nan_to_num(guess(Quadratic(there, s.e, 2))), -0.6, 0.6)
        value = there[0] + (there[1] + c00 * u[0] + c01 * u[1]) * u[0] + (there[2] + c11 * u[1]) * u[1]
        g = np.stack([there[1] + 2 * c00 * u[0] + c01 * u[1], there[2] + c01 * u[0] + 2 * c11 * u[1]])
        h = b2 + 2 * c22 * t + c02 * u[0] + c12 * u[1]
        det = (g[0].conj() * g[1]).imag
        step, lean = (
            -np.stack([(z * g[1].conj()).imag, (g[0].conj() * z).imag]) / np.stack([-det, det]) for z in (value, h)
        )
        along = np.abs(step) + np.abs(lean) * half
        still = solved(g[0], g[1], c22) * half**2 + solved_size(g[0], g[1], s.e + _NOISE * np.abs(s.k).sum(0))
        bent = [solved(g[0], g[1], z) for z in (c00, c01, c11, c02 * half, c12 * half)]

        def rest(wide: Reals) -> Any:
            square = bent[0] * wide[0] ** 2 + bent[1] * wide[0] * wide[1] + bent[2] * wide[1] ** 2
            return (still + square + bent[3] * wide[0] + bent[4] * wide[1]) * (1 + 64 * U)

        widest = HALF + np.abs(u)
        around = rest(widest)
        for _ in range(_STEPS):
            around = rest(np.minimum(widest, along + around))
        around = np.where(np.isfinite(around), around, np.inf)
        more = 1.25 * around + 2.0**-60
        centre = u + step
        held = (rest(along + more) < more).all(0)
        inside = (np.abs(centre) + np.abs(lean) * half + more < HALF * (1 - 2.0**-40)).all(0)
    return Pieces(centre, lean, around, held & inside)
