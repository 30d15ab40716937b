"""Cells of a chart of which theorems tell all, without boxes: of undamped beams and of strings (see `never`)."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction
from functools import partial

import numpy as np

from mpsolve.numbers.arrays import Truths
from mpsolve.problem.family import Interval
from mpsolve.problem.problem import Problem
from mpsolve.ranges import lone_mass, undamped
from mpsolve.ranges.never import never_unstable

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
