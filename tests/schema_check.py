"""A small validator of JSON Schema for the tests: the keywords that are used here; any other one is an error."""

from __future__ import annotations

import re
from collections.abc import Callable
from typing import Any

_TYPES: dict[str, Any] = {
    "object": dict, "array": list, "string": str, "boolean": bool, "null": type(None), "integer": int,
    "number": (int, float),
}  # fmt: skip
_SILENT = {"$schema", "$id", "title", "description", "default", "x-unit", "$defs"}


def errors(value: Any, schema: dict[str, Any], root: dict[str, Any] | None = None, at: str = "") -> list[str]:
    """What breaks the schema, with its place; empty for a valid value."""
    root = schema if root is None else root
    found: list[str] = []
    for keyword, wanted in schema.items():
        if keyword not in _SILENT:
            found += _CHECKS[keyword](value, wanted, schema, root, at)
    return found


def _reference(value: Any, wanted: str, _: Any, root: Any, at: str) -> list[str]:
    return errors(value, root["$defs"][wanted.removeprefix("#/$defs/")], root, at)


def _type(value: Any, wanted: Any, *rest: Any) -> list[str]:
    names = [wanted] if isinstance(wanted, str) else wanted
    right = any(
        isinstance(value, _TYPES[name]) and (name == "boolean" or not isinstance(value, bool)) for name in names
    )
    return [] if right else [f"{rest[-1]}: {value!r} is no {wanted}"]


def _properties(value: Any, wanted: Any, _: Any, root: Any, at: str) -> list[str]:
    inner = value if isinstance(value, dict) else {}
    return [
        e for key, schema in wanted.items() if key in inner for e in errors(inner[key], schema, root, f"{at}.{key}")
    ]


def _additional(value: Any, wanted: Any, schema: Any, root: Any, at: str) -> list[str]:
    others = [key for key in value if key not in schema.get("properties", {})] if isinstance(value, dict) else []
    if wanted is False:
        return [f"{at}.{key} is unknown" for key in others]
    return [e for key in others for e in errors(value[key], wanted, root, f"{at}.{key}")]


def _alternatives(value: Any, wanted: Any, root: Any, at: str, one: bool) -> list[str]:
    tried = [errors(value, schema, root, at) for schema in wanted]
    fitting = sum(not e for e in tried)
    if fitting == 1 or (fitting and not one):
        return []
    return [f"{at}: {fitting} alternatives fit: {tried}"]


def _items(value: Any, wanted: Any, _: Any, root: Any, at: str) -> list[str]:
    entries = enumerate(value) if isinstance(value, list) else ()
    return [e for i, entry in entries for e in errors(entry, wanted, root, f"{at}[{i}]")]


def _required(value: Any, wanted: Any, *rest: Any) -> list[str]:
    return [f"{rest[-1]}.{key} is missing" for key in wanted if isinstance(value, dict) and key not in value]


def _simple(kind: Any, holds: Callable[[Any, Any], bool]) -> Callable[..., list[str]]:
    """The check of one keyword, which says nothing of values of another kind."""

    def check(value: Any, wanted: Any, *rest: Any) -> list[str]:
        right = not isinstance(value, kind) or isinstance(value, bool) or holds(value, wanted)
        return [] if right else [f"{rest[-1]}: {value!r} breaks {wanted!r}"]

    return check


_REAL = (int, float)
_CHECKS: dict[str, Any] = {
    "$ref": _reference,
    "type": _type,
    "properties": _properties,
    "additionalProperties": _additional,
    "required": _required,
    "items": _items,
    "minItems": _simple(list, lambda value, least: len(value) >= least),
    "minLength": _simple(str, lambda value, least: len(value) >= least),
    "minimum": _simple(_REAL, lambda value, least: value >= least),
    "exclusiveMinimum": _simple(_REAL, lambda value, least: value > least),
    "pattern": _simple(str, lambda value, pattern: re.search(pattern, value) is not None),
    "const": _simple(object, lambda value, wanted: value == wanted),
    "enum": _simple(object, lambda value, wanted: value in wanted),
    "anyOf": lambda value, wanted, _, root, at: _alternatives(value, wanted, root, at, False),
    "oneOf": lambda value, wanted, _, root, at: _alternatives(value, wanted, root, at, True),
}
