"""A chart of two parameters: how many vibrations grow at each point, and where the case itself stands.

Areas differ by their hatching, not by colour alone, and are parted by lines, so that grey is enough.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from mpsolve.numbers.arrays import Integers
from mpsolve.pictures.axes import BOTTOM, HIGH, LEFT, RIGHT, TOP, WIDE, Axes, box, disc, line, path, svg, text

SOME, MANY, OPEN = "some", "many", "open"
_PATTERNS = (
    '<pattern id="chart-some" width="7" height="7" patternUnits="userSpaceOnUse">'
    '<path class="hatch" d="M-1 8L8 -1"/></pattern>'
    '<pattern id="chart-many" width="5" height="5" patternUnits="userSpaceOnUse">'
    '<path class="hatch" d="M-1 6L6 -1M-1 -1L6 6"/></pattern>'
    '<pattern id="chart-open" width="6" height="6" patternUnits="userSpaceOnUse">'
    '<circle class="solid" cx="3" cy="3" r="1.1"/></pattern>'
)
_ROW = 17


@dataclass(frozen=True)
class Border:
    """A curve on which a root is real; at_zero: q = 0 all along."""

    x: Any
    y: Any
    at_zero: bool = False


@dataclass(frozen=True)
class Sure:
    """A box of the two parameters, or a line, all over which stability is proved."""

    x: tuple[float, float]
    y: tuple[float, float]


def chart_picture(
    x: Any, y: Any, counts: Integers, x_title: str, y_title: str, title: str,
    here: tuple[float, float] | None = None, boundaries: Sequence[Border] = (),
    proved: Sequence[tuple[float, float, bool]] = (), sure: Sequence[Sure] = (), open_words: str = "open",
    meetings: Sequence[tuple[float, float, str]] = (), numbers: Sequence[tuple[float, float, int]] = (),
) -> str:  # fmt: skip
    """counts[i, j] belongs to the cell round (x[i], y[j]): 0 blank, 1 and 2 hatched, more crossed, −1 dotted as open.

    x, y may also be the edges of cells, one more than these. here: the point of the case; boundaries: curves on
    which a root is real, drawn in place of lines between cells; proved: points (x, y, whether stable) that have been
    proved: circles are stable, squares not; sure: outlined boxes and lines on which stability is proved. open_words:
    what the legend says of −1; meetings: points (x, y, words) at which boundaries meet; numbers: points (x, y, count)
    of areas whose count is written there. The legend stands below the axes.
    """
    counts = np.asarray(counts)
    edges = _edges(x, counts.shape[0]), _edges(y, counts.shape[1])
    axes = Axes((edges[0][0], edges[0][-1]), (edges[1][0], edges[1][-1]))
    kinds = np.select([counts < 0, counts == 0, counts <= 2], [-1, 0, 1], 2)
    parts = [_PATTERNS, *_areas(axes, edges, kinds)]
    parts += [line(axes, one.x, one.y, "boundary zero" if one.at_zero else "boundary") for one in boundaries]
    parts += [] if boundaries else _borders(axes, edges, kinds)
    parts += [disc(float(axes.px(a)), float(axes.py(b)), 4, "point", words) for a, b, words in meetings]
    parts += [text(float(axes.px(a)), float(axes.py(b)) + 5, str(n), "middle", "halo") for a, b, n in numbers]
    parts += [_sure(axes, one) for one in sure]
    parts += [_proved(axes, *one) for one in proved]
    if here is not None:
        parts += _here(axes, *here)
    parts += axes.titled(x_title, y_title)
    legend = _legend(counts, open_words, bool(sure), [one.at_zero for one in boundaries], bool(meetings))
    return svg([*parts, *legend], title, HIGH + 4 + _ROW * -(-len(legend) // 4))


def _areas(axes: Axes, edges: tuple[list[float], list[float]], kinds: Integers) -> list[str]:
    """One path for each kind; its rows of cells overlap a little, so that no gap shows between them."""
    d: dict[int, list[str]] = {}
    for j in range(kinds.shape[1]):
        low, high = float(axes.py(edges[1][j])), float(axes.py(edges[1][j + 1]))
        for first, last, kind in _runs(kinds[:, j]):
            a, b = float(axes.px(edges[0][first])), float(axes.px(edges[0][last + 1]))
            d.setdefault(kind, []).append(f"M{a:.1f} {high:.2f}h{b - a:.2f}v{low - high + 0.1:.2f}h{a - b:.2f}z")
    parts = []
    for kind, name in ((-1, OPEN), (1, SOME), (2, MANY)):
        if kind in d:
            parts += [path("".join(d[kind]), "grows")] * (kind > 0)
            parts.append(f'<path class="area {name}" d="{"".join(d[kind])}" fill="url(#chart-{name})"/>')
    return parts


def _hatched(x: float, y: float, wide: float, high: float, name: str) -> str:
    size = f'x="{x:.1f}" y="{y:.1f}" width="{wide:.2f}" height="{high:.2f}"'
    return f'<rect class="area {name}" {size} fill="url(#chart-{name})"/>'


def _borders(axes: Axes, edges: tuple[list[float], list[float]], kinds: Integers) -> list[str]:
    """Lines between cells of different kinds."""
    d = []
    for i, j in np.argwhere(kinds[1:] != kinds[:-1]):
        d.append(f"M{axes.px(edges[0][i + 1]):.1f} {axes.py(edges[1][j]):.1f}V{axes.py(edges[1][j + 1]):.1f}")
    for i, j in np.argwhere(kinds[:, 1:] != kinds[:, :-1]):
        d.append(f"M{axes.px(edges[0][i]):.1f} {axes.py(edges[1][j + 1]):.1f}H{axes.px(edges[0][i + 1]):.1f}")
    return [path("".join(d), "border")] if d else []


def _edges(values: Any, cells: int) -> list[float]:
    v = np.asarray(values, float)
    if len(v) == cells + 1:
        return [float(x) for x in v]
    middle = (v[1:] + v[:-1]) / 2
    return [float(v[0]), *middle.tolist(), float(v[-1])]


def _runs(row: Integers) -> list[tuple[int, int, int]]:
    ends = np.flatnonzero(np.diff(row)).tolist()
    starts = [0, *[k + 1 for k in ends]]
    return [(a, b, int(row[a])) for a, b in zip(starts, [*ends, len(row) - 1], strict=True)]


def _inside(axes: Axes, x: float, y: float) -> tuple[float, float] | None:
    a, b = float(axes.px(x)), float(axes.py(y))
    return (a, b) if LEFT <= a <= WIDE - RIGHT and TOP <= b <= HIGH - BOTTOM else None


def _here(axes: Axes, x: float, y: float) -> list[str]:
    """A cross with an open middle, so that it hides nothing."""
    at = _inside(axes, x, y)
    if at is None:
        return []
    a, b = at
    cross = f"M {a - 13:.1f} {b:.1f} h 9 m 8 0 h 9 M {a:.1f} {b - 13:.1f} v 9 m 0 8 v 9"
    right = a < WIDE - 110
    return [path(cross, "ring"), text(a + (8 if right else -8), b - 8, "this case", "start" if right else "end")]


def _proved(axes: Axes, x: float, y: float, stable: bool) -> str:
    at = _inside(axes, x, y)
    if at is None:
        return ""
    a, b = at
    return (
        disc(a, b, 4, "root", "proved: stable")
        if stable
        else box(a - 4, b - 4, 8, 8, "root unstable", "proved: unstable")
    )


def _sure(axes: Axes, one: Sure) -> str:
    """The outline of what is inside of the frame."""
    (a, b), (c, d) = (np.clip(ends, *whole) for ends, whole in ((one.x, axes.x), (one.y, axes.y)))
    x, y = float(axes.px(a)), float(axes.py(d))
    wide, high = float(axes.px(b)) - x, float(axes.py(c)) - y
    outline = f"M{x:.1f} {y:.1f}h{wide:.1f}v{high:.1f}h{-wide:.1f}z"  # a rect without height would not be drawn
    return f'<path class="sure" d="{outline}"><title>proved: stable all over</title></path>'


def _legend(counts: Integers, open_words: str, sure: bool, at_zero: list[bool], meetings: bool) -> list[str]:
    """Four pieces of picture for each row: frame, tint, hatching, words."""
    found = sorted(set(np.ravel(counts).tolist()))
    few, more = [k for k in found if 0 < k <= 2], [k for k in found if k > 2]
    rows = [("", "blank: none grows")] * (0 in found)
    if few:
        grow = "root grows" if few == [1] else "roots grow"
        rows.append((SOME, f"hatched: {' or '.join(map(str, few))} {grow}"))
    if more:
        rows.append((MANY, f"crossed: {more[0]} roots grow{', or more' if len(more) > 1 else ''}"))
    rows += [(OPEN, f"dotted: {open_words}")] * (found[0] < 0)
    rows += [("boundary", "line: proved boundary, a pair of roots crosses")] * (False in at_zero)
    rows += [("boundary zero", "dashed line: proved boundary, a root passes q = 0")] * (True in at_zero)
    rows += [("point", "circle: proved point at which boundaries meet")] * meetings
    rows += [("sure", "outlined, or on the line: proved stable")] * sure
    parts = []
    for k, (name, words) in enumerate(rows):
        y = HIGH + 4 + _ROW * k
        if name.startswith(("boundary", "point")):
            mark = disc(LEFT + 11, y + 6, 4, name) if name == "point" else path(f"M{LEFT} {y + 6}h22", name)
            parts += [mark, text(LEFT + 30, y + 11, words, name="note"), "", ""]
            continue
        frame = box(LEFT, y, 22, 12, "sure" if name == "sure" else "frame")
        tint = box(LEFT, y, 22, 12, "grows") if name in (SOME, MANY) else ""
        area = _hatched(LEFT, y, 22, 12, name) if name not in ("", "sure") else ""
        parts += [tint, area, frame, text(LEFT + 30, y + 11, words, name="note")]
    return parts
