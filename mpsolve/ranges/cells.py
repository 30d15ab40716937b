"""Cells of a chart: which of them a boundary may meet, and how those that none meets hang together."""

from __future__ import annotations

from typing import Any

import numpy as np

from mpsolve.numbers.arrays import Integers, Reals, Truths

BOUNDARY = -1
OPEN = -2
_SLACK = 2.0**-20  # of a cell: rounding of where boxes lie


def marked(low: Reals, high: Reals, shape: tuple[int, int]) -> Integers:
    """0 where no box meets the cell, else BOUNDARY; boxes in shares of the chart, shape (2, boxes).

    A box that only touches a cell counts too.
    """
    counts = np.zeros(shape, int)
    n = np.array(shape)[:, None]
    first = np.floor(low * n - _SLACK).astype(int).clip(0, n - 1)
    last = np.floor(high * n + _SLACK).astype(int).clip(0, n - 1)
    for i, j, k, m in zip(*first.tolist(), *last.tolist(), strict=True):
        counts[i : k + 1, j : m + 1] = BOUNDARY
    return counts


def parts_of(free: Any) -> Integers:
    """Labels 1, 2, … of the connected parts of the free cells, which share sides; 0 elsewhere."""
    labels = np.zeros(free.shape, int)
    current = 0
    for start in np.argwhere(free):
        if not labels[tuple(start)]:
            current += 1
            labels[tuple(start)] = current
            spread(labels, free, [(int(start[0]), int(start[1]))])
    return labels


def spread(labels: Integers, free: Truths, from_cells: list[tuple[int, int]]) -> None:
    """Labels go from cells to all free ones without a label that hang together with them."""
    high, wide = free.shape
    stack = from_cells
    while stack:
        i, j = stack.pop()
        for k, m in ((i - 1, j), (i + 1, j), (i, j - 1), (i, j + 1)):
            if 0 <= k < high and 0 <= m < wide and free[k, m] and not labels[k, m]:
                labels[k, m] = labels[i, j]
                stack.append((k, m))


def grown(cells: Truths, *axes: int) -> Truths:
    """With the neighbours along each of these axes."""
    out = cells.copy()
    for axis in axes:
        to, of = np.moveaxis(out, axis, 0), np.moveaxis(cells, axis, 0)
        to[1:] |= of[:-1]
        to[:-1] |= of[1:]
    return out


def finer(labels: Integers, free: Truths) -> Integers:
    """Labels of cells handed on to those of a finer grid, whose free ones no boundary meets; new parts count on.

    Finer cells of one that has a label have that label.
    """
    each = free.shape[0] // labels.shape[0]
    out = np.repeat(np.repeat(labels, each, 0), each, 1)
    known = out > 0
    spread(out, free, [(int(i), int(j)) for i, j in np.argwhere(known & grown(free & ~known, 0, 1))])
    rest = parts_of(free & (out == 0))
    return np.where(rest > 0, rest + out.max(), out)


def inmost(where: Any) -> tuple[int, int]:
    """A cell far from the edge of its part."""
    kept = where
    while True:
        inner = ~grown(~kept, 0, 1)
        inner[[0, -1]], inner[:, [0, -1]] = False, False
        if not inner.any():
            every = np.argwhere(kept)
            i, j = every[len(every) // 2]
            return int(i), int(j)
        kept = inner


def met(shape: tuple[int, ...], edges: Any, curves: Any) -> Truths:
    """Cells that a curve meets, in floats. edges: of both parameters; curves: with x and y."""
    out = np.zeros(shape, bool)
    for curve in curves:
        z = np.stack([
            (np.asarray(v, float) - float(e[0])) / float(e[-1] - e[0]) * n
            for v, e, n in zip((curve.x, curve.y), edges, shape, strict=True)
        ])  # fmt: skip
        count = np.maximum(np.ceil(np.abs(np.diff(z)).max(0) * 4), 1).astype(int)
        index = np.repeat(np.arange(len(count)), count + 1)
        share = np.concatenate([np.linspace(0, 1, n + 1) for n in count.tolist()])
        line = z[:, index] + (z[:, index + 1] - z[:, index]) * share
        i, j = (np.floor(v).astype(int).clip(0, m - 1) for v, m in zip(line, shape, strict=True))
        out[i, j] = True
    return out


def next_to(shape: tuple[int, ...], edges: Any, curves: Any) -> Truths:
    """These and all cells round them, up to two away."""
    cells = met(shape, edges, curves)
    for axis in (0, 0, 1, 1):
        cells = grown(cells, axis)
    return cells
