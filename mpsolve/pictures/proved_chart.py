"""A chart of proved regions: cells with their number of growing roots, the curves between them, and the case."""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction
from typing import Any

import numpy as np

from mpsolve.numbers.arrays import Reals, Truths
from mpsolve.pictures.axes import alone
from mpsolve.pictures.chart import Border, chart_picture
from mpsolve.problem.over import Over
from mpsolve.ranges.cells import grown, met, next_to
from mpsolve.ranges.chart import Chart
from mpsolve.report.ranges_asked import Asked

_ROUNDS = 6  # cells: as wide as the strip beside a curve is, at most
_LARGE = 0.01  # of the chart: areas in which their number is written
_CELLS = 512  # along each parameter: about one for a pixel


def proved_chart(found: Chart, asked: Asked) -> str:
    """The SVG of a chart, as a file of its own; axes in the units that the user wrote."""
    first, second = asked.overs
    factors = tuple(float(one.shown(1.0)) for one in (first, second))
    counts = drawn(found)
    own = asked.problem.parameters
    here = tuple(float(one.shown(own[one.path])) for one in (first, second) if one.path in own)
    return alone(chart_picture(
        ends(found.x, counts.shape[0]) * factors[0], ends(found.y, counts.shape[1]) * factors[1], counts,
        axis_title(first), axis_title(second), "How many roots grow: proved regions, dotted where open",
        here=(here[0], here[1]) if len(here) == 2 else None, **proved_parts(found, factors),
    ))  # fmt: skip


def proved_parts(found: Chart, factors: Sequence[float]) -> dict[str, Any]:
    """What `chart_picture` draws over the areas, in units of which one is a factor of the problem's."""
    return {
        "boundaries": borders(found, factors),
        "open_words": open_words(found),
        "meetings": places(found, factors),
        "numbers": numbers(found, factors),
    }


def drawn(found: Chart) -> Any:
    """The finest counts there are, −1 where they are open; strips next to proved curves as their side of these.

    Cells are so small that a curve, drawn as a line, hides those that it meets.
    """
    counts = np.maximum(found.counts if found.detail is None else found.detail, -1)
    beside = next_to(counts.shape, (found.x, found.y), found.boundaries)
    each = max(1, _CELLS // counts.shape[0])
    counts, beside = (np.repeat(np.repeat(part, each, 0), each, 1) for part in (counts, beside))
    line = met(counts.shape, (found.x, found.y), found.boundaries)
    beside &= counts < 0
    filled = _filled(counts, beside & ~line, _ROUNDS * each)
    unlike = np.where(line, -1, filled)  # where two sides meet that no curve parts, nothing is told
    wrong = np.zeros(counts.shape, bool)
    for axis in (0, 1):
        a, b = np.moveaxis(unlike, axis, 0)[:-1], np.moveaxis(unlike, axis, 0)[1:]
        np.moveaxis(wrong, axis, 0)[1:] |= (a != b) & (a >= 0) & (b >= 0)
    for _ in range(2 * each if wrong.any() else 0):
        wrong = grown(wrong, 0, 1)
    return _filled(np.where(wrong, counts, filled), beside & line & ~wrong, 2)


def _filled(counts: Any, cells: Truths, rounds: int) -> Any:
    """Open ones of these cells as neighbours are, one round after another."""
    high, wide = counts.shape
    for _ in range(rounds):
        padded = np.pad(counts, 1, constant_values=-1)
        most = np.max([padded[i : i + high, j : j + wide] for i, j in ((2, 1), (0, 1), (1, 2), (1, 0))], 0)
        new = cells & (counts < 0) & (most >= 0)
        if not new.any():
            break
        counts = np.where(new, most, counts)
    return counts


def ends(edges: Sequence[Fraction], cells: int) -> Reals:
    """The edges of so many cells."""
    return np.linspace(float(edges[0]), float(edges[-1]), cells + 1)


def borders(found: Chart, factors: Sequence[float]) -> list[Border]:
    """The proved curves, in units of which one is a factor of the problem's."""
    return [
        Border(np.asarray(one.x) * factors[0], np.asarray(one.y) * factors[1], one.divergence)
        for one in found.boundaries
    ]


def places(found: Chart, factors: Sequence[float]) -> list[tuple[float, float, str]]:
    """The points at which curves meet, in the same units, each with its words."""
    return [(float(one.x.mid()) * factors[0], float(one.y.mid()) * factors[1], one.kind) for one in found.meetings]


def numbers(found: Chart, factors: Sequence[float]) -> list[tuple[float, float, int]]:
    """The points at which the larger areas are counted, and their numbers."""
    total = sum(part.cells for part in found.parts)
    out = []
    for part in found.parts:
        if part.roots is not None and part.cells >= _LARGE * total:
            x, y = (float(part.point[path]) * factor for path, factor in zip(found.over, factors, strict=True))
            out.append((x, y, part.roots))
    return out


def open_words(found: Chart) -> str:
    """What dotted cells are."""
    return "open" if found.traced else "not decided, a boundary may run there"


def axis_title(over: Over) -> str:
    names = {"v": "velocity" if over.unit else "velocity ratio α", "scale.mass": "factor on all masses"}
    name = names.get(over.path, over.path)
    return f"{name}, {over.unit}" if over.unit else name
