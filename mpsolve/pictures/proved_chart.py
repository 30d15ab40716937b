"""A chart of proved regions: cells with their number of growing roots, strips of boundaries, and the case."""

from __future__ import annotations

from typing import Any

import numpy as np

from mpsolve.pictures.axes import STYLE
from mpsolve.pictures.chart import chart_picture
from mpsolve.problem.over import Over
from mpsolve.ranges.chart import Chart
from mpsolve.report.ranges_asked import Asked

ALONE = ' xmlns="http://www.w3.org/2000/svg" width="720" style="background:#fff;color:#000"'


def proved_chart(found: Chart, asked: Asked) -> str:
    """The SVG of a chart, as a file of its own; axes in the units that the user wrote."""
    first, second = asked.overs
    x, y = _middles(found.x, first), _middles(found.y, second)
    own = asked.problem.parameters
    here = tuple(float(one.shown(own[one.path])) for one in (first, second) if one.path in own)
    counts = np.where(found.counts < 0, -1, found.counts)
    picture = chart_picture(
        x, y, counts, axis_title(first), axis_title(second), "How many roots grow: proved regions, dotted where open",
        here=(here[0], here[1]) if len(here) == 2 else None,
        open_words="a boundary, or open",
    )  # fmt: skip
    head, rest = picture.split(">", 1)
    return f"{head}{ALONE}><style>{STYLE}</style>{rest}\n"


def _middles(edges: tuple[Any, ...], over: Over) -> Any:
    ends = np.array([float(over.shown(x)) for x in edges])
    return (ends[1:] + ends[:-1]) / 2


def axis_title(over: Over) -> str:
    names = {"v": "velocity" if over.unit else "velocity ratio α", "scale.mass": "factor on all masses"}
    name = names.get(over.path, over.path)
    return f"{name}, {over.unit}" if over.unit else name
