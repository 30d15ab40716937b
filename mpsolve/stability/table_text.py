"""Tables of onsets as CSV, JSON and LaTeX."""

from __future__ import annotations

import csv
import io
import json
import re
from typing import TYPE_CHECKING, Any

from mpsolve.model.assumed import ASSUMED
from mpsolve.numbers.decimals import decimal
from mpsolve.problem.specs import label

if TYPE_CHECKING:
    from mpsolve.stability.table import Entry, OnsetTable

FORMAT = "mpsolve table"
VERSION = 1
_SYMBOLS = {
    "alpha": r"\alpha",
    "eta_b": r"\eta_b",
    "eta_m": r"\eta_M",
    "d": "d",
    "eta_n": r"\eta_N",
    "eta_s": r"\eta_S",
}
_WRITTEN = {name: f"${symbol}$" for name, symbol in _SYMBOLS.items() if name != "d"}
_WRITTEN |= {"alpha_C": r"$\alpha_C$", "^2": "$^2$", "<": "$<$", ">": "$>$", "\\": "/", "^": "", "~": " "}
_SPECIAL = re.compile(r"alpha_C|alpha|eta_[bmns]|\^2|[<>_%#&~^{}$\\]")
_BALL_DIGITS = 4  # of the balls in JSON beyond those of the values


def proved_sentence(table: OnsetTable) -> str:
    """What every decimal of the table means."""
    what = {
        "onset velocity": "Each number is the velocity ratio alpha of the onset, the first in the range {range} at "
        "which an induced frequency q enters Im q < 0",
        "onset mass": "Each number is the onset mass, the smallest mass ratio eta_m of each mass at which an induced "
        "frequency q enters Im q < 0",
        "unstable velocities": "The intervals are all velocity ratios alpha of the range {range} at which an induced "
        "frequency q has Im q < 0",
    }[table.quantity]
    ends = "" if table.alpha is None else f"[{label(table.alpha[0])}, {label(table.alpha[1])}]"
    return f"{what.format(range=ends)}, proved and correctly rounded in every digit."


def notes(table: OnsetTable) -> list[tuple[int, int, str]]:
    """Row, column and reason of each entry that is no number."""
    return [
        (i, j, entry.reason) for i, row in enumerate(table.entries) for j, entry in enumerate(row) if entry.reason
    ]


def csv_text(table: OnsetTable) -> str:
    """Comma-separated, each line ended by a newline; the last column holds the reasons of the row."""
    stream = io.StringIO()
    writer = csv.writer(stream, lineterminator="\n")
    rows, columns = table.row_grid, table.column_grid
    writer.writerow([f"{rows.parameter} \\ {columns.parameter}", *columns.labels, "note"])
    reasons: dict[int, list[str]] = {}
    for i, j, reason in notes(table):
        reasons.setdefault(i, []).append(f"{columns.parameter} = {columns.labels[j]}: {reason}")
    for i, (value, entries) in enumerate(zip(rows.labels, table.entries, strict=True)):
        writer.writerow([value, *(entry.text for entry in entries), "; ".join(reasons.get(i, []))])
    return stream.getvalue()


def json_text(table: OnsetTable) -> str:
    """An object with these keys; every digit of every number is proved.

    format, version   "mpsolve table", 1; a version adds no meaning to a key that is there
    title, quantity, digits
    alpha             {"start", "end"} of the range of velocities, or null
    fixed             the other parameters
    rows, columns     {"parameter", "values"}: exact texts
    entries           a list for each row, of objects with
        status, reason
        value         the correctly rounded decimal or decimals, or null
        ball          {"value", "radius"}: the exact number is within radius of value; null if not a single number
        spans         for "unstable velocities": objects start, end, roots (or more), starts_at_crossing,
                      ends_at_crossing
    proved, assumed   sentences
    """
    ends = None if table.alpha is None else dict(zip(("start", "end"), map(label, table.alpha), strict=True))
    content: dict[str, Any] = {
        "format": FORMAT,
        "version": VERSION,
        "title": table.title,
        "quantity": table.quantity,
        "digits": table.digits,
        "alpha": ends,
        "fixed": dict(table.fixed),
        "rows": {"parameter": table.row_grid.parameter, "values": list(table.row_grid.labels)},
        "columns": {"parameter": table.column_grid.parameter, "values": list(table.column_grid.labels)},
        "entries": [[_entry(entry, table.digits) for entry in row] for row in table.entries],
        "proved": proved_sentence(table),
        "assumed": ASSUMED,
    }
    return json.dumps(content, indent=1, ensure_ascii=False) + "\n"


def _entry(entry: Entry, digits: int) -> dict[str, Any]:
    ball = None
    if entry.ball is not None:
        shown = decimal(entry.ball, digits + _BALL_DIGITS)
        ball = {"value": shown.text, "radius": shown.radius_text}
    content: dict[str, Any] = {
        "status": entry.status, "reason": entry.reason, "value": entry.value, "ball": ball
    }  # fmt: skip
    if entry.spans:
        content["spans"] = [vars(span) for span in entry.spans]
    return content


def latex_text(table: OnsetTable) -> str:
    r"""A tabular between \toprule and \bottomrule (package booktabs), and a paragraph of notes."""
    rows, columns = table.row_grid, table.column_grid
    width = len(columns.values)
    marks = {(i, j): str(k) for k, (i, j) in enumerate(_marked(table), 1)}
    lines = [
        *([f"% {' '.join(table.title.split())}"] if table.title else []),
        "% needs \\usepackage{booktabs}",
        f"\\begin{{tabular}}{{l{'l' * width}}}",
        "\\toprule",
        f" & \\multicolumn{{{width}}}{{c}}{{${_SYMBOLS[columns.parameter]}$}} \\\\",
        f"\\cmidrule(l){{2-{width + 1}}}",
        " & ".join([f"${_SYMBOLS[rows.parameter]}$", *map(_cell, columns.labels)]) + " \\\\",
        "\\midrule",
    ]
    for i, (value, entries) in enumerate(zip(rows.labels, table.entries, strict=True)):
        cells = [_cell(value), *(_marked_cell(entry, marks.get((i, j))) for j, entry in enumerate(entries))]
        lines.append(" & ".join(cells) + " \\\\")
    lines += ["\\bottomrule", "\\end{tabular}", "", "{\\par\\smallskip\\noindent\\footnotesize"]
    lines.append(_prose(proved_sentence(table)))
    groups: dict[str, list[str]] = {}
    for i, j, reason in notes(table):
        groups.setdefault(reason, []).append(marks[i, j])
    lines += [f"$^{{{','.join(places)}}}$ {_prose(reason)}." for reason, places in groups.items()]
    return "\n".join([*lines, "\\par}"]) + "\n"


def _marked(table: OnsetTable) -> list[tuple[int, int]]:
    return [(i, j) for i, j, _ in notes(table)]


def _marked_cell(entry: Entry, mark: str | None) -> str:
    return _cell(entry.text) + (f"$^{{{mark}}}$" if mark else "")


def _cell(text: str) -> str:
    """Words as they are, numbers in mathematics."""
    return text if text.replace(" ", "").isalpha() else f"${text}$"


def _prose(text: str) -> str:
    """Text with the names of parameters in mathematics, and nothing that LaTeX reads otherwise."""
    return _SPECIAL.sub(lambda found: _WRITTEN.get(found[0], f"\\{found[0]}"), text)
