"""All crossings of a line Im q = h by roots, over a range of one parameter: those of the real axis of a shifted family.

For h ≤ 0 the shifted vehicle and track are passive (`problem.shifted`), so that the contacts' passivity bounds the
frequency at which a root can cross.
"""

from __future__ import annotations

from dataclasses import dataclass
from fractions import Fraction
from typing import Any

import numpy as np

from mpsolve.outcome import Reason
from mpsolve.problem.family import Family
from mpsolve.problem.shifted import shifted
from mpsolve.progress import Progress
from mpsolve.proof.effort import Effort
from mpsolve.proof.subdivide import Covered
from mpsolve.ranges.answer import within
from mpsolve.ranges.crossings import Search
from mpsolve.ranges.enclosed import Crossing
from mpsolve.ranges.scope import Scope


@dataclass(frozen=True)
class Line:
    """The crossings (scaled, in ascending order) of Im q̂ = height; reason: why the list may not be complete."""

    scope: Scope
    height: Fraction
    cover: Covered
    crossings: tuple[Crossing, ...]
    known: tuple[Any, ...]
    reason: Reason | None = None


def cross_line(
    family: Family, height: Fraction, near: list[tuple[float, float]], budget: Effort, progress: Progress
) -> Line:
    """All roots of a family on the line; `OpenError` where no frequency is found that bounds them.

    near: points (Re q̂, x̂) where crossings are expected; they are enclosed first, which saves boxes.
    """
    scope = Scope(shifted(family, -height))
    search = Search(scope, 15)
    for point in near:
        search.enclose(np.array(point))
    cover = search.cover(budget, progress)
    reason, inside = cover.reason, []
    for one in search.found:
        where = within(one.x, family.box[0])
        if where is None and reason is None:
            reason = Reason(
                "end", "a root crosses a line at an end of the range", {}, "give a range that ends elsewhere"
            )
        if where:
            inside.append(one)
    inside.sort(key=lambda one: float(one.x.mid()))
    return Line(scope, height, cover, tuple(inside), tuple(search.judge.known), reason)
