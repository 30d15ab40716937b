"""The regions of a chart, each a connected part over which no root is real, with the number that one point tells."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, field
from fractions import Fraction
from typing import TYPE_CHECKING, Any

import numpy as np

from mpsolve.errors import EffortError
from mpsolve.numbers.arrays import Integers
from mpsolve.outcome import Reason
from mpsolve.problem.problem import Problem
from mpsolve.progress import Progress
from mpsolve.proof.effort import Effort
from mpsolve.ranges.answer import Interval
from mpsolve.ranges.base import base_at, growing, uncounted
from mpsolve.ranges.cells import OPEN, inmost
from mpsolve.ranges.undamped import at_corner

if TYPE_CHECKING:
    from mpsolve.spectrum.spectrum import Spectrum

_MOST_PARTS = 60


@dataclass(frozen=True)
class Part:
    """A connected part of the chart on which no root is real: the number of roots that grow, proved at one point.

    cells: how many of `detail`; point: the exact parameters at which the roots were certified; roots: None where that
    is open.
    """

    cells: int
    point: Mapping[str, Fraction]
    roots: int | None
    spectrum: Spectrum | None = field(repr=False, default=None)


def counted(
    problem: Problem,
    over: dict[str, Interval],
    edges: tuple[tuple[Fraction, ...], tuple[Fraction, ...]],
    labels: tuple[Integers, Integers],
    detail: Any,
    budget: Effort,
    progress: Progress,
    check: bool,
) -> tuple[tuple[Part, ...], Integers, Reason | None]:
    """The parts with their counts, which are written into `detail`, the greatest first; of fine cells the number of
    the part, −1 where there is none.

    labels: of cells, and of finer ones. Parts that hold no cell whole are pockets between curves.
    """
    coarse, fine = labels
    sizes = np.bincount(fine.ravel())[1:]
    order = np.argsort(-sizes, kind="stable")
    regions = np.full(fine.shape, -1)
    parts: list[Part] = []
    reason: Reason | None = None
    for number, k in enumerate(order):
        where, whole = fine == k + 1, coarse == k + 1
        if number >= _MOST_PARTS:
            detail[where] = OPEN
            reason = reason or (_too_many(len(order)) if whole.any() else None)
            continue
        progress("regions", 0.7 + 0.2 * number / len(order))
        point = point_in(over, edges, whole if whole.any() else where)
        try:
            budget.spend(1)
            found = base_at(at_corner(problem, point), budget.rest(), check)
        except EffortError as error:
            reason = reason or error.reason
            detail[where] = OPEN
            parts.append(Part(int(sizes[k]), point, None))
            continue
        roots = growing(found)
        detail[where] = OPEN if roots is None else roots
        regions[where] = len(parts)
        parts.append(Part(int(sizes[k]), point, roots, found))
        if roots is None and reason is None:
            reason = uncounted(found, "of a region")
    return tuple(parts), regions, reason


def point_in(paths: Iterable[str], edges: Sequence[Sequence[Fraction]], where: Any) -> dict[str, Fraction]:
    """The middle of a cell far inside."""
    each = zip(paths, edges, inmost(where), where.shape, strict=True)
    return {path: ends[0] + (ends[-1] - ends[0]) * Fraction(2 * k + 1, 2 * n) for path, ends, k, n in each}


def _too_many(parts: int) -> Reason:
    stated = f"the chart falls into {parts} parts, of which {_MOST_PARTS} are counted"
    return Reason("parts", stated, {"parts": str(parts)}, "raise the depth, so that small parts come together")
