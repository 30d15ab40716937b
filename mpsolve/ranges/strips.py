"""Thin strips of a chart that hold all that the arcs of real roots show of it, and points near the arcs."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np

from mpsolve.characteristic.free_matrix import FreeMatrix
from mpsolve.numbers.arrays import Reals
from mpsolve.proof.subdivide import BATCH, Tree
from mpsolve.ranges.arcs import HALF, PIECES, Arcs, arcs
from mpsolve.ranges.cells import marked

_MOST = 64  # parts of a piece
_POINTS = 120  # along each parameter: how fine points near arcs are


@dataclass(frozen=True)
class Strips:
    """low, high: boxes (x, y) in shares of the chart, which hold all; near: points (q̂, x̂, ŷ) about on the arcs, q̂ = 0
    exactly for those whose zeros have q = 0.
    """

    low: Reals
    high: Reals
    near: Reals


def strips_of(matrix: FreeMatrix, low: Reals, high: Reals, corners: tuple[Reals, Reals], cells: int) -> Strips:
    """Of leaves with arcs. corners: of the whole; cells: how fine the strips are, along each parameter."""
    boxes: list[tuple[Any, Any]] = [(np.zeros((2, 0)), np.zeros((2, 0)))]
    points = [np.zeros((3, 0))]
    middles = (np.arange(PIECES) + 0.5) / PIECES - HALF
    for start in range(0, low.shape[1], BATCH):
        part = slice(start, start + BATCH)
        found, _ = arcs(matrix, low[:, part], high[:, part])
        for t in middles.tolist() if len(found.pivot) else ():
            boxes.append(_strips(found, t, corners, cells))
            points.append(_points(found, t, corners))
    lows, highs = (np.concatenate([one[k] for one in boxes], 1) for k in range(2))
    return Strips(lows, highs, np.concatenate(points, 1))


def _points(found: Arcs, t: float, corners: tuple[Any, Any]) -> Any:
    """Where arcs pass a piece, about, inside of their leaves."""
    part = _parts(found, t, corners, _POINTS)
    point = np.where(part.pick.at_zero, np.array([[0.0], [1.0], [1.0]]), 1.0) * part.centre
    return point[:, ((point >= part.pick.low) & (point <= part.pick.high)).all(0)]


def _strips(found: Arcs, t: float, corners: tuple[Any, Any], cells: int) -> tuple[Any, Any]:
    part = _parts(found, t, corners, cells)
    pick, size = part.pick, part.size
    room = 2.0**-46 * (np.abs(pick.m) + pick.r + size)
    a, b = (
        np.fmax(part.centre - size - room, pick.low),
        np.fmin(part.centre + size + room, pick.high),
    )  # nan: the leaf
    keep = ~(a > b).any(0)
    low, high = (((end[:, keep] - corners[0][:, None]) / (corners[1] - corners[0])[:, None])[1:] for end in (a, b))
    return low, high


@dataclass(frozen=True)
class _Parts:
    """Parts of a piece, none of which is much larger than a cell. pick: the arc of each; zeros lie within `size` of
    `centre`.
    """

    pick: Arcs
    centre: Reals
    size: Any


def _parts(found: Arcs, t: float, corners: tuple[Reals, Reals], cells: int) -> _Parts:
    half, whole = HALF / PIECES, (corners[1] - corners[0])[:, None]
    piece = found.pieces(t, half)
    reach = np.nan_to_num(np.abs(piece.lean) * half, nan=np.inf)
    size = (found.place(reach, np.full(reach.shape[1], half)) * found.r / whole)[1:].max(0) * 2 * cells
    count = np.clip(np.ceil(size), 1, _MOST).astype(int)
    index = np.repeat(np.arange(len(count)), count)
    step = np.concatenate([np.arange(n) for n in count.tolist()])
    share = half / count[index]
    tau = (2 * step + 1) * share - half
    pick = found.take(index)
    lean, around = piece.lean[:, index], piece.around[:, index]
    centre = pick.m + pick.place(piece.centre[:, index] + lean * tau, t + tau) * pick.r
    return _Parts(pick, centre, pick.place(np.abs(lean) * share + around, share) * pick.r)


def free_cells(corners: tuple[Reals, Reals], tree: Tree, strips: Strips, cells: int) -> Any:
    """The cells, so many along each parameter, over which no root is real: neither strips nor open boxes meet them.

    Cells are exact parts of the range, shares are of floats next to its ends: in a narrow range that is not the same.
    """
    start, end = (side[1:, None] for side in corners)
    width = end - start
    beside = 2.0**-50 * np.maximum(np.abs(start), np.abs(end)) / width
    rest = ((side[1:] - start) / width for side in tree.boxes(tree.open))
    low, high = (np.concatenate([one, other], 1) for one, other in zip(rest, (strips.low, strips.high), strict=True))
    return marked(low - beside, high + beside, (cells, cells)) == 0
