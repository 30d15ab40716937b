"""The pieces of which the schemas are made."""

from __future__ import annotations

from typing import Any

from mpsolve.outcome import Status

DRAFT = "https://json-schema.org/draft/2020-12/schema"
Schema = dict[str, Any]

TEXT: Schema = {"type": "string"}
YES: Schema = {"type": "boolean"}
COUNT: Schema = {"type": "integer", "minimum": 0}
POSITIVE: Schema = {"type": "integer", "minimum": 1}
WHOLE: Schema = {"type": "integer"}
REAL: Schema = {"type": "number"}
SECONDS: Schema = {"type": "number", "minimum": 0}
DIGITS = POSITIVE
DECIMAL: Schema = {"type": "string", "pattern": r"^-?[0-9]+(\.[0-9]+)?(e[+-]?[0-9]+)?$"}
RATIONAL: Schema = {"type": "string", "pattern": r"^-?[0-9]+(/[0-9]+)?$"}
STATUS: Schema = {"enum": [status.value for status in Status]}


def table(properties: Schema, optional: Schema | None = None) -> Schema:
    """An object with just these keys, those of `optional` if they like."""
    return {
        "type": "object",
        "properties": properties | (optional or {}),
        "required": list(properties),
        "additionalProperties": False,
    }


def rows(items: Schema) -> Schema:
    return {"type": "array", "items": items}


def by_name(values: Schema) -> Schema:
    """An object with any keys."""
    return {"type": "object", "additionalProperties": values}


def maybe(schema: Schema) -> Schema:
    return {"anyOf": [schema, {"type": "null"}]}


def one_of(*schemas: Schema) -> Schema:
    return {"anyOf": list(schemas)}


REASON: Schema = table({"code": TEXT, "message": TEXT, "numbers": {"type": "object"}, "remedy": TEXT})
ROUND: Schema = table({"value": DECIMAL, "radius": DECIMAL}) | {"description": "within radius of value, proved"}
DYADIC: Schema = {"type": "array", "items": one_of(WHOLE, TEXT), "description": "[m, e]: m times 2 to the e"}
BALL: Schema = table({"decimal": TEXT, "lower": REAL, "upper": REAL, "ball": rows(DYADIC)}) | {
    "description": "decimal: its sure digits; lower and upper: floats on both sides; ball: middle and radius, exact"
}
EXACT: Schema = table({"exact": TEXT, "decimal": one_of(REAL, DECIMAL)})


def head(name: str, title: str, version: int = 1) -> Schema:
    """What a schema says of itself."""
    return {"$schema": DRAFT, "$id": f"https://mpsolve.invalid/{name}/{version}", "title": title}


def document(
    name: str, title: str, form: str, version: int, properties: Schema, optional: Schema | None = None
) -> Schema:
    """The schema of one kind of file or output, which names its own format and version."""
    own: Schema = {"format": {"const": form}, "version": {"const": version}}
    return head(name, title, version) | table(own | properties, optional)
