"""A chart of two parameters: how many vibrations grow at each point, and where the case itself stands."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np

from mpsolve.pictures.axes import BOTTOM, HIGH, LEFT, RIGHT, TOP, WIDE, Axes, box, disc, line, path, svg, text


def chart_picture(
    x: Any, y: Any, counts: Any, x_title: str, y_title: str, title: str,
    here: tuple[float, float] | None = None, boundaries: Sequence[tuple[Any, Any]] = (),
    proved: Sequence[tuple[float, float, bool]] = (), open_words: str = "hatched: open",
) -> str:  # fmt: skip
    """counts[i, j] belongs to the cell round (x[i], y[j]): 0 stable, more is darker, −1 is hatched as open.

    here: the point of the case; boundaries: curves (x, y) where a root crosses the real axis; proved: points (x, y,
    whether stable) that have been proved: circles are stable, squares not. open_words: what the legend says of −1.
    """
    edges_x, edges_y = _edges(x), _edges(y)
    axes = Axes((edges_x[0], edges_x[-1]), (edges_y[0], edges_y[-1]))
    parts = [
        '<pattern id="chart-open" width="6" height="6" patternUnits="userSpaceOnUse">'
        '<path class="tick" d="M0 6L6 0"/></pattern>'
    ]
    for j in range(len(y)):
        low, high = float(axes.py(edges_y[j])), float(axes.py(edges_y[j + 1]))
        for first, last, count in _runs(counts[:, j]):
            a, b = float(axes.px(edges_x[first])), float(axes.px(edges_x[last + 1]))
            parts += _cell(a, high, b - a, low - high, count)
    parts += [line(axes, bx, by, "boundary") for bx, by in boundaries]
    parts += [_proved(axes, *one) for one in proved]
    if here is not None:
        parts += _here(axes, *here)
    parts += _legend(counts, open_words)
    parts += axes.titled(x_title, y_title)
    return svg(parts, title)


def _cell(x: float, y: float, wide: float, high: float, count: int) -> list[str]:
    if count == 0:
        return []
    if count < 0:
        return [f'<rect x="{x:.1f}" y="{y:.1f}" width="{wide:.2f}" height="{high:.2f}" fill="url(#chart-open)"/>']
    return [box(x, y, wide, high, "grows")] + [box(x, y, wide, high, "many")] * (count > 2)


def _edges(values: Any) -> list[float]:
    v = np.asarray(values, float)
    middle = (v[1:] + v[:-1]) / 2
    return [float(v[0]), *middle.tolist(), float(v[-1])]


def _runs(row: Any) -> list[tuple[int, int, int]]:
    ends = np.flatnonzero(np.diff(row)).tolist()
    starts = [0, *[k + 1 for k in ends]]
    return [(a, b, int(row[a])) for a, b in zip(starts, [*ends, len(row) - 1], strict=True)]


def _here(axes: Axes, x: float, y: float) -> list[str]:
    """A cross with an open middle, so that it hides nothing."""
    a, b = float(axes.px(x)), float(axes.py(y))
    if not (LEFT <= a <= WIDE - RIGHT and TOP <= b <= HIGH - BOTTOM):
        return []
    cross = f"M {a - 13:.1f} {b:.1f} h 9 m 8 0 h 9 M {a:.1f} {b - 13:.1f} v 9 m 0 8 v 9"
    right = a < WIDE - 110
    return [path(cross, "ring"), text(a + (8 if right else -8), b - 8, "this case", "start" if right else "end")]


def _proved(axes: Axes, x: float, y: float, stable: bool) -> str:
    a, b = float(axes.px(x)), float(axes.py(y))
    if not (LEFT <= a <= WIDE - RIGHT and TOP <= b <= HIGH - BOTTOM):
        return ""
    return (
        disc(a, b, 4, "root", "proved: stable")
        if stable
        else box(a - 4, b - 4, 8, 8, "root unstable", "proved: unstable")
    )


def _legend(counts: Any, open_words: str) -> list[str]:
    found = sorted(set(np.ravel(counts).tolist()))
    said = {0: "blank: stable", -1: open_words}
    words = [said.get(k, f"shaded: {k} roots grow" if k <= 2 else f"darker: {k} and more") for k in found]
    kept = [
        w
        for k, w in enumerate(words)
        if not (w.startswith("darker") and any(x.startswith("darker") for x in words[:k]))
    ]
    return [text(LEFT + 6, TOP + 16 + 15 * k, word) for k, word in enumerate(kept)]
