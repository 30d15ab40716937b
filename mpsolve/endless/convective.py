"""Up to which velocity no motion of a row grows, proved over the whole range of velocities, for all κ at once.

Boxes (q, v, θ) that hold no real root cover a range of velocities, so the number of growing motions does not change
in it, for any κ; it is 0 at one velocity (docs/theory/infinite-train.md).
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from fractions import Fraction

import numpy as np

from mpsolve.endless.row_scope import RowScope, judge_of
from mpsolve.outcome import Reason
from mpsolve.proof.effort import Effort
from mpsolve.proof.subdivide import subdivide

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
