"""The JSON Schema of what `mpsolve certify --json` prints; `spectrum_data` says what each key means."""

from __future__ import annotations

from typing import Any

from mpsolve.outcome import Status
from mpsolve.problem.schema import DRAFT
from mpsolve.report.spectrum_data import FORMAT, VERSION

_DECIMAL = {"type": "string", "pattern": r"^-?[0-9]+(\.[0-9]+)?(e[+-]?[0-9]+)?$"}
_TEXT, _COUNT = {"type": "string"}, {"type": "integer", "minimum": 0}
_TEXTS = {"type": "array", "items": _TEXT}


def certify_schema() -> dict[str, Any]:
    """The schema of version 2 of the report; later versions add keys and change none."""
    ball, maybe = {"$ref": "#/$defs/ball"}, {"anyOf": [{"$ref": "#/$defs/ball"}, {"type": "null"}]}
    root = {"re": ball, "im": ball, "multiplicity": {"type": "integer", "minimum": 1}}
    root |= {
        "axis": {"enum": ["none", "real", "imaginary"]},
        "trend": {"enum": ["grows", "decays", "steady", "open"]},
        "frequency": ball,
        "growth_rate": ball,
        "doubling_time": maybe,
        "halving_time": maybe,
        "shape": _or_null(
            _object(
                {
                    "bodies": {"type": "object", "additionalProperties": _object({"re": ball, "im": ball})},
                    "places": {"type": "array", "items": {"$ref": "#/$defs/exact"}},
                    "rail": {"type": "array", "items": _object({"re": ball, "im": ball})},
                }
            )
        ),
    }
    properties = {
        "format": {"const": FORMAT},
        "version": {"const": VERSION},
        "title": _TEXT,
        "verdict": {"type": "string", "pattern": "^(STABLE|UNSTABLE|NO GROWTH|UNDECIDED)"},
        "status": {"enum": [status.value for status in Status]},
        "reason": _or_null({"$ref": "#/$defs/reason"}),
        "known": {"type": "object"},
        "warnings": {"type": "array", "items": {"$ref": "#/$defs/reason"}},
        "stable": {"type": ["boolean", "null"]},
        "region": {"$ref": "#/$defs/region"},
        "digits": {"type": "integer", "minimum": 15},
        "count": _or_null(_COUNT),
        "unstable": _or_null(_COUNT),
        "neutral": _COUNT,
        "unfelt": {"type": "array", "items": _object({"re": ball, "im": ball})},
        "problem": {"oneOf": [{"$ref": "#/$defs/problem"}, {"$ref": "#/$defs/case"}]},
        "units": _object(dict.fromkeys(("q", "frequency", "growth_rate", "time"), _TEXT)),
        "roots": {"type": "array", "items": _object(root)},
        "proved": _TEXTS,
        "verified": _TEXT,
        "assumed": _TEXT,
        "cost": _object(
            {"seconds": _REAL, "verification": _REAL, "evaluations": _COUNT, "pieces": _COUNT}
        ),
        "certificate": {"type": ["string", "null"]},
    }  # fmt: skip
    return {
        "$schema": DRAFT,
        "$id": f"https://mpsolve.invalid/certify/{VERSION}",
        "title": "Report of mpsolve certify --json",
        **_object(properties),
        "$defs": _definitions(),
    }


_REAL = {"type": "number", "minimum": 0}


def _definitions() -> dict[str, Any]:
    exact = {"$ref": "#/$defs/exact"}
    model = {"$ref": "#/$defs/model"}
    return {
        "ball": _object({"value": _DECIMAL, "radius": _DECIMAL}) | {"description": "within radius of value, proved"},
        "exact": _object({"exact": _TEXT, "decimal": _TEXT})
        | {
            "properties": {"exact": _TEXT, "decimal": _TEXT, "unit": _TEXT},
            "description": "an exact number, its decimal, and the unit of a parameter in SI",
        },
        "reason": _object({"code": _TEXT, "message": _TEXT, "numbers": {"type": "object"}, "remedy": _TEXT}),
        "region": {
            "type": "object",
            "properties": {
                "kind": {"enum": ["unstable", "below", "rectangle", "sheet"]},
                "words": _TEXT,
                **dict.fromkeys(("height", "reach", "radius", "re_min", "re_max", "im_min", "im_max"), exact),
            },
            "required": ["kind", "words"],
            "additionalProperties": False,
        },
        "model": {
            "type": "object",
            "properties": {
                "model": _TEXT,
                "parameters": {"type": "object", "additionalProperties": {"$ref": "#/$defs/value"}},
                "position": exact,
            },
            "required": ["model", "parameters"],
            "additionalProperties": False,
        },
        "value": {"anyOf": [exact, model, _TEXT, {"type": "array", "items": {"$ref": "#/$defs/value"}}]},
        "problem": _object({"velocity": exact, "track": model, "vehicle": {"type": "array", "items": model}}),
        "case": _object(
            {
                "case": {
                    "type": "object",
                    "additionalProperties": {"anyOf": [exact, {"type": "array", "items": exact}]},
                }
            }
        ),
    }


def _object(properties: dict[str, Any]) -> dict[str, Any]:
    """An object with just these keys."""
    return {"type": "object", "properties": properties, "required": list(properties), "additionalProperties": False}


def _or_null(schema: dict[str, Any]) -> dict[str, Any]:
    return {"anyOf": [schema, {"type": "null"}]}
