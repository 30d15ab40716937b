"""Stability charts as proved regions: how many roots grow over two parameters, and the curves between them.

The box of (q, x, y) is covered. In a leaf either no root is real, or the real roots form one arc at most (`arcs`).
The arcs are enclosed piece by piece, so that they project to thin strips round the curves on which a root is real,
whatever folds, crossings and cusps these have. No root is real over any cell that no strip meets, so the number of
roots that grow is the same on each connected part of them: one certified spectrum in each tells it. The curves
themselves are proved by chains of boxes (`boundary`).
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from fractions import Fraction
from time import process_time
from typing import Any, ClassVar

import numpy as np

from mpsolve.errors import InputError
from mpsolve.numbers.arrays import Integers
from mpsolve.outcome import Status
from mpsolve.parallel.threads import one_thread
from mpsolve.problem.cases import Given, as_problem
from mpsolve.problem.problem import Problem
from mpsolve.progress import Progress, silent
from mpsolve.proof.effort import Effort, begun
from mpsolve.proof.in_time import in_time
from mpsolve.proof.stopping import stoppable
from mpsolve.proof.subdivide import Tree, subdivide
from mpsolve.ranges.answer import Answer, Interval, Proof, Spent
from mpsolve.ranges.arcs import ArcJudge
from mpsolve.ranges.base import base_at, growing, uncounted
from mpsolve.ranges.boundary import Boundary, boundaries
from mpsolve.ranges.cells import BOUNDARY, OPEN, finer, next_to, parts_of
from mpsolve.ranges.certified import Base, Verified, chart_certificate, verified
from mpsolve.ranges.chart_parts import Decided, Part, counted, decided, point_in
from mpsolve.ranges.judge import ARC
from mpsolve.ranges.meeting import Meeting, meetings
from mpsolve.ranges.scope import OpenError, Scope, checked_over, from_above_rest, scope_of
from mpsolve.ranges.strips import free_cells, strips_of
from mpsolve.ranges.undamped import at_corner, left_open

_BOXES = 1_000_000
_DEPTH = 7  # halvings of each parameter
_SMALLER = (9, 4, 4)  # halvings of (q, x, y) beyond those, or beyond _FINE, before a box stays open
_FINE = 5
_THIN = 0.25  # of a fine cell: how well curves are to be known where a box is closed
_FINER_CELLS = 4  # along each parameter: the cells of `detail` in one of `counts`


@dataclass(frozen=True)
class Chart(Answer):
    """counts[i, j]: the number of growing roots over the cell x[i] … x[i + 1], y[j] … y[j + 1]; −1: a boundary passes
    or may pass through the cell; −2: open. x, y: edges of cells, in the problem's units, as exact numbers.
    detail: the same of cells that are finer along each parameter. boundaries: the curves on which a root is real;
    meetings: points at which two of them cross, or one of pairs comes to q = 0, those that are proved.
    traced: whether each curve goes from edge to edge of the chart, back to its start or to q = 0, and each cell of
    `detail` that is −1 is at most two away from one that a curve meets.
    """

    hidden: ClassVar[frozenset[str]] = Answer.hidden | {"detail"}

    x: tuple[Fraction, ...] = ()
    y: tuple[Fraction, ...] = ()
    counts: Any = None
    parts: tuple[Part, ...] = ()
    boundaries: tuple[Boundary, ...] = ()
    meetings: tuple[Meeting, ...] = ()
    traced: bool = False
    detail: Integers | None = field(default=None, repr=False)

    @property
    def share(self) -> float:
        """Of the area of the chart that is decided."""
        cells = self.counts if self.detail is None else self.detail
        return float((cells >= 0).mean()) if cells is not None else 0.0

    def at(self, x: object, y: object) -> int | None:
        """The number of growing roots at a point, None where the chart does not tell; InputError outside of it."""
        cells = self.counts if self.detail is None else self.detail
        i, j = (
            _cell(edges[0], edges[-1], n, value, path)
            for edges, n, value, path in zip((self.x, self.y), cells.shape, (x, y), self.over, strict=True)
        )
        count = int(cells[i, j])
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
    The answer is proved where every region is decided; strips round the boundaries are part of it. The certificate
    states the number over each cell of `detail`, not the curves. InputError for paths and ranges that cannot be.
    """
    given = as_problem(problem)
    ranges = from_above_rest(given, checked_over(problem, over))
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
    budget = begun(effort, _BOXES)
    edges = [tuple(a + (b - a) * Fraction(k, 2**depth) for k in range(2**depth + 1)) for a, b in over.values()]
    told = decided(problem, over, edges)
    if told is not None:
        return replace(_by_theorem(problem, over, edges, told, effort, check), x=edges[0], y=edges[1])
    scope = scope_of(problem, over)
    try:
        X = scope.X
    except OpenError as error:
        counts = np.full((2**depth, 2**depth), OPEN)
        cost = Spent.since(started)
        return Chart(problem, over, Status.UNDECIDED, error.reason, cost=cost, x=edges[0], y=edges[1], counts=counts)
    low, high = scope.corners
    smallest = 2.0 ** -(float(max(depth, _FINE)) + np.array(_SMALLER))
    tell = lambda share: progress("boxes", 0.7 * share)  # noqa: E731
    cells = 2**depth * _FINER_CELLS
    cover = subdivide(low, high, scope.judge(ArcJudge, thin=_THIN / cells), budget, smallest, tell)
    spent = cover.reason is not None and cover.reason.code != "boxes"
    strips = strips_of(scope.matrix, *cover.tree.boxes(np.flatnonzero(cover.tree.kind == ARC)), scope.corners, cells)
    free = free_cells(scope.corners, cover.tree, strips, cells)
    units = tuple(map(float, (scope.family.frequency_unit, *scope.family.units)))
    rest = sum(cover.tree.boxes(cover.tree.open)) / 2
    labels = parts_of(free.reshape(2**depth, _FINER_CELLS, 2**depth, _FINER_CELLS).all((1, 3)))
    detail = np.where(free, 0, BOUNDARY)
    parts, regions, reason = counted(
        problem, over, (edges[0], edges[1]), (labels, finer(labels, free)), detail, budget, progress, check
    )
    progress("boundaries", 0.9)
    near = np.concatenate([strips.near, rest], 1)
    drawn, late, _ = in_time(
        lambda: boundaries(scope.matrix, near, scope.corners, units), budget, "the curves were followed"
    )
    curves = drawn or ()
    counts = np.where(labels > 0, detail[::_FINER_CELLS, ::_FINER_CELLS], BOUNDARY)
    family = scope.family
    proof = Proof(over, family.units, family.frequency_unit, X, cover)
    reason = cover.reason if spent else reason
    cost = Spent.since(started, *(part.spectrum for part in parts), boxes=budget.spent)
    progress("verifying", 0.9)
    made = _certified(scope, cover.tree, parts, regions, budget if check else None) if reason is None else None
    proofs = tuple(replace(proof, base=part.spectrum) for part in parts) or (proof,)
    more: dict[str, Any] = {"proofs": proofs, "cost": cost}
    if made:
        more |= {"note": late or made.note, "certificate": made.certificate, "cost": cost.with_check(made.seconds)}
    status = made.status if made else Status.UNDECIDED
    lost = (detail == BOUNDARY) & ~next_to(detail.shape, edges, curves)
    whole = all(curve.whole for curve in curves) and not lost.any()
    return Chart(
        problem, over, status, reason, x=edges[0], y=edges[1], counts=counts, parts=parts, boundaries=curves,
        meetings=meetings(scope, curves), traced=whole, detail=detail, **more,
    )  # fmt: skip


def _by_theorem(
    problem: Problem, over: dict[str, Interval], edges: Any, told: Decided, effort: Effort | None, check: bool
) -> Chart:
    """The chart where theorems tell of cells. Between those without and those with growing roots runs a boundary."""
    started = process_time()
    counts = np.where(told.quiet, 0, BOUNDARY if told.alike.any() else OPEN)
    parts, reason, found = [], None, None
    if told.quiet.any():
        parts.append(Part(int(told.quiet.sum()), point_in(over, edges, told.quiet), 0))
    if told.alike.any():
        point = point_in(over, edges, told.alike)
        found = base_at(at_corner(problem, point), effort, check)
        roots = growing(found)
        counts[told.alike] = OPEN if roots is None else roots
        parts.append(Part(int(told.alike.sum()), point, roots, found))
        reason = uncounted(found, "of a region") if roots is None else None
    if reason is None and (counts == OPEN).any():
        reason = left_open(problem, over)[0]
    return Chart(
        problem, over, Status.UNVERIFIED if reason is None else Status.UNDECIDED, reason, counts=counts,
        parts=tuple(parts), note=told.note, cost=Spent.since(started, found),
    )  # fmt: skip


def _certified(
    scope: Scope, tree: Tree, parts: tuple[Part, ...], regions: Integers, budget: Effort | None
) -> Verified:
    bases = [Base(tuple(part.point.values()), part.spectrum) for part in parts]
    return verified(lambda: chart_certificate(scope, tree, bases, regions), tree.nodes, budget)


def _cell(low: Fraction, high: Fraction, cells: int, value: object, path: str) -> int:
    from mpsolve.numbers.model import rational, shown

    number = rational(value, path)
    if not low <= number <= high:
        raise InputError(path, f"is {shown(number)}, outside the chart from {shown(low)} to {shown(high)}")
    return min(int((number - low) / (high - low) * cells), cells - 1)
