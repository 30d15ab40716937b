"""What onset, crossings, lines, worst, robust and chart print, and `to_json` of other answers of the library.

`ranges_data` says what each key means.
"""

from __future__ import annotations

from mpsolve.report import range_table
from mpsolve.report.ranges_data import FORMAT, VERSION
from mpsolve.schemas import parts as p
from mpsolve.schemas.certify import spectrum_parts

_CELLS = 2
_OVER = p.by_name({"type": "array", "items": p.maybe(p.EXACT), "minItems": _CELLS})
_COMMON: p.Schema = {
    "over": _OVER,
    "status": p.STATUS,
    "reason": p.maybe(p.REASON),
    "known": {"type": "object"},
    "cost": p.table({"seconds": p.SECONDS, "verification": p.SECONDS, "boxes": p.COUNT}),
    "note": p.TEXT,
    "proved": p.YES,
    "trust": p.TEXT,
}
_WHERE: p.Schema = {"enum": ["inside", "start", "end", ""]}
_COMPLEX = p.table({"real": p.BALL, "imag": p.BALL})
_CROSSING = p.table({"value": p.BALL, "q": p.BALL, "direction": p.maybe(p.WHOLE)})
_LEFT_OUT = p.rows(p.table({"name": p.TEXT, "value": p.BALL, "start": p.BALL, "end": p.BALL}))
_SIDE: p.Schema = {"enum": ["below", "above", "gap"]}
_ANSWERS: dict[str, p.Schema] = {
    "onset": {
        "digits": p.DIGITS,
        "kind": {"enum": ["crosses", "stable", "unstable_from_start", "undecided"]},
        "value": p.maybe(p.BALL),
        "q": p.maybe(p.BALL),
        "worst": p.maybe(p.BALL),
        "where": _WHERE,
        "left_out": _LEFT_OUT,
    },
    "worst": {
        "digits": p.DIGITS,
        "value": p.maybe(p.BALL),
        "q": p.maybe(_COMPLEX),
        "where": _WHERE,
        "reach": p.maybe(p.EXACT),
        "growth": p.maybe(p.BALL),
    },
    "unstable_ranges": {
        "digits": p.DIGITS,
        "intervals": p.rows(
            p.table({"start": p.BALL, "end": p.maybe(p.BALL), "q": p.maybe(p.BALL), "roots": p.COUNT})
        ),
        "left_out": _LEFT_OUT,
    },
    "crossings": {
        "digits": p.DIGITS,
        "crossings": p.rows(_CROSSING),
        "counts": p.maybe(p.rows(p.COUNT)),
        "left_out": _LEFT_OUT,
        "parts": p.rows({"type": "object", "description": "answers of the same form over the parts of the range"}),
    },
    "lines": {
        "digits": p.DIGITS,
        "region": p.table({}, {name: p.maybe(p.EXACT) for name in ("height", "reach", "radius")}),
        "values": p.rows(p.EXACT),
        "lines": p.rows(
            p.table(
                {
                    "values": p.rows(p.EXACT),
                    "q": p.rows(_COMPLEX),
                    "ends": p.rows(
                        p.table(
                            {
                                "kind": {"enum": ["range", "region", "cut", "collision", "open"]},
                                "side": p.maybe(_SIDE),
                                "value": p.maybe(p.BALL),
                                "q": p.maybe(_COMPLEX),
                            }
                        )
                    ),
                    "weight": p.COUNT,
                    "crossings": p.rows(_CROSSING),
                }
            )
        ),
        "events": p.rows(p.table({"value": p.BALL, "q": _COMPLEX, "gained": p.WHOLE, "side": p.maybe(_SIDE)})),
        "counts": p.maybe(p.rows(p.COUNT)),
    },
    "robust": {"stable": p.maybe(p.YES), "counterexample": p.maybe(p.by_name(p.EXACT)), "open": p.rows(_OVER)},
    "chart": {
        "x": p.rows(p.EXACT),
        "y": p.rows(p.EXACT),
        "counts": p.rows(p.rows({"type": "integer", "minimum": -2})),
        "parts": p.rows(p.table({"cells": p.COUNT, "point": p.by_name(p.EXACT), "roots": p.maybe(p.COUNT)})),
        "boundaries": p.rows(
            p.table(dict.fromkeys(("x", "y", "q", "radius"), p.rows(p.REAL)) | {"divergence": p.YES, "whole": p.YES})
        ),
        "meetings": p.rows(p.table({"x": p.BALL, "y": p.BALL, "q": p.rows(p.BALL)})),
        "traced": p.YES,
    },
}
QUESTIONS = tuple(_ANSWERS)
OF_LIBRARY: dict[str, p.Schema] = {
    "cut_points": {
        "digits": p.DIGITS,
        "points": p.rows(p.table({"value": p.BALL, "q": _COMPLEX, "side": _SIDE, "appears": p.YES})),
        "reach": p.maybe(p.REAL),
    },
    "sensitivity": {
        "roots": p.rows(p.table({"q": _COMPLEX, "by": p.by_name(_COMPLEX)})),
        "left_out": p.by_name(p.TEXT),
    },
}
_RANGE = p.table({"low": p.EXACT, "high": p.maybe(p.EXACT), "own": p.maybe(p.EXACT), "unit": p.TEXT})
_NUMBER = p.one_of(p.REAL, p.TEXT)
_STEPS = p.table({"start": _NUMBER, "stop": _NUMBER, "step": _NUMBER})
_VALUES = p.one_of({"type": "array", "minItems": 1, "items": p.one_of(_NUMBER, p.rows(_NUMBER))}, _STEPS)
_GRID = p.table({"parameter": p.TEXT, "values": _VALUES})
_SHOWN_GRID = p.table({"parameter": p.TEXT, "values": p.rows(p.TEXT)})


def library_schema(name: str) -> p.Schema:
    """What `to_json` of that answer gives: the answer alone, without format, version and words."""
    return p.head(name, f"Answer of {name}(…)") | p.table(_COMMON | OF_LIBRARY[name])


def ranges_schema(question: str) -> p.Schema:
    """Of one question; an answer over several default ranges has them one by one under `parts`."""
    definitions, spectrum = spectrum_parts()
    keys: p.Schema = {
        "question": {"const": question},
        "title": p.TEXT,
        "verdict": p.TEXT,
        "ranges": p.by_name(_RANGE),
        "warnings": p.rows(p.REASON),
        "answer": p.table(_COMMON | _ANSWERS[question]),
        "spectrum": p.maybe(spectrum),
        "certificate": p.maybe(p.TEXT),
        "trust": p.TEXT,
        "assumed": p.TEXT,
    }
    head: p.Schema = {"format": {"const": FORMAT}, "version": {"const": VERSION}}
    whole = p.document(question, f"Answer of mpsolve about {question}", FORMAT, VERSION, keys)
    several = p.table(head | {"question": {"const": question}, "parts": p.rows({"$ref": "#/$defs/one"})})
    names = {key: whole.pop(key) for key in ("$schema", "$id", "title")}
    return names | {"oneOf": [{"$ref": "#/$defs/one"}, several], "$defs": definitions | {"one": whole}}


def _file(name: str, title: str, properties: p.Schema, optional: p.Schema) -> p.Schema:
    told = {"description": "Of TOML, whose tables are the same as those of JSON."}
    return p.head(name, title) | told | p.table(properties, optional)


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
    return p.document("table", "Table of mpsolve table", range_table.FORMAT, range_table.VERSION, keys)
