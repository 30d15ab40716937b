"""Pictures of answers over ranges: root loci over a parameter, and a box of parameters under proof.

Loci: how fast the vibration of each line grows, and where one begins to. A box: open parts, a counterexample, and the
case; a panel for each pair.
"""

from __future__ import annotations

from itertools import combinations

import numpy as np

from mpsolve.loci.answer import FrequencyLines
from mpsolve.pictures.axes import HIGH, LEFT, RIGHT, TOP, WIDE, Axes, alone, box, disc, svg, text
from mpsolve.pictures.lines import Curve, Mark, lines_picture
from mpsolve.pictures.proved_chart import axis_title
from mpsolve.problem.over import Over
from mpsolve.ranges.robust_answer import Robust
from mpsolve.report.ranges_asked import Asked

_DRAWN = 400  # open parts


def open_boxes(found: Robust, asked: Asked) -> str:
    """The SVG of an answer, as a file of its own; axes in the units that the user wrote.

    A point of a panel lies in an open part wherever some value of the other parameters makes it one.
    """
    pairs: list[tuple[Over, ...]] = list(combinations(asked.overs, 2)) or [(asked.overs[0],)]
    panels = [
        f'<g transform="translate(0 {k * HIGH})">{"".join(_panel(found, asked, pair))}</g>'
        for k, pair in enumerate(pairs)
    ]
    return alone(svg(panels, _title(found), HIGH * len(panels)))


def _title(found: Robust) -> str:
    if found.stable:
        return "Stable for all these values: nothing is open"
    if found.stable is False:
        return "Unstable at the point that is marked"
    return f"Open parts of the ranges: {len(found.open)}" + (f", {_DRAWN} drawn" if len(found.open) > _DRAWN else "")


def _panel(found: Robust, asked: Asked, pair: tuple[Over, ...]) -> list[str]:
    ends = [tuple(float(one.shown(x)) for x in found.over[one.path]) for one in pair]
    x, y = (ends[0][0], ends[0][1]), (ends[1][0], ends[1][1]) if len(pair) == 2 else (0.0, 1.0)
    axes = Axes(x, y)
    out = []
    for part in found.open[:_DRAWN]:
        sides = [tuple(float(one.shown(x)) for x in part[one.path]) for one in pair]
        (a, b), (c, d) = sides[0], sides[1] if len(pair) == 2 else y
        left, top = float(axes.px(a)), float(axes.py(d))
        out.append(box(left, top, float(axes.px(b)) - left, float(axes.py(c)) - top, "hatch"))
    out += axes.titled(axis_title(pair[0]), axis_title(pair[1]) if len(pair) == 2 else "")
    for values, name, words in (
        (asked.problem.parameters, "ring", "this case"),
        (found.counterexample or {}, "root unstable", "unstable here"),
    ):
        if all(one.path in values for one in pair):
            at = [float(one.shown(values[one.path])) for one in pair] + [0.5]
            inside = all(low <= t <= high for t, (low, high) in zip(at, (x, y), strict=False))
            px, py = float(axes.px(at[0])), float(axes.py(at[1]))
            out += [disc(px, py, 5, name, words), text(px + 8, py - 6, words)] if inside else []
    return [*out, text((LEFT + WIDE - RIGHT) / 2, TOP + 14, _title(found), "middle")]


def loci_picture(found: FrequencyLines, asked: Asked) -> str:
    """The SVG of the lines, as a file of its own: −Im q over the parameter in the unit that the user wrote."""
    (over,) = asked.overs
    factor = float(over.shown(1.0))
    curves, marks = [], []
    for k, line in enumerate(found.lines, 1):
        x = np.array([float(value) * factor for value, *_ in line.points])
        y = np.array([-float(q.imag.mid()) for _, q, _ in line.points])
        at_cut = [end.startswith("cut") for *_, end in line.points]
        curves.append(Curve(x, y, f"line {k}", ends=at_cut))
        marks += [Mark(float(one.value.mid()) * factor, over.told(one.value)) for one in line.crossings]
    title = f"{over.path}, {over.unit}" if over.unit else over.path
    rate = "growth −Im q, 1/s" if asked.si else "growth −Im q"
    low, high = (float(x) * factor for x in next(iter(found.over.values())))
    return alone(lines_picture(
        curves, title, rate, "How fast each vibration grows, proved at the points and continuous between them",
        name="loci", x=(low, high), marks=marks, grows_above=0.0,
    ))  # fmt: skip
