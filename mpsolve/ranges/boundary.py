"""The boundaries of a chart as proved curves: chains of boxes, in each of which a root is real along one arc.

Points near the curves are put on them in floats, and in order. Over a box round two neighbours the real roots form
one arc that passes from one to the other (`arcs`); the point between two boxes, in an enclosure, lies on both arcs.
So they are parts of one curve. Where a box is not proved a point is put between.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from itertools import pairwise
from typing import Any

import numpy as np

from mpsolve.characteristic.free_matrix import FreeMatrix
from mpsolve.numbers.arrays import Integers, Reals, Truths
from mpsolve.numbers.packed import Portable
from mpsolve.ranges.arcs import HALF, Arcs, arcs_over, models
from mpsolve.ranges.ordered import Path, ordered

_THIN = 2.0**-30  # of the whole: boxes that stand for points
_KNOT = 2.0**-16  # of the whole: boxes in which points are enclosed
_WIDER, _LEAST = 1.15, 0.15  # of a box: more than its points need, and of its longest side
_WIDTHS = (2.0**-10, 2.0**-6)  # of the whole: of boxes in q next to q = 0, where smaller ones do not do
_ASIDE = 2.0  # half-widths: boxes closer to q = 0 are taken with their mirror images
_ROUNDS, _CORRECTIONS = 9, 6
_NEAR = 1e-9  # of the whole: steps that are no longer taken


@dataclass(frozen=True)
class Boundary(Portable):
    """A curve on which a root q is real, proved: points (x, y, q) on it, floats to within `radius` in x and y, in the
    problem's units. Between two of them runs one arc.

    divergence: q = 0 all along. whole: it comes back to its start, or both ends lie on the chart's edge or, of a pair
    of roots that comes to q = 0, there.
    """

    x: Reals
    y: Any
    q: Any
    divergence: bool
    whole: bool
    radius: tuple[float, float]


def boundaries(matrix: FreeMatrix, near: Reals, corners: tuple[Reals, Any], units: Any) -> tuple[Boundary, ...]:
    """The curves next to points (q̂, x̂, ŷ), the longest first. units: of (q, x, y)."""
    whole = corners[1] - corners[0]
    out: list[Boundary] = []
    for zero in (True, False):
        curves = Curves(matrix, zero, whole)
        points, tangents, _ = curves.on(near[:, (near[0] == 0) == zero])
        paths = ordered(points, tangents, corners, lambda seeds, face: curves.on(seeds, face)[0])  # noqa: B023
        if paths:
            spread = max(float(np.ptp(path.points[0])) for path in paths)
            scale = np.array([spread or whole[0], *whole[1:]])
            out += proved_chains(replace(curves, whole=scale), paths, np.array(units), corners)
    return tuple(sorted(out, key=lambda one: -len(one.x)))


@dataclass(frozen=True)
class Curves:
    """Curves of roots with q = 0, if `zero`, or of pairs; whole: sizes of what is looked at."""

    matrix: FreeMatrix
    zero: bool
    whole: Reals

    def on(self, near: Reals, fixed: int | None = None) -> tuple[Reals, Reals, Integers]:
        """(points on the curves next to these, directions there, which of these have one) in floats.

        fixed: a coordinate that stays as it is.
        """
        points, whole = np.array(near, float), self.whole[:, None]
        r = np.repeat(whole * _THIN, points.shape[1], 1)
        free = np.ones(3)
        if fixed is not None:
            free[fixed] = 0.0
        step = np.zeros_like(points)
        with np.errstate(all="ignore"):
            for last in (*[False] * _CORRECTIONS, True):
                if not points.shape[1]:
                    return points, points, np.zeros(0, int)
                s = models(self.matrix, points, r, np.full(points.shape[1], self.zero))
                if last:
                    break
                M = np.stack([s.b.real, s.b.imag]) * free[:, None]  # (2, 3, points)
                gram = np.einsum("ikn,jkn->nij", M, M)
                value = np.stack([s.a.real, s.a.imag]).T
                good = np.isfinite(gram).all((1, 2)) & (np.linalg.det(gram) != 0)
                solved = np.linalg.solve(np.where(good[:, None, None], gram, np.eye(2)), value[:, :, None])[:, :, 0]
                step = np.where(good, -np.einsum("ikn,ni->kn", M, solved) * r, np.inf)
                points = points + step
                points[0] = np.where(near[0] == 0, 0.0, points[0])  # roots −q̄ are the mirror images of q
            tangent = np.cross(s.b.real.T, s.b.imag.T).T
            tangent = tangent / np.linalg.norm(tangent, axis=0)
            kept = (np.abs(step) < _NEAR * whole).all(0) & np.isfinite(tangent).all(0)
            kept &= (near[0] == 0) | (points[0] > _NEAR * whole[0])  # roots with q = 0 are no pair
        return points[:, kept], tangent[:, kept], np.flatnonzero(kept)

    def arcs(self, m: Reals, r: Reals, least: float = 0.0) -> Arcs:
        """Over boxes with these middles and half-widths; next to q = 0 over wider ones with their mirror images.

        least: the half-width of these in q, in shares of the whole.
        """
        m, r = np.array(m), np.array(r)
        least *= self.whole[0]
        near = m[0] < np.maximum(_ASIDE * r[0], least / _ASIDE)
        wide = np.maximum(np.where(m[0] > 0, _ASIDE * (m[0] + r[0]), r[0]), least)
        m[0], r[0] = np.where(near, 0.0, m[0]), np.where(near, wide, r[0])
        return arcs_over(self.matrix, m, r, self.zero)

    def enclosed(self, points: Reals) -> Reals:
        """How far from each point at most lies one that is proved: the only one of a small box at the same pivot."""
        size = np.full(points.shape, np.inf)
        for least in self.wider:
            rows = np.flatnonzero(np.isinf(size).any(0) & ((points[0] < least * self.whole[0]) | (least == 0)))
            if len(rows):
                size[:, rows] = self._enclosed(points[:, rows], least)
        return size

    @property
    def wider(self) -> tuple[float, ...]:
        """Half-widths in q of boxes next to q = 0, where very small ones tell nothing of how pairs move."""
        return (0.0,) if self.zero else (0.0, *_WIDTHS)

    def _enclosed(self, points: Reals, least: float) -> Reals:
        found = self.arcs(points, np.repeat(self.whole[:, None] * _KNOT, points.shape[1], 1), least)
        t = found.along((points - found.m) / found.r)
        piece = found.pieces(t, 0.0)
        offset = found.m + found.place(piece.centre, t) * found.r - points
        around = found.place(piece.around, np.zeros(points.shape[1])) * found.r
        size = (around + np.abs(offset)) * (1 + 2.0**-20) + 2.0**-50 * np.abs(points)
        return np.where(found.regular & piece.passes, size, np.inf)


@dataclass
class _Chain:
    """Points of one path; of each how far the one that is meant lies at most (∞: not proved, None: not asked yet).

    good: which steps to the next one are proved.
    """

    points: list[Reals]
    sizes: list[Any]
    good: list[bool]
    path: Path


def proved_chains(
    curves: Curves, paths: list[Path], units: Reals, corners: tuple[Reals, Reals] | None = None
) -> list[Boundary]:
    """What of the paths is proved, parted where a step is not."""
    chains = []
    for path in paths:
        points = list(path.points.T)
        chains.append(_Chain(points, [None] * len(points), [False] * (len(points) - 1), path))
    for turn in range(_ROUNDS):
        _enclosed(curves, chains)
        todo = [(chain, k) for chain in chains for k, good in enumerate(chain.good) if not good]
        if not todo:
            break
        ends = np.array([[chain.points[k], chain.points[k + 1]] for chain, k in todo]).transpose(1, 2, 0)
        sizes = np.array([[chain.sizes[k], chain.sizes[k + 1]] for chain, k in todo]).transpose(1, 2, 0)
        for (chain, k), held in zip(todo, _steps(curves, ends, sizes).tolist(), strict=True):
            chain.good[k] = held
        if turn < _ROUNDS - 1:
            _between(curves, chains)
    return [one for chain in chains for one in _curves(chain, units, corners)]


def _enclosed(curves: Curves, chains: list[_Chain]) -> None:
    """New points are enclosed."""
    todo = [(chain, k) for chain in chains for k, size in enumerate(chain.sizes) if size is None]
    if not todo:
        return
    size = curves.enclosed(np.array([chain.points[k] for chain, k in todo]).T)
    for n, (chain, k) in enumerate(todo):
        chain.sizes[k] = size[:, n]


def _between(curves: Curves, chains: list[_Chain]) -> None:
    """A point more in the middle of each step that is not proved; steps without one stay as they are."""
    todo = [(chain, k) for chain in chains for k, good in enumerate(chain.good) if not good]
    if not todo:
        return
    ends = np.array([[chain.points[k], chain.points[k + 1]] for chain, k in todo]).transpose(1, 2, 0)
    middles, way = ends.mean(0), np.abs(ends[1] - ends[0])
    found, _, rows = curves.on(middles)
    whole = curves.whole
    room = way + (way / whole[:, None]).max(0) * whole[:, None] / 4
    near = (np.abs(found - middles[:, rows]) <= room[:, rows]).all(0)
    for n in np.flatnonzero(near)[::-1].tolist():
        chain, k = todo[rows[n]]
        chain.points.insert(k + 1, found[:, n])
        chain.sizes.insert(k + 1, None)
        chain.good.insert(k + 1, False)


def _steps(curves: Curves, ends: Reals, sizes: Reals) -> Truths:
    """Between which ends one arc passes; sizes: of the enclosures of the ends."""
    out = np.zeros(ends.shape[2], bool)
    for least in curves.wider:
        rows = np.flatnonzero(~out & ((ends[:, 0].max(0) < least * curves.whole[0]) | (least == 0)))
        if len(rows):
            out[rows] = _steps_over(curves, ends[:, :, rows], sizes[:, :, rows], least)
    return out


def _steps_over(curves: Curves, ends: Reals, sizes: Reals, least: float) -> Any:
    middle, way, whole = ends.mean(0), np.abs(ends[1] - ends[0]), curves.whole[:, None]
    found = curves.arcs(middle, _WIDER * way + _LEAST * (way / whole).max(0) * whole, least)
    t, along = found.along((middle - found.m) / found.r), found.along(way / 2 / found.r)
    half = along * (1 + 2.0**-8)
    good = found.regular & found.pieces(t, half).passes & (np.abs(t) + half < HALF)
    for end, size in zip(ends, sizes, strict=True):
        share = (np.abs(end - found.m) + size) / found.r * (1 + 2.0**-20)
        there = found.along((np.abs(end - middle) + size) / found.r) * (1 + 2.0**-20)
        good &= (share < HALF).all(0) & (there < half)
    return good


def _curves(chain: _Chain, units: Reals, corners: tuple[Reals, Any] | None) -> list[Boundary]:
    """The parts of a chain that are proved without a gap, in the range; a step that leaves it leads to its edge."""
    points, good = np.array(chain.points), np.array(chain.good)
    unbroken = bool(good.all()) and chain.path.whole
    if corners is not None:
        inside = ((points >= corners[0]) & (points <= corners[1]))[:, 1:].all(1)
        good &= inside[1:] & inside[:-1]
    ends = [-1, *np.flatnonzero(~good).tolist(), len(good)]
    out = []
    for first, last in pairwise(ends):
        if last > first + 1:
            q, x, y = points[first + 1 : last + 1].T * units[:, None]
            _, dx, dy = (np.max(chain.sizes[first + 1 : last + 1], 0) * units).tolist()
            out.append(Boundary(x, y, q, not q.any(), unbroken, (dx, dy)))
    return out
