"""The regions of a chart, each a connected part over which no root is real, with the number that one point tells.

Of undamped beams and of strings theorems tell all of some cells, without boxes (see `never`).
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass, field
from fractions import Fraction
from functools import partial
from typing import TYPE_CHECKING, Any

import numpy as np

from mpsolve.errors import EffortError
from mpsolve.numbers.arrays import Integers, Truths
from mpsolve.outcome import Reason
from mpsolve.problem.family import Interval
from mpsolve.problem.problem import Problem
from mpsolve.progress import Progress
from mpsolve.proof.effort import Effort
from mpsolve.ranges import lone_mass, undamped
from mpsolve.ranges.base import base_at, growing, uncounted
from mpsolve.ranges.cells import OPEN, inmost
from mpsolve.ranges.never import never_unstable
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


NOTE = (
    "slower than its cuts join an undamped beam takes up power at all frequencies, and under one mass that is faster "
    "as many roots grow as at a certified point: no boxes are needed"
)


@dataclass(frozen=True)
class Decided:
    """quiet: the cells in which nothing grows; alike: cells in all of which the same number of roots grows."""

    quiet: Truths
    alike: Truths
    note: str


def decided(problem: Problem, over: Mapping[str, Interval], edges: Sequence[Sequence[Fraction]]) -> Decided | None:
    """The cells between edges; None where boxes are to tell."""
    shape = tuple(len(ends) - 1 for ends in edges)
    why = never_unstable(problem, over)
    if why is not None:
        return Decided(np.ones(shape, bool), np.zeros(shape, bool), why)
    if not undamped.no_damping(problem, over):
        return None
    paths = list(over)
    fast = next((k for k, path in enumerate(paths) if path in undamped.SPEEDS), 0)
    other = 1 - fast
    speed, n = paths[fast] in undamped.SPEEDS, shape[fast]

    def quiet(row: tuple[int, int], last: int, first: int = 0) -> bool:
        each = ((fast, (first, last)), (other, row))
        return undamped.never_unstable(problem, {paths[k]: (edges[k][a], edges[k][b]) for k, (a, b) in each})

    of_vehicles = undamped.of_vehicles(paths[other])  # the same in all rows
    rows = [(0, shape[other])] if of_vehicles else [(j, j + 1) for j in range(shape[other])]
    still = np.zeros((len(rows), n), bool)
    for row, ends in zip(still, rows, strict=True):
        if speed:
            row[: _most(partial(quiet, ends), n)] = True
        else:
            row[:] = [quiet(ends, i + 1, i) for i in range(n)]
    alike = np.zeros(n, bool)
    if of_vehicles:

        def same(m: int) -> bool:
            return lone_mass.alike(problem, dict(over) | {paths[fast]: (edges[fast][n - m], edges[fast][n])})

        alike[n - (_most(same, n) if speed else n * same(n)) :] = True
    low, high = (np.broadcast_to(each, (shape[other], n)) for each in (still, alike))
    return Decided(low if other == 0 else low.T, high if other == 0 else high.T, NOTE)


def _most(holds: Callable[[int], bool], n: int) -> int:
    """The greatest m ≤ n for which it holds, as it holds of all below it too; 0 where none is found."""
    low, high = 0, n + 1
    while high - low > 1:
        middle = n if high == n + 1 else (low + high) // 2
        low, high = (middle, high) if holds(middle) else (low, middle)
    return low
