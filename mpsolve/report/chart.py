"""The picture of a stability chart, by matplotlib."""

from __future__ import annotations

import textwrap
from itertools import pairwise
from pathlib import Path
from typing import TYPE_CHECKING, Any

from mpsolve.report.figures import COLOUR, Look, save_figure
from mpsolve.stability.chart import Column, StabilityChart

if TYPE_CHECKING:
    from matplotlib.axes import Axes

_OPEN, _HATCH = "#BBBBBB", "#666666"
_LINE = "#444444"
SYMBOLS = {
    "alpha": "$α$",
    "eta_m": "$η_M$",
    "d": "$d$",
    "eta_b": "$η_b$",
    "eta_n": "$η_N$",
    "eta_s": "$η_S$",
    "masses": "masses",
}
_AXES = {
    "eta_m": "mass ratio $η_M$ of each mass",
    "d": "distance $d$ of neighbouring masses, in units of $1/χ$",
    "factor": "all masses, as a multiple of those of this case",
}


def picture(chart: StabilityChart, path: Path) -> Path:
    """Writes .png, .svg or .pdf, the same bytes each time for one version of matplotlib.

    Raises InputError if matplotlib is missing, CertificateError if the file cannot be written.
    """
    return save_figure(lambda ax: draw(chart, ax), path, (8.4, 6.2))


def draw(chart: StabilityChart, ax: Axes, look: Look = COLOUR) -> Axes:
    """The chart on `ax`, with title and legend: see `paint`; returns `ax`."""
    paint(chart, ax, look)
    ax.set_title("\n".join(filter(None, (chart.title, _fixed(chart)))), loc="left", fontsize=11)
    place: Any = {"loc": "outside lower center", "ncols": 3, "frameon": False}
    said = textwrap.fill(chart.guide, 110)
    ax.figure.legend(handles=legend_handles(chart, look), fontsize=9, title=said, title_fontsize=8.5, **place)
    return ax


def paint(chart: StabilityChart, ax: Axes, look: Look = COLOUR) -> Axes:
    """Filled columns by the number of unstable roots, points where it changes; returns `ax`."""
    places = [float(value) for value in chart.x.values if not isinstance(value, str)]
    order = sorted(range(len(places)), key=places.__getitem__)
    places, columns = [places[k] for k in order], [chart.columns[k] for k in order]
    edges = _edges(places)
    for column, (left, right) in zip(columns, pairwise(edges), strict=True):
        _fill(column, left, right, ax, look)
    for (x, here), (y, there) in pairwise(zip(places, columns, strict=True)):
        for a, b in _joined(here, there):
            ax.plot((x, y), (a, b), color=_LINE, linewidth=0.9, linestyle=":")
    for x, column in zip(places, columns, strict=True):
        ax.axvline(x, color=_LINE, linewidth=0.5, alpha=0.3)
        for point in column.points:
            ax.plot(x, float(point.alpha), **_marker(point.direction, look))
    low, high = map(float, chart.alpha)
    ax.set(xlim=(edges[0], edges[-1]), ylim=(low, high), xlabel=_AXES[chart.x.parameter], ylabel="velocity ratio $α$")
    ax.set_xticks(places, minor=True)
    ax.tick_params(which="minor", length=3, color=_LINE)
    return ax


def _fill(column: Column, left: float, right: float, ax: Axes, look: Look) -> None:
    from matplotlib.patches import Rectangle

    for band in column.bands:
        style: Any = {"facecolor": _OPEN, "edgecolor": _HATCH, "hatch": "///"}
        if band.unstable is not None:
            style = {"facecolor": _filled(band.unstable, look), "edgecolor": "none"}
        ax.add_patch(Rectangle((left, band.start), right - left, band.end - band.start, linewidth=0, **style))


def _filled(unstable: int, look: Look) -> str:
    return look.counts[min(unstable // 2, len(look.counts) - 1)]


def _edges(places: list[float]) -> list[float]:
    """The middles between the places, and as far beyond the first and the last."""
    if len(places) == 1:
        return [places[0] - 0.5, places[0] + 0.5]
    middles = [(a + b) / 2 for a, b in pairwise(places)]
    return [2 * places[0] - middles[0], *middles, 2 * places[-1] - middles[-1]]


def _joined(here: Column, there: Column) -> list[tuple[float, float]]:
    """Crossings of neighbouring columns that are each other's nearest, of the same direction."""
    pairs = []
    for direction in (1, -1):
        ours, theirs = (
            [(float(p.alpha), float(p.q)) for p in column.points if p.direction == direction]
            for column in (here, there)
        )
        for a in ours:
            b = min(theirs, key=lambda other: _apart(a, other), default=None)
            if b is not None and a == min(ours, key=lambda other: _apart(b, other)):
                pairs.append((a[0], b[0]))
    return pairs


def _apart(a: tuple[float, float], b: tuple[float, float]) -> float:
    return abs(a[0] - b[0]) + abs(a[1] - b[1])


def _fixed(chart: StabilityChart) -> str:
    return ", ".join(f"{SYMBOLS[name]} = {value}" for name, value in chart.fixed.items())


def legend_handles(chart: StabilityChart, look: Look = COLOUR) -> list[Any]:
    """A handle for each look that the chart has, with its label."""
    from matplotlib.lines import Line2D
    from matplotlib.patches import Patch

    found = {band.unstable for column in chart.columns for band in column.bands}
    handles: list[Any] = []
    for number in sorted(n for n in found if n is not None):
        text = f"{number} unstable roots" if number else "stable"
        handles.append(Patch(facecolor=_filled(number, look), edgecolor=_LINE, linewidth=0.5, label=text))
    if None in found:
        handles.append(Patch(facecolor=_OPEN, edgecolor=_HATCH, hatch="///", label=_open(chart)))
    directions = {point.direction for column in chart.columns for point in column.points}
    if 1 in directions:
        handles.append(Line2D([], [], label="two roots become unstable", **_marker(1, look)))
    if -1 in directions:
        handles.append(Line2D([], [], label="two roots become stable", **_marker(-1, look)))
    return handles


def _marker(direction: int, look: Look) -> dict[str, Any]:
    into = direction > 0
    return {
        "marker": "^" if into else "v",
        "color": look.unstable if into else look.stable,
        "markersize": 5,
        "linestyle": "",
    }


def _open(chart: StabilityChart) -> str:
    widths = [band.end - band.start for column in chart.columns for band in column.bands if band.unstable is None]
    return f"undecided (the widest: {max(widths):.3g} in α)"
