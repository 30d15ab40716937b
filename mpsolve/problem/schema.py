"""The JSON Schema of input files, made from the models: what a class says of its parameters stands there too.

TOML gives the same tables as JSON, so one schema serves editors, web forms and programs that write such files.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from mpsolve import tracks, vehicles
from mpsolve.numbers.model import Entries, Part, Quantity, Texts, defaults, quantities
from mpsolve.problem.casefile import DIMENSIONLESS, MASS, PHYSICAL, REQUIRED, UNITS
from mpsolve.problem.casefile import LOAD as RATIO_LOAD
from mpsolve.problem.inputfile import LOAD, LOAD_UNITS, PLACE
from mpsolve.problem.toml import SOURCE

DRAFT = "https://json-schema.org/draft/2020-12/schema"
VERSION = 1
_PLACE_UNITS = {"position": "m", "spacing": "m"}
_TEXT = {"type": "string"}
_SOURCE = {"description": SOURCE, "anyOf": [{"type": "string"}, {"type": "array", "items": {"type": "string"}}]}


def input_schema() -> dict[str, Any]:
    """The schema of a file for `certify` and its like: any problem, or one of the paper's cases in SI or ratios."""
    return {
        "$schema": DRAFT,
        "$id": f"https://mpsolve.invalid/input/{VERSION}",
        "title": "Input file of mpsolve",
        "description": "Exact numbers: a number as it is written, or a text with a ratio or a unit of the same kind.",
        "oneOf": [{"$ref": f"#/$defs/{name}"} for name in ("problem", "physical", "dimensionless")],
        "$defs": {
            "problem": _table(
                {
                    "title": _TEXT,
                    "source": _SOURCE,
                    "v": _number(Quantity("m/s", "velocity of all vehicles", at_least=0)),
                    "track": _one_of("track", tracks.CATALOGUE),
                    "vehicle": _some(_one_of("vehicle", vehicles.CATALOGUE)),
                    "load": _some({"$ref": "#/$defs/load"}),
                },
                ("v", "track", "vehicle"),
            ),
            "physical": _table(
                {
                    "title": _TEXT,
                    "source": _SOURCE,
                    "physical": _told(PHYSICAL, UNITS["physical"]),
                    "mass": _some(_told(MASS, UNITS["mass"])),
                },
                ("physical", "mass"),
            ),
            "dimensionless": _table(
                {
                    "title": _TEXT,
                    "source": _SOURCE,
                    "dimensionless": _ratios(),
                    "load": _some(_told(RATIO_LOAD, {})),
                },
                ("dimensionless",),
            ),
            "load": _told(LOAD, LOAD_UNITS),
            **{f"track-{model.name}": _model(model, {"source": _SOURCE}) for model in tracks.CATALOGUE},
            **{f"vehicle-{model.name}": _model(model, _placed()) for model in vehicles.CATALOGUE},
        },
    }  # fmt: skip


def _table(properties: Mapping[str, Any], required: tuple[str, ...]) -> dict[str, Any]:
    return {
        "type": "object",
        "properties": dict(properties),
        "required": list(required),
        "additionalProperties": False,
    }


def _some(items: Mapping[str, Any]) -> dict[str, Any]:
    return {"type": "array", "items": dict(items), "minItems": 1}


def _one_of(kind: str, catalogue: Any) -> dict[str, Any]:
    return {"oneOf": [{"$ref": f"#/$defs/{kind}-{model.name}"} for model in catalogue]}


def _model(model: Any, more: Mapping[str, Any], named: bool = True) -> dict[str, Any]:
    """A section: the model's name, its parameters, and `more` keys."""
    optional = defaults(model)
    properties: dict[str, Any] = {"model": {"const": model.name}}
    for name, quantity in quantities(model).items():
        properties[name] = _parameter(quantity)
        if optional.get(name) is not None:
            properties[name]["default"] = str(optional[name])
    required = [name for name in quantities(model) if name not in optional]
    table = _table(properties | dict(more), (*(["model"] if named else []), *required))
    return {"description": model.__doc__.split("\n")[0], **table}


def _placed() -> dict[str, Any]:
    whole = {"type": "integer", "minimum": 1, "description": PLACE["count"]}
    places = {key: _number(Quantity(unit, PLACE[key])) for key, unit in _PLACE_UNITS.items()}
    return {**places, "count": whole, "source": _SOURCE}


def _parameter(quantity: Quantity) -> dict[str, Any]:
    if isinstance(quantity, Part):
        return _model(quantity.kind, {}, named=False)
    if isinstance(quantity, Texts):
        return {"type": "array", "items": {"type": "string", "minLength": 1}, "description": quantity.told}
    if isinstance(quantity, Entries):
        schema: dict[str, Any] = _number(quantity)
        for _ in range(quantity.depth):
            schema = {"type": "array", "items": schema}
        return schema | {"description": quantity.told}
    return _number(quantity)


def _number(quantity: Quantity) -> dict[str, Any]:
    """A number within its bound, or a text; x-unit is what a bare number is measured in."""
    number: dict[str, Any] = {"type": "number"}
    if quantity.above is not None:
        number["exclusiveMinimum"] = quantity.above
    if quantity.at_least is not None:
        number["minimum"] = quantity.at_least
    return {
        "description": quantity.told,
        "x-unit": quantity.unit,
        "anyOf": [number, {"type": "string", "minLength": 1}],
    }


def _told(keys: Mapping[str, str], units: Mapping[str, str]) -> dict[str, Any]:
    """A section of the paper's cases, whose keys are told in sentences."""
    properties = {
        key: _number(Quantity(units.get(key, ""), told)) | {"description": told} for key, told in keys.items()
    }
    return _table(properties, tuple(key for key in keys if key in REQUIRED))


def _ratios() -> dict[str, Any]:
    table = _told(DIMENSIONLESS, {})
    for key in ("eta_m", "positions"):
        table["properties"][key] = _some(_number(Quantity("", DIMENSIONLESS[key])))
    return table
