"""Answers about ranges as tables: CSV with the units in the headings."""

from __future__ import annotations

import csv
import io
from fractions import Fraction
from typing import Any

from mpsolve.numbers.spoken import decimal
from mpsolve.ranges.cells import BOUNDARY
from mpsolve.ranges.chart import Chart
from mpsolve.report.ranges_asked import Asked
from mpsolve.report.ranges_words import Said


def rows_csv(said: list[Said]) -> str:
    """The rows of the answers, one after another; the quantity that is looked for in the model's unit."""
    rows = [dict(row) for one in said for row in one.answer.rows()]
    (over, *_) = said[0].asked.overs
    rate = "rad/s" if said[0].asked.si else "√(k/m)"
    units = {"value": over.si, "start": over.si, "end": over.si, "q": rate, "re q": rate, "im q": rate}
    names = list(dict.fromkeys(name for row in rows for name in row))
    named = {name: over.path if name == "value" else name for name in names}
    headings = [f"{named[name]} [{units[name]}]" if units.get(name) else named[name] for name in names]
    return _csv([headings, *([_text(row.get(name)) for name in names] for row in rows)])


def cells_csv(chart: Chart, asked: Asked) -> str:
    """A line for each cell: its ends in the model's units, exact, and what is proved of it.

    roots: how many grow, or "boundary" where one passes or may pass, or "open".
    """
    names = [f"{one.path} {end} [{one.si}]" if one.si else f"{one.path} {end}"
             for one in asked.overs for end in ("low", "high")]  # fmt: skip
    rows = [[*names, "roots"]]
    for i in range(len(chart.x) - 1):
        for j in range(len(chart.y) - 1):
            ends = (chart.x[i], chart.x[i + 1], chart.y[j], chart.y[j + 1])
            count = int(chart.counts[i, j])
            shown = str(count) if count >= 0 else "boundary" if count == BOUNDARY else "open"
            rows.append([*map(decimal, ends), shown])
    return _csv(rows)


def _text(value: Any) -> str:
    if isinstance(value, Fraction):
        return decimal(value)
    return "" if value is None else repr(value) if isinstance(value, float) else str(value)


def _csv(rows: list[list[str]]) -> str:
    out = io.StringIO()
    csv.writer(out, lineterminator="\n").writerows(rows)
    return out.getvalue()
