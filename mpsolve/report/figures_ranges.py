"""Figures over a range of one parameter, as the paper's Figures 7, 10 and 12 draw them.

`onsets` draws a table that is proved; `amplitude_range` and `lowest_parts` draw the curves they are given.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING

from mpsolve.errors import InputError
from mpsolve.numbers.spoken import decimal
from mpsolve.ranges.table import Table
from mpsolve.report.figures import COLOUR, Look

if TYPE_CHECKING:
    from matplotlib.axes import Axes

SYMBOLS = {
    "alpha": "$α$",
    "eta_m": "$η_M$",
    "d": "$d$",
    "eta_b": "$η_b$",
    "eta_n": "$η_N$",
    "eta_s": "$η_S$",
    "masses": "masses",
}


def onsets(table: Table, ax: Axes, look: Look = COLOUR) -> Axes:
    """The proved onsets over the rows' parameter, a line for each column, with gaps where there is none (Figure 12).

    In the unit of the table. Raises InputError for a table of unstable ranges.
    """
    if table.quantity != "onset":
        raise InputError("table", "holds ranges: give one of onsets")
    (path, values), (column, labels) = table.rows, table.columns
    for j, label in enumerate(labels):
        y = [float(row[j].text if row[j].status == "proved" else "nan") for row in table.entries]
        style = look.line(j) | {"marker": ".", "markersize": 4}
        name = f"{SYMBOLS.get(column, column)} = {decimal(label)}"
        ax.plot(list(map(float, values)), y, **style, label=name, gid=f"onset-{j + 1}")
    unit = f" [{table.over.unit}]" if table.over.unit else ""
    over = table.over.path
    ax.set(xlabel=SYMBOLS.get(path, path), ylabel=f"{SYMBOLS.get(over, over)} at the onset{unit}")
    return _named(ax)


def lowest_parts(
    x: Sequence[float], curves: Mapping[str, Sequence[float]], ax: Axes, parameter: str = "eta_m", look: Look = COLOUR
) -> Axes:
    """The lowest Im q of each curve over x, with the unstable half shaded (Figure 10); returns `ax`."""
    for k, (name, values) in enumerate(curves.items()):
        ax.plot(x, values, **look.line(k), label=name, gid=f"lowest-{k + 1}")
    low, high = ax.get_ylim()
    if low < 0:
        ax.axhspan(low, 0, color=look.shade, linewidth=0, zorder=0)
        ax.set_ylim(low, high)
    ax.set(xlabel=SYMBOLS[parameter], ylabel="lowest Im q")
    return _limit(ax, 0.0, look)


def amplitude_range(
    alpha: Sequence[float],
    curves: Mapping[str, tuple[Sequence[float], Sequence[float]]],
    ax: Axes,
    look: Look = COLOUR,
) -> Axes:
    """The greatest and the least amplitude of each curve over the velocity ratio, in one look (Figure 7); `ax`."""
    for k, (name, (greatest, least)) in enumerate(curves.items()):
        ax.plot(alpha, greatest, **look.line(k), label=name, gid=f"greatest-{k + 1}")
        ax.plot(alpha, least, **look.line(k), gid=f"least-{k + 1}")
    ax.set(xlabel="velocity ratio $α$", ylabel="greatest and least amplitude", ylim=(0, None))
    return _named(ax)


def _limit(ax: Axes, height: float, look: Look) -> Axes:
    ax.axhline(height, color=look.ink, linestyle=":", linewidth=0.9)
    return _named(ax)


def _named(ax: Axes) -> Axes:
    ax.legend(loc="best", frameon=True, facecolor="white", edgecolor="none", framealpha=1)
    return ax
