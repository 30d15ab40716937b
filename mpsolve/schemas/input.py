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
from mpsolve.schemas import parts as p

VERSION = 1
_PLACE_UNITS = {"position": "m", "spacing": "m"}
_SOURCE: p.Schema = {"description": SOURCE} | p.one_of(p.TEXT, p.rows(p.TEXT))
_HEAD: p.Schema = {"title": p.TEXT, "source": _SOURCE}
_WRITTEN: p.Schema = {"type": "string", "minLength": 1}


def input_schema() -> p.Schema:
    """The schema of a file for `certify` and its like: any problem, or one of the paper's cases in SI or ratios."""
    return p.head("input", "Input file of mpsolve", VERSION) | {
        "description": "Exact numbers: a number as it is written, or a text with a ratio or a unit of the same kind.",
        "oneOf": [{"$ref": f"#/$defs/{name}"} for name in ("problem", "physical", "dimensionless")],
        "$defs": {
            "problem": p.table(
                {
                    "v": _number(Quantity("m/s", "velocity of all vehicles", at_least=0)),
                    "track": _one_of("track", tracks.CATALOGUE),
                    "vehicle": _some(_one_of("vehicle", vehicles.CATALOGUE)),
                },
                _HEAD | {"load": _some({"$ref": "#/$defs/load"})},
            ),
            "physical": p.table(
                {"physical": _told(PHYSICAL, UNITS["physical"]), "mass": _some(_told(MASS, UNITS["mass"]))}, _HEAD
            ),
            "dimensionless": p.table({"dimensionless": _ratios()}, _HEAD | {"load": _some(_told(RATIO_LOAD, {}))}),
            "load": _told(LOAD, LOAD_UNITS),
            **{f"track-{model.name}": _model(model, {"source": _SOURCE}) for model in tracks.CATALOGUE},
            **{f"vehicle-{model.name}": _model(model, _placed()) for model in vehicles.CATALOGUE},
        },
    }  # fmt: skip


def _some(items: p.Schema) -> p.Schema:
    return p.rows(items) | {"minItems": 1}


def _one_of(kind: str, catalogue: Any) -> p.Schema:
    return {"oneOf": [{"$ref": f"#/$defs/{kind}-{model.name}"} for model in catalogue]}


def _model(model: Any, more: p.Schema, named: bool = True) -> p.Schema:
    """A section: the model's name, its parameters, and `more` keys."""
    usual, own = defaults(model), {"model": {"const": model.name}}
    needed, optional = (own, {}) if named else ({}, own)
    for name, quantity in quantities(model).items():
        (optional if name in usual else needed)[name] = _parameter(quantity)
        if usual.get(name) is not None:
            optional[name]["default"] = str(usual[name])
    return {"description": model.__doc__.split("\n")[0]} | p.table(needed, optional | more)


def _placed() -> p.Schema:
    whole = {"type": "integer", "minimum": 1, "description": PLACE["count"]}
    places = {key: _number(Quantity(unit, PLACE[key])) for key, unit in _PLACE_UNITS.items()}
    return {**places, "count": whole, "source": _SOURCE}


def _parameter(quantity: Quantity) -> p.Schema:
    if isinstance(quantity, Part):
        return _model(quantity.kind, {}, named=False)
    if isinstance(quantity, Texts):
        return p.rows(_WRITTEN) | {"description": quantity.told}
    if isinstance(quantity, Entries):
        schema: p.Schema = _number(quantity)
        for _ in range(quantity.depth):
            schema = p.rows(schema)
        return schema | {"description": quantity.told}
    return _number(quantity)


def _number(quantity: Quantity) -> p.Schema:
    """A number within its bound, or a text; x-unit is what a bare number is measured in."""
    number: p.Schema = {"type": "number"}
    if quantity.above is not None:
        number["exclusiveMinimum"] = quantity.above
    if quantity.at_least is not None:
        number["minimum"] = quantity.at_least
    return {"description": quantity.told, "x-unit": quantity.unit} | p.one_of(number, _WRITTEN)


def _told(keys: Mapping[str, str], units: Mapping[str, str]) -> p.Schema:
    """A section of the paper's cases, whose keys are told in sentences."""
    properties = {
        key: _number(Quantity(units.get(key, ""), told)) | {"description": told} for key, told in keys.items()
    }
    needed = {key: one for key, one in properties.items() if key in REQUIRED}
    return p.table(needed, {key: one for key, one in properties.items() if key not in needed})


def _ratios() -> p.Schema:
    table = _told(DIMENSIONLESS, {})
    for key in ("eta_m", "positions"):
        table["properties"][key] = _some(_number(Quantity("", DIMENSIONLESS[key])))
    return table
