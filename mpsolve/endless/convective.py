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
_NEAR = (2.0**-8, 2.0**-16, 2.0**-24, 2.0**-28)
"""How near to the threshold the slabs end that are covered one after the other, relative to it."""


@dataclass(frozen=True)
class Covered:
    """No root is real for any velocity from the start of the scope to `top` (in the units of the problem).

    top: None where nothing is proved. reason: why it is not proved as far as was asked.
    """

    top: Fraction | None
    boxes: int
    reason: Reason | None = None


def cover_row(scope: RowScope, threshold: Fraction | None, effort: Effort, tell: Tell | None = None) -> Covered:
    """Covers the velocities up to a little below the computed threshold; all of the range where there is none."""
    (start, end), unit = scope.ends, scope.family.units[0]
    if threshold is None:
        tops = [end]
    else:
        middle = float(threshold / unit)
        tops = [x for x in (middle * (1 - near) for near in _NEAR) if start < x < end]
    judge, reached, boxes, reason = judge_of(scope), start, 0, None
    for top in tops:
        low, high = scope.corners(top)
        low[1] = reached
        judge.width = (high - low) / 2
        found = subdivide(low, high, judge, effort, tell=tell)
        boxes, reason = boxes + found.tree.nodes, found.reason
        if reason is not None:
            break
        reached = float(np.float64(top))
    done = None if reached == start else Fraction(reached) * unit
    return Covered(done, boxes, reason if done is None or threshold is None else None)
