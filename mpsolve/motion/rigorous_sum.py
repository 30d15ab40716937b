"""W̃ in balls at the nodes of proved panels, and the sum over them at any time."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from typing import Any

import flint
import numpy as np

from mpsolve.errors import PrecisionError
from mpsolve.model.branch import Track
from mpsolve.model.scaled import SplitRoots
from mpsolve.motion.rigorous_cells import NAMES, Beam, Cells
from mpsolve.motion.rigorous_path import Guide, Route
from mpsolve.motion.rigorous_quadrature import Forces, Gaps, Panels, column_of, middle_cell

acb, arb = flint.acb, flint.arb


@dataclass(frozen=True)
class Nodes:
    """q at the nodes of one panel, and W̃ dq there times the weights, shape (positions, nodes)."""

    q: list[Any]
    values: list[list[Any]]


class Samples:
    """W̃ at the nodes of all panels: the integral over them at any time."""

    def __init__(self, track: Track, guide: Guide, way: Route, found: Panels, forces: Forces, gaps: Gaps) -> None:
        self.found, self.i = found, track.field.i
        self.points = list(_nodes(track, guide, way, found, forces, gaps))
        # for each panel the sum of |W̃ dq| over it and all later ones
        left = [[arb(0)] * len(gaps)]
        for point in reversed(self.points):
            sizes = [arb(sum((abs(v) for v in row), arb(0)).upper()) for row in point.values]
            left.append([a + b for a, b in zip(left[-1], sizes, strict=True)])
        self.left = left[:0:-1]

    @property
    def count(self) -> int:
        return sum(len(point.q) for point in self.points)

    def integral(self, tau: Any, negligible: Any) -> list[Any]:
        """Re Σ W̃ e^{iqτ} dq, one ball for each position.

        Flat panels at the end are only bounded where their sum is negligible: `beneath` grows from one to the next.
        """
        total, end = [arb(0)] * len(self.left[0]), len(self.points)
        for k in range(end - 1, -1, -1):
            decay = (-tau * arb(self.found.beneath[k])).exp()
            if not (self.found.flat[k] and all(size * decay < negligible for size in self.left[k])):
                break
            total, end = [arb(0, (size * decay).upper()) for size in self.left[k]], k
        for point in self.points[:end]:
            waves = [(self.i * q * tau).exp() for q in point.q]
            for row, values in enumerate(point.values):
                total[row] += sum((v * wave for v, wave in zip(values, waves, strict=True)), acb(0)).real
        return total


def _nodes(track: Track, guide: Guide, way: Route, found: Panels, forces: Forces, gaps: Gaps) -> Iterator[Nodes]:
    """Panel by panel, in order; `track`, forces and gaps in balls."""
    rules: dict[int, list[Any]] = {}
    for k, (start, end, order) in enumerate(zip(found.starts, found.ends, found.orders.tolist(), strict=True)):
        low, high = acb(start.real, start.imag), acb(end.real, end.imag)
        centre, half = (low + high) / 2, (high - low) / 2
        rule = rules.setdefault(order, [])
        if not rule:
            rule += [arb.legendre_p_root(order, j, weight=True) for j in range(order)]
        t = np.array([float(x) for x, _ in rule])
        seeds = guide.seeds((start + end) / 2 + (end - start) / 2 * t).T.tolist()
        places, rows = [], []
        for (x, weight), column, seed in zip(rule, column_of(t).tolist(), seeds, strict=True):
            v = centre + half * x
            q = way.frequency(track, v)
            roots = SplitRoots(*_roots(track, q, found.over, middle_cell(k, column), seed))
            values = Beam(track, roots).image(q, forces(q), gaps)
            scale = weight * v * half
            places.append(q)
            rows.append([value * scale for value in values])
        yield Nodes(places, [list(row) for row in zip(*rows, strict=True)])


def _roots(track: Track, q: Any, over: Cells, cell: int, seed: Sequence[complex]) -> list[Any]:
    """The p-roots of the cell at one q in it: m − D(m)/D_p, D_p over the whole disc of the p-root.

    The mean of D_p from m to the root lies in the disc of D_p, if m lies in the disc of the root.
    """
    r = q - track.field.i * track.eta_b
    D = flint.acb_poly([4 * (track.beta2 - r * r), 8 * track.alpha * r, -4 * track.A, 0, 1])
    slope, found = D.derivative(), []
    for name in NAMES:
        m, bits = acb(seed[name].real, seed[name].imag), 50
        while bits < track.field.bits:
            m, bits = (m - D(m) / slope(m)).mid(), 2 * bits
        disc = over.roots[name]
        if not abs(m - acb(complex(disc.m[cell]))) < arb(float(disc.r[cell])):
            raise PrecisionError("Newton's method for a p-root left its disc: change a parameter slightly")
        found.append(m - D(m) / over.slope_ball(name, cell))
    return found


def physical_start(track: Track, way: Route, found: Panels) -> bool:
    """Whether a, b are proved to be the upper p-roots of the physical sheet in the middle of the first panel."""
    start, end = found.starts[0], found.ends[0]
    q = way.frequency(track, (acb(start.real, start.imag) + acb(end.real, end.imag)) / 2)
    cell = middle_cell(0, int(column_of(np.array(0.0))))
    seed = [complex(found.over.roots[name].m[cell]) for name in NAMES]
    roots = _roots(track, q, found.over, cell, seed)
    return all(p.imag > 0 for p in roots[:2]) and all(p.imag < 0 for p in roots[2:])
