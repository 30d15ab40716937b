"""Stability charts as proved regions: how many roots grow over two parameters.

The box of (q, x, y) is covered. Boxes that stay open project to a thin strip of cells round the curves on which a
root is real, whatever folds, crossings and cusps they have. No root is real over any other cell, so the number of
roots that grow is the same on each connected part of them: one certified spectrum in each tells it.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from fractions import Fraction
from time import process_time
from typing import Any

import numpy as np

from mpsolve.certificate.solve import certify_problem
from mpsolve.errors import EffortError, InputError
from mpsolve.outcome import Reason, Status
from mpsolve.parallel.threads import one_thread
from mpsolve.problem.cases import Given, as_problem
from mpsolve.problem.problem import Problem
from mpsolve.progress import Progress, silent
from mpsolve.proof.effort import Effort
from mpsolve.proof.stopping import stoppable
from mpsolve.proof.subdivide import subdivide
from mpsolve.ranges.answer import Answer, Interval, Proof, Spent
from mpsolve.ranges.scope import OpenError, Scope, checked_over, from_above_rest, scope_of
from mpsolve.spectrum.regions import HalfPlane

_BOXES = 1_000_000
_DEPTH = 7  # halvings of each parameter
_FINER = 6  # more halvings of the frequency than of a parameter, before a cell counts as open
_MOST_PARTS = 60
NOTE = "no certificate states the regions of a chart; the roots at one point of each are certified"
BOUNDARY = -1
OPEN = -2


@dataclass(frozen=True)
class Part:
    """A connected part of the chart on which no root is real: the number of roots that grow, proved at one point.

    cells: how many; point: the exact parameters at which the roots were certified; roots: None where that is open.
    """

    cells: int
    point: Mapping[str, Fraction]
    roots: int | None
    spectrum: Any = field(repr=False, default=None)


@dataclass(frozen=True)
class Chart(Answer):
    """counts[i, j]: the number of growing roots over the cell x[i] … x[i + 1], y[j] … y[j + 1]; −1: a boundary passes
    or may pass through the cell; −2: open. x, y: edges of cells, in the problem's units, as exact numbers.
    """

    x: tuple[Fraction, ...] = ()
    y: tuple[Fraction, ...] = ()
    counts: Any = None
    parts: tuple[Part, ...] = ()

    @property
    def share(self) -> float:
        """Of the area of the chart that is decided."""
        return float((self.counts >= 0).mean()) if self.counts is not None else 0.0

    def at(self, x: object, y: object) -> int | None:
        """The number of growing roots at a point, None where the chart does not tell; InputError outside of it."""
        i, j = (
            _cell(edges, value, path) for edges, value, path in zip((self.x, self.y), (x, y), self.over, strict=True)
        )
        count = int(self.counts[i, j])
        return count if count >= 0 else None

    def rows(self) -> list[Mapping[str, Any]]:
        """The answer as a table, numbers as floats: one mapping for each row."""
        return [{path: float(v) for path, v in part.point.items()} | {"roots": part.roots, "cells": part.cells}
                for part in self.parts]  # fmt: skip


@stoppable
def stability_chart(
    problem: Given,
    *,
    over: Mapping[str, Any],
    depth: int = _DEPTH,
    effort: Effort | None = None,
    progress: Progress | None = None,
    check: bool = True,
) -> Chart:
    """The exact number of growing roots over two parameters, as proved regions and thin strips between them.

    over: {path: (low, high)} of two parameters, in the problem's units. depth: of 2^depth cells along each of them.
    A range from v = 0 begins a little above it where the equations lose waves at rest, as `.over` says.
    The answer is proved where every region is decided; strips round the boundaries are part of it. There is no
    certificate. InputError for paths and ranges that cannot be.
    """
    given = as_problem(problem)
    ranges = from_above_rest(given, checked_over(given, over))
    if len(ranges) != 2:
        times = "once" if len(ranges) == 1 else f"{len(ranges)} times"
        raise InputError("over", f"is given {times}, but a chart is over two parameters: give a range for each")
    if not 2 <= depth <= 10:
        raise InputError("depth", f"is {depth}: give 2 to 10, a chart has 2^depth cells along each parameter")
    with one_thread():
        found = _chart(given, ranges, depth, effort, progress or silent, check)
    return replace(found, problem=problem)


def _chart(
    problem: Problem, over: dict[str, Interval], depth: int, effort: Effort | None, progress: Progress, check: bool
) -> Chart:
    started = process_time()
    budget = effort.anew() if effort is not None else Effort(evaluations=_BOXES)
    scope = scope_of(problem, over)
    edges = [tuple(a + (b - a) * Fraction(k, 2**depth) for k in range(2**depth + 1)) for a, b in over.values()]
    try:
        X = scope.X
    except OpenError as error:
        counts = np.full((2**depth, 2**depth), OPEN)
        cost = Spent(process_time() - started)
        return Chart(problem, over, Status.UNDECIDED, error.reason, cost=cost, x=edges[0], y=edges[1], counts=counts)
    low, high = scope.corners
    smallest = 2.0 ** -np.array([depth + _FINER, depth, depth])
    tell = lambda share: progress("boxes", 0.8 * share)  # noqa: E731
    cover = subdivide(low, high, scope.judge(), budget, smallest, tell)
    spent = cover.reason is not None and cover.reason.code != "boxes"
    counts = _marked(scope, cover.tree, depth)
    labels = parts_of(counts == 0)
    parts, reason = _counted(problem, scope, edges, labels, counts, budget, progress, check)
    family = scope.family
    proof = Proof(over, family.units, family.frequency_unit, X, cover)
    verification = sum(part.spectrum.cost.verification for part in parts if part.spectrum is not None)
    cost = Spent(process_time() - started - verification, verification, budget.spent)
    reason = cover.reason if spent else reason
    told: dict[str, Any] = {"note": "" if reason else NOTE, "proofs": (proof,), "cost": cost}
    status = Status.UNDECIDED if reason is not None else Status.UNVERIFIED
    return Chart(problem, over, status, reason, x=edges[0], y=edges[1], counts=counts, parts=parts, **told)


def _marked(scope: Scope, tree: Any, depth: int) -> Any:
    """0 where no box over the cell stayed open, else BOUNDARY; a box that only touches a cell counts too."""
    n = 2**depth
    counts = np.zeros((n, n), int)
    low, high = tree.boxes(tree.open)
    width = scope.high - scope.low
    first = np.floor((low[1:] - scope.low[:, None]) / width[:, None] * n - 2.0**-20).astype(int).clip(0, n - 1)
    last = np.floor((high[1:] - scope.low[:, None]) / width[:, None] * n + 2.0**-20).astype(int).clip(0, n - 1)
    for i, j, k, m in zip(first[0], first[1], last[0], last[1], strict=True):
        counts[i : k + 1, j : m + 1] = BOUNDARY
    return counts


def parts_of(free: Any) -> Any:
    """Labels 1, 2, … of the connected parts of the free cells, which share sides; 0 elsewhere."""
    labels = np.zeros(free.shape, int)
    current = 0
    for start in np.argwhere(free):
        if labels[tuple(start)]:
            continue
        current += 1
        labels[tuple(start)] = current
        stack = [tuple(start)]
        while stack:
            i, j = stack.pop()
            for k, m in ((i - 1, j), (i + 1, j), (i, j - 1), (i, j + 1)):
                if 0 <= k < free.shape[0] and 0 <= m < free.shape[1] and free[k, m] and not labels[k, m]:
                    labels[k, m] = current
                    stack.append((k, m))
    return labels


def _counted(
    problem: Problem,
    scope: Scope,
    edges: Any,
    labels: Any,
    counts: Any,
    budget: Effort,
    progress: Progress,
    check: bool,
) -> tuple[tuple[Part, ...], Reason | None]:
    """The parts with their counts, which are written into `counts`; the greatest first."""
    sizes = np.bincount(labels.ravel())[1:]
    order = np.argsort(-sizes, kind="stable")
    parts: list[Part] = []
    reason: Reason | None = None
    for number, k in enumerate(order):
        where = labels == k + 1
        if number >= _MOST_PARTS:
            counts[where] = OPEN
            reason = reason or _too_many(len(order))
            continue
        progress("regions", 0.8 + 0.2 * number / len(order))
        i, j = _inmost(where)
        point = {
            path: (ends[n] + ends[n + 1]) / 2 for path, ends, n in zip(scope.family.paths, edges, (i, j), strict=True)
        }
        try:
            budget.spend(1)
            found = certify_problem(_at(problem, point), region="unstable", digits=15, check=check)
        except EffortError as error:
            reason = reason or error.reason
            counts[where] = OPEN
            parts.append(Part(int(sizes[k]), point, None))
            continue
        roots = found.unstable if _whole(found) else None
        counts[where] = OPEN if roots is None else roots
        parts.append(Part(int(sizes[k]), point, roots, found))
        if roots is None and reason is None:
            reason = found.reason or Reason("base", "the roots of a region are not counted", {}, "")
    return tuple(parts), reason


def _too_many(parts: int) -> Reason:
    stated = f"the chart falls into {parts} parts, of which {_MOST_PARTS} are counted"
    return Reason("parts", stated, {"parts": str(parts)}, "raise the depth, so that small parts come together")


def _whole(found: Any) -> bool:
    """Whether the count is that of the whole half-plane Im q < 0."""
    return bool(found.proved) and found.region == HalfPlane()


def _at(problem: Problem, point: Mapping[str, Fraction]) -> Problem:
    for path, value in sorted(point.items(), key=lambda one: one[0].startswith("scale.")):
        problem = problem.changed(path, value)
    return problem


def _inmost(where: Any) -> tuple[int, int]:
    """A cell far from the edge of its part."""
    kept = where
    while True:
        inner = kept.copy()
        inner[1:], inner[:-1] = inner[1:] & kept[:-1], inner[:-1] & kept[1:]
        inner[:, 1:], inner[:, :-1] = inner[:, 1:] & kept[:, :-1], inner[:, :-1] & kept[:, 1:]
        inner[[0, -1]], inner[:, [0, -1]] = False, False
        if not inner.any():
            i, j = np.argwhere(kept)[len(np.argwhere(kept)) // 2]
            return int(i), int(j)
        kept = inner


def _cell(edges: tuple[Fraction, ...], value: object, path: str) -> int:
    from mpsolve.numbers.model import rational, shown

    number = rational(value, path)
    if not edges[0] <= number <= edges[-1]:
        raise InputError(path, f"is {shown(number)}, outside the chart from {shown(edges[0])} to {shown(edges[-1])}")
    step = (edges[-1] - edges[0]) / (len(edges) - 1)
    return min(int((number - edges[0]) / step), len(edges) - 2)
