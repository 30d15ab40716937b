"""Points on curves, in floats, put in the order in which the curves pass them. Nothing here is proved."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

import numpy as np

from mpsolve.numbers.arrays import Reals, Truths

_FINE = 240  # of the whole: one point is kept in each cell of this size
_FAR = 6.0  # cells: to the next point at most
_TO_ZERO = 24.0  # cells: to the end of a curve at q̂ = 0, where there are few points
_AHEAD = 0.5  # the cosine of how far aside it may lie
Corrected = Callable[[Any, int], Any]
"""Points (3, n) put on the curves with one coordinate as it is; those without one are left out."""


@dataclass(frozen=True)
class Path:
    """points (3, n) in their order.

    whole: whether it comes back to its start, which then stands at both ends, or both ends lie on the edge, or where
    q̂ = 0.
    """

    points: Reals
    whole: bool


def ordered(points: Reals, tangents: Reals, corners: tuple[Reals, Reals], corrected: Corrected) -> list[Path]:
    """Of points (q̂, x̂, ŷ) and directions, the paths of more than two points. q̂ = 0 is an edge too."""
    if points.shape[1] < 2:
        return []
    whole = np.array([np.ptp(points[0]) or 1.0, *(corners[1] - corners[0])[1:]])[:, None]
    z = points / whole * _FINE
    _, kept = np.unique(np.floor(z), axis=1, return_index=True)
    z, way = z[:, kept], (tangents * (corners[1] - corners[0])[:, None] / whole)[:, kept]
    way = way / np.linalg.norm(way, axis=0)
    free = np.ones(z.shape[1], bool)
    out = []
    while free.any():
        start = int(free.argmax())
        free[start] = False
        ahead, closed = _walk(z, way, start, 1.0, free)
        rows = [start, *ahead]
        if closed:
            rows.append(start)
        else:
            behind, _ = _walk(z, way, start, -1.0, free)
            rows = [*behind[::-1], *rows]
        if len(rows) > 2:
            out.append(_to_edges(points[:, kept][:, rows], closed, corners, whole, corrected))
    return out


def _walk(z: Reals, way: Reals, start: int, sign: float, free: Truths) -> tuple[list[int], bool]:
    """(the next points one after the other, whether they come back to the start); they are free no more."""
    at, direction = start, sign * way[:, start]
    out: list[int] = []
    while True:
        apart = z - z[:, at : at + 1]
        distance = np.linalg.norm(apart, axis=0)
        along = direction @ apart
        usable = free & (distance < _FAR) & (along > _AHEAD * distance)
        back = distance[start]
        near = len(out) > 3 and back < _FAR and along[start] > _AHEAD * back
        if near and not (distance[usable] < back).any():
            return out, True
        if not usable.any():
            return out, False
        # what lies beside the way, or back along another part of the curve, counts as farther
        cost = np.where(usable, distance * (2 - along / np.where(distance > 0, distance, 1)), np.inf)
        at = int(cost.argmin())
        free[at] = False
        direction = way[:, at] * np.sign(direction @ way[:, at] or 1.0)
        out.append(at)


def _to_edges(rows: Reals, closed: bool, corners: tuple[Reals, Reals], whole: Reals, corrected: Corrected) -> Path:
    """With the ends on the edge, where it is near."""
    if closed:
        return Path(rows, True)
    ends = [_on_edge(rows[:, k], rows[:, j], corners, whole, corrected) for k, j in ((0, 1), (-1, -2))]
    points = (
        [one for one in (ends[0],) if one is not None] + list(rows.T) + [one for one in ends[1:] if one is not None]
    )
    return Path(np.array(points).T, all(one is not None for one in ends))


def _on_edge(
    last: Reals, before: Reals, corners: tuple[Reals, Reals], whole: Reals, corrected: Corrected
) -> Reals | None:
    """The point on the edge to which the last step leads; None where none is near."""
    step = last - before
    best: tuple[float, int, float] | None = None
    for k in range(3):
        edge = corners[1][k] if step[k] > 0 else corners[0][k]
        if step[k]:
            times = float((edge - last[k]) / step[k])
            if times >= 0 and (best is None or times < best[0]):
                best = times, k, float(edge)
    if best is None:
        return None
    far = _FAR if best[1] else _TO_ZERO
    if np.linalg.norm(best[0] * step / whole[:, 0]) * _FINE > far:
        return None
    seed = last + best[0] * step
    seed[best[1]] = best[2]
    found = corrected(seed[:, None], best[1])
    near = found.shape[1] and np.linalg.norm((found[:, 0] - last) / whole[:, 0]) * _FINE <= 2 * far
    return found[:, 0] if near else None
