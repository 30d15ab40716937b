"""That no root is real for any mass from x̂₁ on, endlessly heavy ones too: by two charts of (q̂, x̂) next to x̂ = ∞.

All masses are x̂ times given ones, S = K + iqC − q²x̂M. With y = q²x̂ the rows of bodies that have mass are

    quick: w = 1/y,   w(K + iqC) − M and −wB        (y ≥ 1; at w = 0 the contacts are pinned),
    slow:  y,         K + iqC − yM and −B           (y ≤ 1; at q = 0 the track is without inertia),

polynomials in q and in w or y. Both charts are covered with 0 < q ≤ X, where 1/x̂ = q²w = q²/y ≤ 1/x̂₁: a box on
which that is nowhere so is left out.

Next to q = 0 boxes are [−b, b] in q, and no root q > 0 is real where Re s and Im s/q do not vanish together (see
`mirrored`): whatever happens at q = 0 itself.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from fractions import Fraction
from typing import Any

import numpy as np

from mpsolve.characteristic.boxes import Boxes
from mpsolve.characteristic.free_matrix import FreeMatrix
from mpsolve.errors import InputError
from mpsolve.numbers.arrays import Integers, Reals
from mpsolve.numbers.jets import TINY, UP
from mpsolve.numbers.several import Several
from mpsolve.problem.family import Family
from mpsolve.proof.effort import Effort
from mpsolve.proof.subdivide import Covered, subdivide
from mpsolve.proof.vanishing import nonzero, scalar
from mpsolve.ranges.judge import CORNER, OUTSIDE, Judge
from mpsolve.ranges.mirrored import beside_zero
from mpsolve.ranges.scope import Scope

ONLY_MASSES = (
    "has no upper end: only a factor of all masses, such as scale.mass, may grow without end, as its limit is that "
    "of pinned contacts; the limits of other parameters are other problems: give an upper end"
)


class SeenError(Exception):
    """A root seems to be real at a mass x̂ in question."""

    def __init__(self, x: float) -> None:
        super().__init__(f"a root seems to be real at {x:.6g} times the unit of mass")
        self.x = x


def require_masses(family: Family, path: str) -> None:
    """InputError unless the only parameter is a factor of all masses, and of nothing else."""
    S0, S1, S2 = family.S
    rest = [*family.D.values(), *family.N.values(), family.v, *family.places, *family.h, *_flat(family.B)]
    fixed = [*rest, *_flat(S0), *_flat(S1)]
    if any(any(e) for c in fixed for e, _ in c) or any(e != (1,) for c in _flat(S2) for e, _ in c):
        raise InputError(path, ONLY_MASSES)
    if family.base.neutral:
        stated = "has no upper end, and some body hangs on dampers alone, whose limit is not known here"
        raise InputError(path, f"{stated}: give an upper end")


def _flat(rows: Sequence[Sequence[Several]]) -> list[Several]:
    return [x for row in rows for x in row]


def charts(family: Family) -> tuple[FreeMatrix, FreeMatrix]:
    """(quick, slow); the parameter is w, or y, in place of x̂."""
    (w,) = family.ring.variables
    S0, S1, S2 = family.S
    M = [[sum((c for _, c in x), Fraction(0)) for x in row] for row in S2]
    heavy = [any(row) for row in M]
    by = [w if one else family.ring.constant(1) for one in heavy]
    none = tuple(tuple(family.ring.constant(0) for _ in row) for row in M)
    quick = replace(family, S=(_rows(S0, M, by, family.ring.constant(-1)), _rows(S1, M, by, None), none))
    slow = replace(family, S=(_rows(S0, M, [family.ring.constant(1)] * len(M), -w), S1, none))
    push = tuple(tuple(x * f for x in row) for row, f in zip(family.B, by, strict=True))
    return FreeMatrix(quick, push), FreeMatrix(slow)


def _rows(
    S: Sequence[Sequence[Several]], M: Sequence[Sequence[Fraction]], by: list[Several], mass: Several | None
) -> tuple[tuple[Several, ...], ...]:
    return tuple(
        tuple(x * f + (mass * m if mass is not None else 0) for x, m in zip(row, masses, strict=True))
        for row, masses, f in zip(S, M, by, strict=True)
    )


@dataclass
class HeavyJudge(Judge):
    """Judges boxes of one chart in (q̂, w or y). least: the least x̂ in question, below which boxes are OUTSIDE; quick:
    the chart.
    """

    least: float = 1.0
    quick: bool = True

    def __call__(self, low: Any, high: Any) -> tuple[Any, Any]:
        kind, axis = super().__call__(low, high)
        y, square = self._outside(low, high)
        kind[(kind == 0) & (square > y)] = OUTSIDE
        edge = np.flatnonzero((low[0] == 0) & (kind == 0))
        if len(edge):
            kind[edge], axis[edge] = self._corner(low[:, edge], high[:, edge])
        return kind, axis

    def _outside(self, low: Reals, high: Reals) -> tuple[Reals, Reals]:
        """x̂ < least on the whole box where the first is below the second."""
        square = low[0] * low[0] * self.least / UP / UP
        return (high[1], square) if not self.quick else (np.ones_like(square), square * low[1] / UP)

    def _corner(self, low: Reals, high: Reals) -> tuple[Integers, Integers]:
        m = np.stack([0 * low[0], low[1] / 2 + high[1] / 2])
        boxes = Boxes(m, np.stack([high[0], np.maximum(high[1] - m[1], m[1] - low[1])]) * UP + 2.0**-1000)
        A, G = self.matrix(boxes)
        s = scalar(A, G.good, real=True)
        # what is left out of s is of third order along y, by its own size, and Im s is of first order along q
        along, across = boxes.r[0] / self.width[0], boxes.r[1] / (m[1] + TINY)
        return np.where(s.good & nonzero(beside_zero(s.s)).nonzero, CORNER, 0), np.where(across**2 > along, 1, 0)


@dataclass
class Heavy:
    """The question for one family over any two masses: its scale; X̂ as of a scope."""

    scope: Scope
    path: str

    def __post_init__(self) -> None:
        require_masses(self.scope.family, self.path)

    def cover(self, least: Fraction, budget: Effort) -> tuple[Covered, ...]:
        """The charts for x̂ ≥ least; `SeenError` where a root seems to be real there."""
        out: list[Covered] = []
        floor = np.nextafter(float(least), 0.0)
        for quick, matrix in zip((True, False), charts(self.scope.family), strict=True):
            X = self.scope.X
            reach = X if quick else min(X, float(np.sqrt(1 / floor)) * UP * UP)
            high = np.array([reach, 1.0])
            judge = HeavyJudge(matrix, self.scope.envelope, high / 2, least=floor, quick=quick)
            judge.found = _Looked(floor, quick)
            out.append(subdivide(np.zeros(2), high, judge, budget, 2.0**-48))
            if out[-1].reason is not None:
                break
        return tuple(out)


@dataclass(frozen=True)
class _Looked:
    """What is done about a point where the determinant seems to vanish."""

    least: float
    quick: bool

    def __call__(self, point: Any, half: Any) -> bool:
        q, y = map(float, point)
        if not (q > 0 and y > 0) or not (half < 2.0**-8 * np.abs(point)).all():
            return False
        x = 1 / (q * q * y) if self.quick else y / (q * q)
        if x > self.least:
            raise SeenError(x)
        return False
