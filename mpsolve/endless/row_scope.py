"""A row over a range of velocities: what is proved of it as a whole, and the judge of its boxes in (q̂, v̂, θ).

Up to which velocity no motion of a row grows is proved over the whole range of velocities, for all κ at once: boxes
(q, v, θ) that hold no real root cover it, so the number of growing motions does not change in it, for any κ; it is 0
at one velocity (docs/theory/infinite-train.md).
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from fractions import Fraction
from functools import cached_property
from typing import Any

import numpy as np

from mpsolve.characteristic.boxes import Boxes
from mpsolve.characteristic.free_receptance import Receptances
from mpsolve.endless.boxes import ROUND
from mpsolve.endless.free_row import WIDE, RowMatrix
from mpsolve.endless.row import Row
from mpsolve.errors import PrecisionError
from mpsolve.numbers.arrays import Reals
from mpsolve.numbers.quadratic import by_variable
from mpsolve.outcome import Reason
from mpsolve.passivity.decay import edges, vanishes
from mpsolve.passivity.far import far
from mpsolve.problem.family import Family, family_of
from mpsolve.proof.definite import positive_definite
from mpsolve.proof.effort import Effort
from mpsolve.proof.subdivide import subdivide
from mpsolve.proof.vanishing import Scalar, nonzero, scalar
from mpsolve.ranges.judge import NONZERO, PASSIVE, boxes_of
from mpsolve.ranges.scope import Scope, scope_of

_ARC = 0.25  # of what a model leaves out where the arc is wide: how far the arc counts as what moves the matrix
_SLOWEST = -2  # G(0, s) must fall more slowly than s^−2 for real s → ∞


@dataclass(frozen=True)
class RowScope:
    """family: one vehicle with v free; X: from this scaled frequency on every piece of the row takes energy."""

    row: Row
    family: Family
    X: float

    @cached_property
    def matrix(self) -> RowMatrix:
        return RowMatrix(self.family, step=self.row.spacing / Fraction(2) ** self.family.base.guide.length)

    @cached_property
    def ends(self) -> tuple[float, float]:
        """Of v̂, rounded outward."""
        own = Scope(self.family)
        return float(own.low[0]), float(own.high[0])

    def corners(self, top: float) -> tuple[Reals, Reals]:
        """Of the box in (q̂, v̂, θ) up to v̂ = top."""
        return np.array([0.0, self.ends[0], -ROUND]), np.array([self.X, top, ROUND])


def row_scope(row: Row, low: Fraction, high: Fraction) -> RowScope:
    """PrecisionError where no theorem says that roots stay bounded; InputError where a premise fails in the range."""
    over = {"v": (low, high)}
    two = scope_of(row.train(2), over)  # two vehicles have every gap of the row
    if len(set(two.family.places)) < len(two.family.index):
        raise PrecisionError("two contacts of a vehicle are at one place, which the theorem about rows leaves out")
    family = family_of(row.problem, over)
    _require_decay(family)
    X = far(two.envelope)
    if X is None:
        raise PrecisionError("no frequency is found beyond which the contacts are passive for all these velocities")
    factor = two.family.frequency_unit / family.frequency_unit
    return RowScope(row, family, float(factor) * X * (1 + 2.0**-40))


def _require_decay(family: Family) -> None:
    """Section 6.7 of the specification, at both ends and in the middle."""
    (low, high), point = family.box[0], family.ring.point[0]
    shapes = set()
    for x in (low, high, point):
        guide = family.guide((x,))
        found = edges(guide.D, guide.N)
        shapes.add(tuple((edge.slope, edge.weight) for edge in found))
        slow = max(edge.weight for edge in found) > _SLOWEST
        if not slow or not vanishes(guide.D, guide.N, guide.v):
            raise PrecisionError("it is not proved that no frequency comes from infinity as the velocity changes")
    if len(shapes) > 1:
        raise PrecisionError("short waves of the track change their kind within the range of velocities")


@dataclass
class RowJudge:
    """Judges boxes (q̂, v̂, θ): where no root is real.

    PASSIVE: whatever the vehicle, as the row takes energy from any forces; NONZERO: Δ̂ does not vanish. width: half of
    the whole.
    """

    matrix: RowMatrix
    width: Reals

    def __call__(self, low: Any, high: Any) -> tuple[Any, Any]:
        boxes = boxes_of(low, high)
        G = self.matrix.receptance(boxes)
        H, E = G.absorbed
        kind = np.where(G.good & (low[0] > 0) & positive_definite(H, E), PASSIVE, 0).astype(np.int8)
        axis = np.zeros(len(kind), np.int8)
        rest = np.flatnonzero(kind == 0)
        if len(rest):
            kind[rest], axis[rest] = self._regular(boxes.take(rest), G.take(rest))
        return kind, axis

    def _regular(self, boxes: Boxes, G: Receptances) -> tuple[Any, Any]:
        s = scalar(self.matrix.assembled(G.G, *boxes.variables), G.good)
        verdict = nonzero(s.s)
        with np.errstate(all="ignore"):
            amount = by_variable(np.abs(s.s.k), s.s.m)  # how much of the model comes from each variable
            amount[-1] = np.maximum(amount[-1], G.strain[-1] * np.abs(s.s.a))  # wide arcs are bounded only
            weight = verdict.weight + s.s.e * amount / amount.sum(0)
        kind = np.where(s.good & verdict.nonzero, NONZERO, 0).astype(np.int8)
        return kind, self._axis(boxes, G, s, weight)

    def _axis(self, boxes: Boxes, G: Receptances, s: Scalar, weight: Reals) -> Any:
        """What stands most against the test.

        Where the determinant is not bounded, it is what moves the matrix and the p-roots most; next to a resonance of
        the vehicle that is the frequency, and for a wide arc what is left out counts as moved by θ.
        """
        with np.errstate(all="ignore"):
            moved = np.where(G.good & np.isfinite(s.strain).all(0), s.strain, 0)
            moved[-1] += np.where(G.good & np.isfinite(s.rest) & (boxes.r[-1] > WIDE), _ARC * s.rest, 0)
            moved += G.strain
            weight = np.where(s.good & np.isfinite(weight).all(0), weight, moved)
            width = boxes.r / self.width[:, None]
            share = weight / weight.max(0) + width * 1e-9
            return np.where(np.isfinite(share), share, width).argmax(0).astype(np.int8)


def judge_of(scope: RowScope) -> RowJudge:
    """A judge over the whole scope."""
    low, high = scope.corners(scope.ends[1])
    return RowJudge(scope.matrix, (high - low) / 2)


Tell = Callable[[float], None]
_SLABS = 8  # of one width: what is covered is kept where the effort ends
_NEAR = (2.0**-8, 2.0**-16, 2.0**-24, 2.0**-28)
"""How near to the threshold the slabs end that are covered after them, relative to it."""


@dataclass(frozen=True)
class Covered:
    """No root is real for any velocity from the start of the scope to `top` (in the units of the problem).

    top: None where nothing is proved. reason: why it is not proved as far as was asked, or next to the threshold.
    """

    top: Fraction | None
    boxes: int
    reason: Reason | None = None


def cover_row(scope: RowScope, threshold: Fraction | None, effort: Effort, tell: Tell | None = None) -> Covered:
    """Covers the velocities up to a little below the computed threshold; all of the range where there is none."""
    (start, end), unit = scope.ends, scope.family.units[0]
    middle = end if threshold is None else float(threshold / unit)
    near = [0.0] if threshold is None else list(_NEAR)
    first = middle * (1 - near[0])
    tops = [start + (first - start) * k / _SLABS for k in range(1, _SLABS)] + [middle * (1 - x) for x in near]
    tops = [x for x in tops if start < x < end or x == end]
    judge, reached, boxes, reason = judge_of(scope), start, 0, None
    for k, top in enumerate(tops):
        low, high = scope.corners(top)
        low[1] = reached
        judge.width = (high - low) / 2
        found = subdivide(low, high, judge, effort, tell=_part(tell, k, len(tops)))
        boxes, reason = boxes + found.tree.nodes, found.reason
        if reason is not None:
            break
        reached = float(np.float64(top))
    done = None if reached == start else Fraction(reached) * unit
    return Covered(done, boxes, reason if reached < first else None)


def _part(tell: Tell | None, k: int, count: int) -> Tell | None:
    """Heard of the k-th part of `count` equal ones."""
    return None if tell is None else lambda share: tell((k + share) / count)
