"""The endless row over boxes of (q, parameters, θ), z = e^{iθ}: its receptance and its matrix as Taylor models.

The sum over the row is one over p-roots (`lattice`). A root that is alone is a model, and so is its term, as long as
its wave does not fit the row, e^{Pd} ≠ z. Roots of one side that are close share a circle, on which Σ N/D times the
row's factor is summed as in `characteristic.circles`: the factor's poles have Re P = 0, and the circle stays off
them. The last variable is θ; the others are those of the family.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from fractions import Fraction
from functools import cached_property
from typing import Any

import numpy as np

from mpsolve.characteristic.boxes import Boxes, FreeTrack, Wave
from mpsolve.characteristic.circles import NOISE, Circles, Receptances, aliasing, circles_of, samples, summed
from mpsolve.characteristic.free_matrix import FreeMatrix
from mpsolve.characteristic.free_roots import FreeRoots, free_roots
from mpsolve.endless.lattice import first_force
from mpsolve.numbers.jets import TINY, UP, U, exponential, nearest
from mpsolve.numbers.quadratic import Quadratic, constant, joined, lifted
from mpsolve.problem.family import Family

_ISOLATED = 1.0 + 2.0**-10


@dataclass(frozen=True)
class FreeRow:
    """A family whose vehicle stands in a row: `step` is the distance to the next one, scaled as the family is."""

    family: Family
    step: Fraction

    @cached_property
    def places(self) -> tuple[Fraction, ...]:
        """Of the contacts of one vehicle; they do not depend on the parameters."""
        return tuple(place.at(self.family.ring.point) for place in self.family.places)

    @cached_property
    def distances(self) -> tuple[tuple[Fraction, ...], Any]:
        """(the different distances, for each pair of places the number of its own)."""
        exact = sorted({a - b for a in self.places for b in self.places})
        return tuple(exact), np.array([[exact.index(a - b) for b in self.places] for a in self.places])


@dataclass(frozen=True)
class RowReceptance:
    """Ĝ between the places of one vehicle over boxes (q̂, x̂, θ)."""

    row: FreeRow

    @cached_property
    def track(self) -> FreeTrack:
        return FreeTrack(self.row.family)

    def __call__(self, boxes: Boxes) -> Receptances:
        with np.errstate(all="ignore"):
            own = Boxes(boxes.m[:-1], boxes.r[:-1])
            whole = self.track.split(own)
            rows = np.flatnonzero(whole.good)
            m, exact, which = len(boxes.m), *self.row.distances
            k = np.zeros((len(constant(0.0, 1, m).k), boxes.count, len(exact)), complex)
            e = np.full((boxes.count, len(exact)), np.inf)
            strain = np.concatenate([whole.strain, np.zeros((1, boxes.count))])
            if len(rows):
                found, moved = self._sums(whole.take(rows), own.take(rows), boxes.take(rows))
                k[:, rows], e[rows] = found.k, found.e
                strain[:, rows] += moved
            good = whole.good & np.isfinite(e).all(1) & np.isfinite(k).all((0, 2))
            return Receptances(Quadratic(k, e, m)[:, which], good, replace(whole, strain=strain))

    def _sums(self, wave: Wave, own: Boxes, boxes: Boxes) -> tuple[Quadratic, Any]:
        """(Ĝ at each distance, shape (boxes, distances); how far each variable moves the terms of the sum)."""
        N = self.track.N(*own.variables)
        roots = free_roots(wave.D, N, wave.z, _within(wave))
        around = _turns(boxes)
        total: Quadratic | None = None
        alone = np.zeros(wave.z.shape, bool)
        for side in (True, False):
            mask = (np.arange(wave.z.shape[1]) < wave.up) == side
            if not mask.any():
                continue
            first = [first_force(a, self.row.step, side) for a in self.row.distances[0]]
            reach = np.full(boxes.count, max(abs(nearest(xi)) for xi, _ in first))
            circles = circles_of(wave, mask, reach, off_axis=True)
            lone = circles.size == 1
            alone[:, mask] = lone
            parts = [self._alone(roots, mask, lone, around, side, first)]
            shared = circles.active & ~lone
            if shared.any():
                parts.append(self._together(wave, N, replace(circles, active=shared), around, side, first))
            for part in parts:
                total = part if total is None else total + part
        if total is None:
            raise ValueError("a track has at least one p-root")
        fine = _apart(wave, roots, alone)
        sums = Quadratic(total.k, np.where(fine[:, None], total.e, np.inf), total.m)
        return sums, _moved(roots, wave.up, boxes, nearest(self.row.step))

    def _alone(
        self, roots: FreeRoots, mask: Any, lone: Any, around: tuple[Quadratic, Quadratic], side: bool, first: Any
    ) -> Quadratic:
        """The terms of simple roots of one side."""
        point, back = around
        P, w = (lifted(part[:, mask], point.m) for part in (roots.P, roots.w))
        step = nearest(self.row.step) * (1.0 if side else -1.0)
        ratio = P.times(step).exp() * (back if side else point)[:, None]
        heavy = w.times(1.0 if side else -1.0) * one_less(ratio).inverse()
        heavy = Quadratic(np.where(lone, heavy.k, 0), np.where(lone, heavy.e, 0.0), heavy.m)
        columns = []
        for xi, factor in first:
            wave = P.times(nearest(xi)).exp() if xi else None
            if wave is not None:
                wave = Quadratic(np.where(lone, wave.k, 0), np.where(lone, wave.e, 0.0), wave.m)
            term = (heavy if wave is None else wave * heavy).sum(-1)
            columns.append(_turned(term, factor, around)[:, None])
        return joined(columns, -1)

    def _together(
        self, wave: Wave, N: Quadratic, circles: Circles, around: tuple[Quadratic, Quadratic], side: bool, first: Any
    ) -> Quadratic:
        """The terms of roots of one side that share circles."""
        point, back = around
        f, points = samples(wave, N, circles)
        step = nearest(self.row.step) * (1.0 if side else -1.0)
        value, lost = exponential(points * step)
        c = constant(0.0, len(points), point.m)
        size = np.abs(value)
        k = np.zeros((len(c.k), *value.shape), complex)
        k[0] = value
        ratio = Quadratic(k, size * (lost + NOISE * (1 + np.abs(points * step))), point.m)
        over = one_less(ratio * (back if side else point)[:, None]).inverse()
        f = lifted(f, point.m) * over
        xi = np.array([nearest(a) for a, _ in first])
        sums = summed(f if side else -f, points, np.broadcast_to(xi, (len(points), len(xi))))
        depth = np.where(circles.active, np.abs(circles.centre.real) - circles.outer, np.inf).min(1)
        geometric = 1 / -np.expm1(-depth * abs(step) * (1 - 16 * U)) * (1 + 64 * U)
        geometric = np.where(depth > 0, geometric, np.inf)
        still = constant(xi, len(points), wave.D.m)
        missed = np.where(circles.active.any(1)[:, None], aliasing(wave, N, circles, still) * geometric[:, None], 0.0)
        sums = Quadratic(sums.k, (sums.e + missed) * UP, sums.m)
        columns = [_turned(sums[:, j], factor, around)[:, None] for j, (_, factor) in enumerate(first)]
        return joined(columns, -1)


def _turns(boxes: Boxes) -> tuple[Quadratic, Quadratic]:
    """(z, 1/z) as models of shape (boxes,)."""
    m = len(boxes.m)
    k = np.zeros((len(constant(0.0, 1, m).k), boxes.count), complex)
    k[0], k[m] = 1j * boxes.m[-1], 1j * boxes.r[-1]
    angle = Quadratic(k, 4 * U * np.abs(boxes.m[-1]), m)
    return angle.exp(), (-angle).exp()


def _turned(term: Quadratic, factor: int, around: tuple[Quadratic, Quadratic]) -> Quadratic:
    return term if not factor else term * around[0 if factor > 0 else 1]


def one_less(ratio: Quadratic) -> Quadratic:
    """1 − f."""
    k = -ratio.k
    k[0] = k[0] + 1
    return Quadratic(k, (ratio.e + 4 * U * np.abs(k).sum(0)) * UP + TINY, ratio.m)


def _moved(roots: FreeRoots, up: int, boxes: Boxes, step: float) -> Any:
    """In floats: how far each variable moves 1/(1 − e^{Pd}/z) relative to itself, at most, for any root."""
    P = roots.P.a
    ratio = np.exp(np.where(np.arange(P.shape[1]) < up, P, -P) * step)
    ratio = ratio * np.exp(1j * np.where(np.arange(P.shape[1]) < up, -1, 1) * boxes.m[-1][:, None])
    share = np.abs(ratio / (1 - ratio))
    angle = np.broadcast_to(boxes.r[-1][:, None], share.shape)
    moved = (np.concatenate([np.abs(roots.P.b) * step, angle[None]]) * share).max(2)
    return np.where(np.isfinite(moved), moved, 0.0)


def _apart(wave: Wave, roots: FreeRoots, alone: Any) -> Any:
    """Whether the discs of simple roots are disjoint, so that each holds the one root of its node.

    By Gershgorin the roots of a factor lie in the discs of `_within`, in a disc apart from the others just one.
    """
    z, n = wave.z, wave.z.shape[1]
    reach = np.where(alone, roots.radius, _within(wave)) * UP
    gap = np.abs(z[:, :, None] - z[:, None, :]) * (1 - 16 * U)
    both = alone[:, :, None] | alone[:, None, :]
    clear = (gap > reach[:, :, None] + reach[:, None, :]) | ~both | np.eye(n, dtype=bool)
    return clear.all((1, 2)) & (roots.good | ~alone).all(1)


def _within(wave: Wave) -> Any:
    """(the number of roots of its side) |a_k| for each node: U is the characteristic polynomial of diag(z) − 1 aᵀ."""
    n = wave.z.shape[1]
    return wave.tight * np.where(np.arange(n) < wave.up, wave.up, n - wave.up) * _ISOLATED


@dataclass(frozen=True)
class RowMatrix(FreeMatrix):
    """A(q̂, x̂, θ) of one vehicle of a row whose spacing is `step`, scaled."""

    step: Fraction = Fraction(0)

    @cached_property
    def receptance(self) -> RowReceptance:  # type: ignore[override]
        return RowReceptance(FreeRow(self.family, self.step))

    @property
    def variables(self) -> int:
        return 2 + len(self.family.paths)

    def own(self, y: Any, rho: Any) -> tuple[Quadratic, Quadratic, Quadratic]:
        """S, B and h, which do not depend on θ."""
        S, B, h = super().own(y[:-1], rho[:-1])
        return lifted(S, len(y)), lifted(B, len(y)), lifted(h, len(y))
