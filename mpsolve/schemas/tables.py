"""Tables: the files that ask for one, and what is written."""

from __future__ import annotations

from mpsolve.problem.schema import DRAFT
from mpsolve.report.range_table import FORMAT, VERSION
from mpsolve.schemas import parts as p

_NUMBER = p.one_of(p.REAL, p.TEXT)
_STEPS = p.table({"start": _NUMBER, "stop": _NUMBER, "step": _NUMBER})
_VALUES = p.one_of({"type": "array", "minItems": 1, "items": p.one_of(_NUMBER, p.rows(_NUMBER))}, _STEPS)
_GRID = p.table({"parameter": p.TEXT, "values": _VALUES})
_SHOWN_GRID = p.table({"parameter": p.TEXT, "values": p.rows(p.TEXT)})


def _file(name: str, title: str, properties: p.Schema, optional: p.Schema) -> p.Schema:
    return {
        "$schema": DRAFT,
        "$id": f"https://mpsolve.invalid/{name}/1",
        "title": title,
        "description": "Of TOML, whose tables are the same as those of JSON.",
    } | p.table(properties, optional)


def table_file_schema() -> p.Schema:
    """A table of any problem over two of its parameters."""
    return _file(
        "table-file",
        "Input of mpsolve table, for any problem",
        {"problem": p.TEXT, "over": p.TEXT, "rows": _GRID, "columns": _GRID},
        {"title": p.TEXT, "quantity": {"enum": ["onset", "unstable ranges"]}, "digits": p.DIGITS, "seconds": _NUMBER},
    )


def table_schema() -> p.Schema:
    """Of `mpsolve table -o FILE.json`, for any problem."""
    entry = {
        "status": {"enum": ["proved", "stable", "unstable", "undecided"]},
        "text": p.TEXT,
        "reason": p.maybe(p.REASON),
        "over": p.rows(p.RATIONAL),
        "balls": p.rows(p.rows(p.DYADIC)),
    }
    over = p.table({"path": p.TEXT, "low": p.RATIONAL, "high": p.RATIONAL, "unit": p.TEXT, "si": p.TEXT})
    keys: p.Schema = {
        "title": p.TEXT,
        "quantity": {"enum": ["onset", "unstable ranges"]},
        "digits": p.DIGITS,
        "over": over,
        "rows": _SHOWN_GRID,
        "columns": _SHOWN_GRID,
        "entries": p.rows(p.rows(p.table(entry))),
        "certificate": {"type": "null"},
        "proved": p.TEXT,
        "assumed": p.TEXT,
    }
    return p.document("table", "Table of mpsolve table", FORMAT, VERSION, keys)
