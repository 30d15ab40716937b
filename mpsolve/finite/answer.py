"""A motion on a finite track at the times that are asked for, read between the steps of its march."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np

from mpsolve.numbers.arrays import Reals


@dataclass(frozen=True)
class Answer:
    """At the times watched: rail (p, t), vehicle (size, t), force (n, t); forces (n, nodes) at nodes of the steps."""

    rail: Reals
    vehicle: Reals
    force: Reals
    nodes: Reals
    forces: Reals

    def change(self, other: Answer) -> tuple[float, float, float]:
        pairs = ((self.rail, other.rail), (self.vehicle, other.vehicle), (self.force, other.force))
        a, b, c = (float(np.max(np.abs(one - two), initial=0.0)) for one, two in pairs)
        return a, b, c

    def unresolved(self, coarse: Answer) -> float:
        """The largest change of a force from longer steps, wherever it is.

        A sudden load may leave a vibration between stiff contacts that is faster than the steps. Those follow neither
        it nor its decay, so that of later times their halving shows too little; of the beginning it shows it all.
        """
        rows = zip(self.forces, coarse.forces, strict=True)
        gaps = [np.abs(np.interp(coarse.nodes, self.nodes, own) - other) for own, other in rows]
        return float(np.max(gaps, initial=self.change(coarse)[2]))

    def near(self, other: Answer, tolerance: float) -> bool:
        rail, vehicle, _ = self.change(other)
        return rail <= tolerance * _largest(self.rail) and vehicle <= tolerance * _largest(self.vehicle)

    def first_fall(self) -> tuple[float, int] | None:
        """When a force that pressed first comes to 0 or below, between the nodes, and of which contact, from 1."""
        noise = 1e-6 * np.abs(self.forces).max(initial=0.0)
        falls = []
        for j, row in enumerate(self.forces, 1):
            pressed = np.logical_or.accumulate(row > noise)
            for k in np.flatnonzero(pressed[:-1] & (row[1:] <= 0))[:1]:
                share = row[k] / (row[k] - row[k + 1])
                falls.append((float(self.nodes[k] + share * (self.nodes[k + 1] - self.nodes[k])), j))
        return min(falls, default=None)


def _largest(rows: Reals) -> float:
    return float(np.max(np.abs(rows), initial=0.0))


def hermite(nodes: Reals, values: Any, slopes: Reals, times: Reals) -> Any:
    """The piecewise cubic with these values and slopes (rows, nodes) at the nodes; (rows, times)."""
    i = np.clip(np.searchsorted(nodes, times, side="right") - 1, 0, len(nodes) - 2)
    h = nodes[i + 1] - nodes[i]
    s = (times - nodes[i]) / h
    left, right = values[:, i], values[:, i + 1]
    rise, start, end = right - left, h * slopes[:, i], h * slopes[:, i + 1]
    return left + s * (start + s * (3 * rise - 2 * start - end + s * (start + end - 2 * rise)))


def slopes(values: Any, h: float) -> Any:
    """The slopes of equidistant values (rows, nodes), of the fourth order within.

    The rail's own rates would not do: they hold waves that turn many times in a step.
    """
    out = np.gradient(values, h, axis=1, edge_order=2)
    out[:, 2:-2] = (8 * (values[:, 3:-1] - values[:, 1:-3]) - (values[:, 4:] - values[:, :-4])) / (12 * h)
    return out
