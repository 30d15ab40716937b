"""Tables over ranges: read from TOML that names a problem file, and written as CSV, JSON and LaTeX."""

from __future__ import annotations

import json
import re
from collections.abc import Mapping
from pathlib import Path
from typing import Any

from mpsolve.errors import InputError
from mpsolve.files import csv_text
from mpsolve.numbers.exact import Exact
from mpsolve.numbers.model import rational
from mpsolve.numbers.packed import pack
from mpsolve.numbers.spoken import decimal
from mpsolve.problem.inputfile import read_source
from mpsolve.problem.specs import load, steps
from mpsolve.problem.toml import check_keys, kind
from mpsolve.progress import Progress
from mpsolve.ranges.entry import Entry
from mpsolve.ranges.table import Table, stability_table
from mpsolve.report.ranges_asked import asked
from mpsolve.report.spectrum_words import ASSUMED

FORMAT = "mpsolve stability table"
VERSION = 1
_TOP = {
    "title": "a text",
    "problem": "the path of a problem file, from the folder of this one",
    "over": "the range, such as v=0..400km/h",
    "quantity": "onset or unstable ranges",
    "digits": "the digits of a number",
    "seconds": "of processor time that an entry may take",
    "rows": "a section",
    "columns": "a section",
}
_GRID = {"parameter": "the path of a parameter", "values": "a list, or {start, stop, step}"}
_MOST = 10_000
WITHOUT = "Each number is proved, correctly rounded to the digits shown; there are no certificates of entries."


def read_table(file: Path, workers: int | None = None, progress: Progress | None = None) -> Table:
    """The table that the TOML file describes.

        title = "…"                      # may be left out
        problem = "rail_60e1.toml"       # any problem file, from the folder of this one
        over = "v=0..400km/h"            # the range; numbers are printed in the unit of its upper end
        quantity = "onset"               # or "unstable ranges"
        digits = 10                      # of each number
        [rows]
        parameter = "track.k"            # any path of the problem
        values = ["0.8 MN/m²", 1e6]      # in the model's unit where none stands there; or {start, stop, step}
        [columns]
        parameter = "gap[0]"
        values = { start = 2, stop = 4, step = 0.5 }

    InputError under the key at fault.
    """
    content = load(file, _TOP)
    for key in ("problem", "over", "rows", "columns"):
        if key not in content:
            raise InputError(key, f"is missing: give {_TOP[key]}")
    source = read_source(file.parent / _text(content, "problem"))
    question = asked(source.given, source.title, [_text(content, "over")])
    seconds = content.get("seconds")
    return stability_table(
        source.given,
        over=question.overs[0],
        rows=_grid(content["rows"], "rows"),
        columns=_grid(content["columns"], "columns"),
        quantity=content.get("quantity", "onset"),
        digits=content.get("digits", 10),
        seconds=None if seconds is None else float(rational(seconds, "seconds")),
        workers=workers,
        progress=progress,
        title=content.get("title", source.title),
    )


def _text(content: Mapping[str, Any], key: str) -> str:
    value = content[key]
    if type(value) is not str:
        raise InputError(key, f"is {kind(value)}, not a text: give {_TOP[key]}")
    return value


def _grid(table: Any, key: str) -> dict[str, Any]:
    if not isinstance(table, dict):
        raise InputError(key, f"is {kind(table)}, not a section: write [{key}] with parameter and values")
    check_keys(table, _GRID, f"{key}.")
    for name, told in _GRID.items():
        if name not in table:
            raise InputError(f"{key}.{name}", f"is missing: give {told}")
    values = table["values"]
    if isinstance(values, dict):
        start, step, number = steps(values, f"{key}.values")
        if number > _MOST:
            raise InputError(f"{key}.values.step", f"makes {number} values: give a step that makes at most {_MOST}")
        values = [Exact.parse(start + k * step) for k in range(number)]
    if not isinstance(values, list):
        raise InputError(f"{key}.values", f"is {kind(values)}: give {_GRID['values']}")
    return {str(table["parameter"]): [x if isinstance(x, str) else Exact.parse(x) for x in values]}


def table_csv(table: Table) -> str:
    """A line a row, a column a column; the unit of the numbers stands in the first heading."""
    what = f"{table.quantity} of {table.over.path}" + (f" [{table.over.unit}]" if table.over.unit else "")
    head = [f"{table.rows[0]} \\ {table.columns[0]}: {what}", *map(decimal, table.columns[1])]
    rows = zip(table.rows[1], table.entries, strict=True)
    return csv_text([head, *([decimal(value), *(entry.text for entry in row)] for value, row in rows)])


def table_json(table: Table) -> str:
    """Everything: format, version, title, quantity, digits, over, rows and columns with exact values, entries.

    An entry has status, text (in over.unit), reason in parts or null, over (the range of which it speaks), and balls:
    [mantissa, exponent of 2] of the middle and of the radius of each number, in the model's unit.
    """
    over = table.over
    content = {
        "format": FORMAT,
        "version": VERSION,
        "title": table.title,
        "quantity": table.quantity,
        "digits": table.digits,
        "over": {"path": over.path, "low": str(over.low), "high": str(over.high), "unit": over.unit, "si": over.si},
        "rows": {"parameter": table.rows[0], "values": list(map(decimal, table.rows[1]))},
        "columns": {"parameter": table.columns[0], "values": list(map(decimal, table.columns[1]))},
        "entries": [[_entry(entry) for entry in row] for row in table.entries],
        "certificate": None,
        "proved": WITHOUT,
        "assumed": ASSUMED,
    }
    return json.dumps(content, indent=1, ensure_ascii=False) + "\n"


def table_tex(table: Table) -> str:
    r"""A tabular between \toprule and \bottomrule (package booktabs), and a sentence below it."""
    width = len(table.columns[1])
    unit = f" in {table.over.unit}" if table.over.unit else ""
    lines = [
        *([f"% {' '.join(table.title.split())}"] if table.title else []),
        "% needs \\usepackage{booktabs}",
        f"\\begin{{tabular}}{{l{'l' * width}}}",
        "\\toprule",
        f" & \\multicolumn{{{width}}}{{c}}{{{_name(table.columns[0])}}} \\\\",
        f"\\cmidrule(l){{2-{width + 1}}}",
        " & ".join([_name(table.rows[0]), *map(_cell, map(decimal, table.columns[1]))]) + " \\\\",
        "\\midrule",
    ]
    for value, row in zip(table.rows[1], table.entries, strict=True):
        lines.append(" & ".join([_cell(decimal(value)), *(_cell(entry.text) for entry in row)]) + " \\\\")
    said = f"{table.quantity.capitalize()} of {_name(table.over.path)}{_prose(unit)}. {WITHOUT}"
    return "\n".join([*lines, "\\bottomrule", "\\end{tabular}", "", f"{{\\par\\footnotesize {said}\\par}}"]) + "\n"


_SYMBOLS = {"alpha": r"$\alpha$", "eta_b": r"$\eta_b$", "eta_m": r"$\eta_M$", "d": "$d$", "v": "$v$"}


def _name(path: str) -> str:
    """A parameter in mathematics, or its path as it is written."""
    return _SYMBOLS.get(path, f"\\texttt{{{_prose(path)}}}")


def _cell(text: str) -> str:
    """Words as they are, numbers in mathematics."""
    return text if text.replace(" ", "").isalpha() else f"${text}$"


def _prose(text: str) -> str:
    """Nothing that LaTeX reads otherwise."""
    return re.sub(r"([_%#&{}$])", r"\\\1", text)


WRITERS = {".csv": table_csv, ".json": table_json, ".tex": table_tex}


def _entry(entry: Entry) -> dict[str, Any]:
    return {
        "status": entry.status,
        "text": entry.text,
        "reason": None if entry.reason is None else entry.reason.data(),
        "over": list(map(str, entry.over)),
        "balls": [[[str(x), e] for x, e in pack(ball)] for ball in entry.balls],
    }


def summary(table: Table) -> str:
    """How many entries have become what."""
    found = [entry.status for row in table.entries for entry in row]
    counts = (f"{found.count(one)} {one}" for one in ("proved", "stable", "unstable", "undecided") if one in found)
    return f"{len(found)} entries: {', '.join(counts)}. {WITHOUT}"
