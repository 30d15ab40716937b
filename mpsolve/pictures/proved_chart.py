"""A chart of proved regions: cells with their number of growing roots, the curves between them, and the case."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np

from mpsolve.pictures.axes import STYLE
from mpsolve.pictures.chart import Border, chart_picture
from mpsolve.problem.over import Over
from mpsolve.ranges.cells import met
from mpsolve.ranges.chart import Chart
from mpsolve.report.ranges_asked import Asked

ALONE = ' xmlns="http://www.w3.org/2000/svg" width="720" style="background:#fff;color:#000"'
_ROUNDS = 6  # cells: as wide as the strip beside a curve is, at most


def proved_chart(found: Chart, asked: Asked) -> str:
    """The SVG of a chart, as a file of its own; axes in the units that the user wrote."""
    first, second = asked.overs
    factors = tuple(float(one.shown(1.0)) for one in (first, second))
    counts = drawn(found)
    own = asked.problem.parameters
    here = tuple(float(one.shown(own[one.path])) for one in (first, second) if one.path in own)
    picture = chart_picture(
        ends(found.x, counts.shape[0]) * factors[0], ends(found.y, counts.shape[1]) * factors[1], counts,
        axis_title(first), axis_title(second), "How many roots grow: proved regions, dotted where open",
        here=(here[0], here[1]) if len(here) == 2 else None, boundaries=borders(found, factors),
        open_words=open_words(found),
    )  # fmt: skip
    head, rest = picture.split(">", 1)
    return f"{head}{ALONE}><style>{STYLE}</style>{rest}\n"


def drawn(found: Chart) -> Any:
    """The finest counts there are, −1 where they are open; cells at a proved curve are drawn as those beside it."""
    counts = np.maximum(found.counts if found.detail is None else found.detail, -1)
    under = met(counts.shape, (found.x, found.y), found.boundaries)
    for _ in range(_ROUNDS):
        for shift, axis in ((1, 0), (-1, 0), (1, 1), (-1, 1)):
            beside = np.roll(counts, shift, axis)
            edge: list[Any] = [slice(None), slice(None)]
            edge[axis] = 0 if shift > 0 else -1
            beside[tuple(edge)] = -1
            counts = np.where((counts < 0) & under, beside, counts)
    return counts


def ends(edges: Sequence[Any], cells: int) -> Any:
    """The edges of so many cells."""
    return np.linspace(float(edges[0]), float(edges[-1]), cells + 1)


def borders(found: Chart, factors: Sequence[float]) -> list[Border]:
    """The proved curves, in units of which one is a factor of the problem's."""
    return [
        Border(np.asarray(one.x) * factors[0], np.asarray(one.y) * factors[1], one.divergence)
        for one in found.boundaries
    ]


def open_words(found: Chart) -> str:
    """What dotted cells are."""
    return "open" if found.traced else "not decided, a boundary may run there"


def axis_title(over: Over) -> str:
    names = {"v": "velocity" if over.unit else "velocity ratio α", "scale.mass": "factor on all masses"}
    name = names.get(over.path, over.path)
    return f"{name}, {over.unit}" if over.unit else name
