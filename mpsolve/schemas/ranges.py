"""What onset, crossings, worst, robust and chart print: `ranges_data` says what each key means."""

from __future__ import annotations

from mpsolve.report.ranges_data import FORMAT, VERSION
from mpsolve.report.schema import certify_schema
from mpsolve.schemas import parts as p

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
_LEFT_OUT = p.rows(p.table({"name": p.TEXT, "value": p.BALL, "start": p.BALL, "end": p.BALL}))
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
        "q": p.maybe(p.table({"real": p.BALL, "imag": p.BALL})),
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
        "crossings": p.rows(p.table({"value": p.BALL, "q": p.BALL, "direction": p.maybe(p.WHOLE)})),
        "counts": p.maybe(p.rows(p.COUNT)),
        "left_out": _LEFT_OUT,
        "parts": p.rows({"type": "object", "description": "answers of the same form over the parts of the range"}),
    },
    "robust": {"stable": p.maybe(p.YES), "counterexample": p.maybe(p.by_name(p.EXACT)), "open": p.rows(_OVER)},
    "chart": {
        "x": p.rows(p.EXACT),
        "y": p.rows(p.EXACT),
        "counts": p.rows(p.rows({"type": "integer", "minimum": -2})),
        "parts": p.rows(p.table({"cells": p.COUNT, "point": p.by_name(p.EXACT), "roots": p.maybe(p.COUNT)})),
    },
}
QUESTIONS = tuple(_ANSWERS)
_RANGE = p.table({"low": p.EXACT, "high": p.maybe(p.EXACT), "own": p.maybe(p.EXACT), "unit": p.TEXT})


def ranges_schema(question: str) -> p.Schema:
    """Of one question; an answer over several default ranges has them one by one under `parts`."""
    certify = certify_schema()
    definitions = certify.pop("$defs")
    spectrum = {key: value for key, value in certify.items() if not key.startswith("$")}
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
