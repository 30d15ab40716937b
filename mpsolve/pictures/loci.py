"""Root loci: how fast the vibration of each line grows, over the parameter, and where one begins to."""

from __future__ import annotations

import numpy as np

from mpsolve.loci.answer import FrequencyLines
from mpsolve.pictures.axes import alone
from mpsolve.pictures.lines import Curve, Mark, lines_picture
from mpsolve.report.ranges_asked import Asked


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
