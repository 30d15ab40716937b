"""A chart of two parameters round the present problem: counted in floats, with what has been proved marked on it."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from fractions import Fraction

import numpy as np

from mpsolve.batch.frequencies import frequencies
from mpsolve.batch.result import Frequencies
from mpsolve.errors import InputError
from mpsolve.numbers.arrays import Reals
from mpsolve.pictures.chart import Sure, chart_picture
from mpsolve.problem.problem import Problem

COLUMNS, ROWS = 41, 25


@dataclass(frozen=True)
class ProvedPoint:
    """A problem about which stability has been proved, and the ranges of two parameters round it, if it is stable."""

    problem: Problem
    stable: bool
    region: Mapping[str, tuple[Fraction, Fraction]] | None = None


@dataclass(frozen=True)
class Chart:
    """Counts over two parameters of a problem; all others as they are in it."""

    problem: Problem
    x: str
    y: str
    found: Frequencies

    def picture(self, now: Problem, proved: tuple[ProvedPoint, ...] = ()) -> str:
        """The chart with the present problem, and proved ones that differ from it in these two parameters only."""
        xs, ys = np.asarray(self.found.over[self.x])[:, 0], np.asarray(self.found.over[self.y])[0]
        across, up = self._title(self.x), self._title(self.y)
        here = self._point(now)
        points = [(self._point(one.problem), one.stable) for one in proved]
        marks = [(*point, stable) for point, stable in points if point is not None]
        sure = [one for point in proved for one in self._sure(point)]
        said = f"How many roots grow, over {across} and {up}"
        return chart_picture(xs, ys, self.found.count, across, up, said, here=here, proved=marks, sure=sure)

    def _sure(self, point: ProvedPoint) -> list[Sure]:
        """The region of a point that stands on this chart, if it is one of the same two parameters."""
        region = point.region
        if region is None or set(region) != {self.x, self.y} or self._point(point.problem) is None:
            return []
        (a, b), (c, d) = ([float(x) for x in region[path]] for path in (self.x, self.y))
        return [Sure((a, b), (c, d))]

    def _title(self, path: str) -> str:
        quantity = self.problem.quantity(path)
        return f"{quantity.meaning}, {quantity.unit}" if quantity.unit else quantity.meaning

    def _point(self, problem: Problem) -> tuple[float, float] | None:
        """Where a problem stands, None if it differs in something else."""
        values = problem.parameters
        if self.x not in values or self.y not in values:
            return None
        moved = self.problem.changed(self.x, values[self.x]).changed(self.y, values[self.y])
        return (float(values[self.x]), float(values[self.y])) if moved == problem else None


def chart_of(problem: Problem, x: str, y: str) -> Chart:
    """A chart from nothing to twice the present values; InputError where a parameter is 0 or both are one."""
    if x == y:
        raise InputError("chart", "has the same parameter on both axes: choose two")
    axes = [_values(problem, path, number) for path, number in ((x, COLUMNS), (y, ROWS))]
    over = {x: axes[0][:, None], y: axes[1][None, :]}
    return Chart(problem, x, y, frequencies(problem, over, roots=False))


def _values(problem: Problem, path: str, number: int) -> Reals:
    """Up to twice the present value; the range holds 0 only as its open end, where a spring or mass would be gone."""
    value = problem.parameters.get(path, Fraction(0))
    if value <= 0:
        raise InputError(path, "is 0 now, so no range about it is known: give it a value first")
    return 2 * float(value) * (np.arange(number) + 0.503) / number
