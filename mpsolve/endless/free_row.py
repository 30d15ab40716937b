"""The endless row over boxes of (q, parameters, θ), z = e^{iθ}: its receptance and its matrix as Taylor models.

The sum over the row is one over p-roots (`lattice`). Where all roots are alone each is a model, and so is its term,
as long as its wave does not fit the row, e^{Pd} ≠ z. Where some of one side may meet, Σ N/D times the row's factor is
summed on circles, as in `characteristic.circles`: the factor's poles have Re P = 0, and the circles stay off them.
The last variable is θ; the others are those of the family.
"""

from __future__ import annotations

from dataclasses import dataclass
from fractions import Fraction
from functools import cached_property
from typing import Any

import numpy as np

from mpsolve.characteristic.bordering import distances_of
from mpsolve.characteristic.boxes import Boxes, FreeTrack, Wave
from mpsolve.characteristic.circles import NOISE, aliasing, circles_of, samples, summed
from mpsolve.characteristic.free_matrix import FreeMatrix
from mpsolve.characteristic.free_receptance import Receptances, grown, may_meet
from mpsolve.characteristic.free_roots import Roots, roots_over
from mpsolve.endless.lattice import first_force
from mpsolve.numbers.arrays import Complexes, Integers, Reals, Truths
from mpsolve.numbers.jets import TINY, UP, U, exponential, nearest
from mpsolve.numbers.quadratic import Quadratic, constant, joined, lifted
from mpsolve.problem.family import Family

WIDE = 0.75  # half an arc: more of it is bounded only
_LOOSE = 2.0**-8  # of the sum: where roots that nearly meet leave out more, circles may leave out less
Around = tuple[Quadratic, Quadratic]
"""(z, 1/z) as models of shape (boxes,)."""


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
    def distances(self) -> tuple[tuple[Fraction, ...], Integers]:
        """(the different distances, for each pair of places the number of its own)."""
        exact, which = distances_of(self.places)
        return exact, np.array(which)


@dataclass(frozen=True)
class RowReceptance:
    """Ĝ between the places of one vehicle over boxes (q̂, x̂, θ)."""

    row: FreeRow

    @cached_property
    def track(self) -> FreeTrack:
        return FreeTrack(self.row.family)

    def __call__(self, boxes: Boxes) -> Receptances:
        with np.errstate(all="ignore"):
            own, m, (exact, which) = Boxes(boxes.m[:-1], boxes.r[:-1]), len(boxes.m), self.row.distances
            y, rho = own.variables
            D, N = self.track.D(y, rho), self.track.N(y, rho)
            z, low = self.track.nodes(D)
            roots = roots_over(D, N, z, low, self.track.up)
            strain = np.concatenate([roots.strain, np.zeros((1, boxes.count))])
            k = np.zeros((len(constant(0.0, 1, m).k), boxes.count, len(exact)), complex)
            e = np.full((boxes.count, len(exact)), np.inf)
            alone = np.flatnonzero(roots.good.all(1) & (low > 0))
            if len(alone):
                P, w = roots.P[alone], roots.weight[alone]
                found = self._alone(P, w, _turns(boxes.take(alone)))
                k[:, alone], e[alone] = found.k, found.e
            gap = self.row.step - self.row.distances[0][-1]
            strain += _moved(roots, self.track.up, boxes, nearest(self.row.step), nearest(gap))
            loose = ~(e <= _LOOSE * np.abs(k[0])).all(1)
            rest = np.flatnonzero(loose & may_meet(z, self.track.up))
            whole = self.track.split(own.take(rest))
            rows = rest[whole.good]
            strain[:-1, rows] = whole.strain[:, whole.good]  # roots that are taken together may meet
            if len(rows):
                found = self._circled(whole.take(whole.good), N[rows], _turns(boxes.take(rows)))
                better = found.e.max(1) < e[rows].max(1)
                k[:, rows[better]], e[rows[better]] = found.k[:, better], found.e[better]
            good = np.isfinite(e).all(1) & np.isfinite(k).all((0, 2))
            return Receptances(Quadratic(k, e, m)[:, which], good, strain)

    def _sides(self) -> list[tuple[bool, Truths, list[tuple[Fraction, int]]]]:
        """(whether they decay ahead, which roots, for each distance the first force of the series) of each side."""
        own = np.arange(self.row.family.degree) < self.track.up
        sides = [(True, own), (False, ~own)]
        exact = self.row.distances[0]
        return [
            (ahead, mask, [first_force(a, self.row.step, ahead) for a in exact])
            for ahead, mask in sides
            if mask.any()
        ]

    def _alone(self, P: Quadratic, w: Quadratic, around: Around) -> Quadratic:
        """Ĝ at each distance, shape (boxes, distances), from simple roots."""
        (point, back), m = around, around[0].m
        P, w = lifted(P, m), lifted(w, m)
        columns: list[list[Quadratic]] = [[] for _ in self.row.distances[0]]
        one = constant(1.0, len(P.e), m)[:, None]
        for ahead, mask, first in self._sides():
            sign, own = (1.0 if ahead else -1.0), P[:, mask]
            ratio = grown(own.times(nearest(self.row.step) * sign), one) * (back if ahead else point)[:, None]
            heavy = w[:, mask].times(sign) * one_less(ratio).inverse()
            for column, (xi, factor) in zip(columns, first, strict=True):
                term = grown(own.times(nearest(xi)), heavy) if xi else heavy
                column.append(_turned(term.sum(-1), factor, around))
        return joined([_total(column)[:, None] for column in columns], -1)

    def _circled(self, wave: Wave, N: Quadratic, around: Around) -> Quadratic:
        """The same from circles."""
        boxes, columns = len(wave.z), [[] for _ in self.row.distances[0]]  # type: tuple[int, list[list[Quadratic]]]
        for ahead, mask, first in self._sides():
            xi = np.array([nearest(a) for a, _ in first])
            circles = circles_of(wave, mask, np.full(boxes, np.abs(xi).max()), off_axis=True)
            f, points = samples(wave, N, circles)
            step = nearest(self.row.step) * (1.0 if ahead else -1.0)
            f = lifted(f, around[0].m) * self._factor(points * step, around[1 if ahead else 0])
            sums = summed(f if ahead else -f, points, np.broadcast_to(xi, (boxes, len(xi))))
            depth = np.where(circles.active, np.abs(circles.centre.real) - circles.outer, np.inf).min(1)
            most = np.where(depth > 0, 1 / -np.expm1(-depth * abs(step) * (1 - 16 * U)) * (1 + 64 * U), np.inf)
            missed = aliasing(wave, N, circles, constant(xi, boxes, wave.D.m)) * most[:, None]
            sums = Quadratic(sums.k, (sums.e + missed) * UP, sums.m)
            for j, (_, factor) in enumerate(first):
                columns[j].append(_turned(sums[:, j], factor, around))
        return joined([_total(column)[:, None] for column in columns], -1)

    @staticmethod
    def _factor(exponent: Complexes, turn: Quadratic) -> Quadratic:
        """1/(1 − e^{exponent}·turn) at points that are rounded."""
        value, lost = exponential(exponent)
        k = np.zeros((len(turn.k), *value.shape), complex)
        k[0] = value
        ratio = Quadratic(k, np.abs(value) * (lost + NOISE * (1 + np.abs(exponent))), turn.m)
        return one_less(ratio * turn[:, None]).inverse()


def _total(parts: list[Quadratic]) -> Quadratic:
    return sum(parts[1:], parts[0])


def _turns(boxes: Boxes) -> Around:
    """As θ is real, |e^{iy} − 1 − iy + y²/2| ≤ |y|³/6; of a wide arc no more is said than |z| = 1."""
    m, r = len(boxes.m), boxes.r[-1]
    middle, lost = exponential(1j * boxes.m[-1])
    k = np.zeros((len(constant(0.0, 1, m).k), boxes.count), complex)
    k[0], k[m], k[-1] = middle, 1j * r * middle, -r * r / 2 * middle
    e = (r**3 / 6 + (lost + 64 * U) * (1 + r) * (1 + r)) * UP + TINY
    wide = r > WIDE
    k, e = np.where(wide, 0, k), np.where(wide, 1 + 64 * U, e)
    return Quadratic(k, e, m), Quadratic(k.conj(), e, m)


def _turned(term: Quadratic, factor: int, around: Around) -> Quadratic:
    return term if not factor else term * around[0 if factor > 0 else 1]


def one_less(ratio: Quadratic) -> Quadratic:
    """1 − f."""
    k = -ratio.k
    k[0] = k[0] + 1
    return Quadratic(k, (ratio.e + 4 * U * np.abs(k).sum(0)) * UP + TINY, ratio.m)


def _moved(roots: Roots, up: int, boxes: Boxes, step: float, gap: float) -> Reals:
    """In floats: how far each variable moves the sum, at most, for any root: 1/(1 − e^{Pd}/z) relative to itself, and
    θ what comes from the next vehicle, over the gap to it."""
    sign = np.where(np.arange(roots.P.a.shape[1]) < up, 1, -1)
    P = roots.P.a * sign
    ratio = np.exp(P * step - 1j * sign * boxes.m[-1][:, None])
    over = 1 / np.abs(1 - ratio)
    moved = (np.abs(roots.P.b) * step * np.abs(ratio) * over).max(2)
    turned = boxes.r[-1] * (np.exp(P.real * gap) * over).max(1)
    moved = np.concatenate([moved, turned[None]])
    return np.where(np.isfinite(moved), moved, 0.0)


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

    def polynomials(self, y: Any, rho: Any) -> Quadratic:
        """They do not depend on θ."""
        return lifted(super().polynomials(y[:-1], rho[:-1]), len(y))
