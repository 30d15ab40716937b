"""Boxes of (q̂, x̂, ŷ) in which the real roots form one arc at most, and enclosures of the arc piece by piece.

The reduced determinant s is a Taylor model over a box somewhat wider than that of which is spoken, |u_i| ≤ 1 (see
`vanishing`). If s is injective in two of the variables for each value of the third, its zeros in |u_i| ≤ 1/2 are a
graph over that one, the pivot t; which one serves best is tried. With J the slopes by the two others at a point u*
and t*, u = u* − J⁻¹(s* + hτ) + ε, τ = t − t*, each zero obeys

    ε = −J⁻¹ (the terms of second order in (u − u*, τ) + the rest),

so a bound of |u − u*| gives one of |ε|, which gives a better one of |u − u*|: all zeros with |τ| ≤ half a piece lie
in the last. Where a bound is mapped into itself, within |u_i| < 1/2, there is a zero for each τ (Brouwer): the arc
passes.

A box that touches q = 0 is taken with its mirror image. Roots q, −q̄ go together, so the one zero for each t of such
a box has q = 0, exactly, if the pivot is a parameter.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np

from mpsolve.characteristic.boxes import Boxes
from mpsolve.characteristic.free_matrix import FreeMatrix
from mpsolve.numbers.jets import UP, U
from mpsolve.numbers.quadratic import Quadratic, pairs
from mpsolve.proof.subdivide import OPEN
from mpsolve.proof.vanishing import Scalar, guess, scalar
from mpsolve.ranges.judge import Judge
from mpsolve.ranges.ridge import REGULAR, unevenness

ARC = 4
"""A kind of leaf, beside those of `judge`: the zeros in it are a part of one arc."""
SHARE = 0.4
"""Of a model's box: that of which is spoken."""
HALF = 0.5  # of a model's box: where the zeros are a graph
PIECES = 10
_STEPS = 8
_NOISE = 2.0**-42  # of the coefficients: covers the rounding of values, slopes and steps
_LARGEST = 2.0**-2  # of the whole: boxes that are tried
_HOPE = 1.3
_ORDER = np.array([[1, 2, 0], [0, 2, 1], [0, 1, 2]])  # by pivot, which comes last


@dataclass(frozen=True)
class Arcs:
    """Models over boxes, the pivot as the last variable. m, r: of the models' boxes, (q̂, x̂, ŷ) along the first axis.

    low, high: of the boxes of which is spoken; regular: where the zeros are one arc at most.
    """

    low: Any
    high: Any
    m: Any
    r: Any
    pivot: Any
    s: Quadratic
    regular: Any

    @property
    def at_zero(self) -> Any:
        """Whether all zeros have q = 0."""
        return (self.m[0] == 0) & (self.pivot != 0)

    def place(self, u: Any, t: Any) -> Any:
        """(q̂, x̂, ŷ) of the others and the pivot, in shares of the models' boxes; sizes alike, without the middles."""
        out = np.empty((3, *np.shape(t)))
        columns = np.arange(out.shape[1])
        for k, value in enumerate((u[0], u[1], t)):
            out[_ORDER[self.pivot, k], columns] = value
        return out

    def take(self, rows: Any) -> Arcs:
        """Those of some boxes."""
        low, high, m, r = (part[:, rows] for part in (self.low, self.high, self.m, self.r))
        return Arcs(low, high, m, r, self.pivot[rows], self.s[rows], self.regular[rows])

    def pieces(self, t: float, half: Any) -> Pieces:
        """The arcs for t − half ≤ pivot ≤ t + half."""
        return _pieces(self.s, t, half)


def arcs(matrix: FreeMatrix, low: Any, high: Any) -> Arcs:
    """Of boxes between corners, shape (3, boxes)."""
    m = low / 2 + high / 2
    half = np.maximum(high - m, m - low) * UP
    touching = low[0] == 0
    m[0], half[0] = np.where(touching, 0.0, m[0]), np.where(touching, high[0], half[0])
    return arcs_over(matrix, m, half / SHARE * UP, low, high)


def arcs_over(matrix: FreeMatrix, m: Any, r: Any, low: Any = None, high: Any = None) -> Arcs:
    """Of models over boxes with these middles and half-widths."""
    A, G = matrix(Boxes(m, r))
    found = scalar(A, G.good)
    turned = [_turned(found.s, pivot) for pivot in range(3)]
    uneven = np.stack([unevenness(one) for one in turned])
    pivot = uneven.argmin(0)
    k = np.choose(pivot[None], [one.k for one in turned])
    least = np.take_along_axis(uneven, pivot[None], 0)[0]
    return Arcs(low, high, m, r, pivot, Quadratic(k, found.s.e, 3), found.good & (least < REGULAR))


def _turned(s: Quadratic, pivot: int) -> Quadratic:
    """The same with the pivot last."""
    order = _ORDER[pivot]
    each = [pairs(3).index((min(order[i], order[j]), max(order[i], order[j]))) for i, j in pairs(3)]
    return Quadratic(s.k[[0, *(1 + order), *(4 + np.array(each))]], s.e, 3)


@dataclass
class ArcJudge(Judge):
    """A judge that also closes boxes in which the zeros are one arc at most."""

    def __call__(self, low: Any, high: Any) -> tuple[Any, Any]:
        kind, axis, rest = self.judged(low, high)
        small = (high - low <= _LARGEST * 2 * self.width[:, None]).all(0)
        rows = np.flatnonzero((kind == OPEN) & small & (_likely(rest) | (low[0] == 0)))
        if len(rows):
            kind[rows[arcs(self.matrix, low[:, rows], high[:, rows]).regular]] = ARC
        return kind, axis


def _likely(found: Scalar) -> Any:
    """Whether a wider box may be regular, as far as the model over the box itself tells."""
    wider = np.array([1.0] + [1 / SHARE] * 3 + [SHARE**-2] * 6)[:, None]
    s = Quadratic(found.s.k * wider, found.s.e * SHARE**-3, 3)
    return found.good & (np.min([unevenness(_turned(s, pivot)) for pivot in range(3)], 0) < _HOPE * REGULAR)


@dataclass(frozen=True)
class Pieces:
    """Zeros lie within `around` of centre + lean τ, shapes (2, boxes), in shares of the models' boxes.

    passes: whether there is one for each τ.
    """

    centre: Any
    lean: Any
    around: Any
    passes: Any


def _pieces(s: Quadratic, t: float, half: Any) -> Pieces:
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
        sure = np.abs(det) - 8 * U * np.abs(g).prod(0)
        per = np.where(sure > 0, np.abs(g[::-1]) / sure * (1 + 64 * U), np.inf)
        still = s.e + np.abs(c22) * half**2 + _NOISE * np.abs(s.k).sum(0)
        bent = np.abs(np.stack([c00, c01, c11, c02 * half, c12 * half]))
        along = np.abs(step) + np.abs(lean) * half

        def rest(wide: Any) -> Any:
            square = bent[0] * wide[0] ** 2 + bent[1] * wide[0] * wide[1] + bent[2] * wide[1] ** 2
            return per * (still + square + bent[3] * wide[0] + bent[4] * wide[1]) * (1 + 64 * U)

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
