"""The schema of input files takes what the reader takes, and refuses what it refuses."""

from __future__ import annotations

import tomllib
from pathlib import Path
from typing import Any

import pytest
from schema_check import errors

from mpsolve import tracks, vehicles
from mpsolve.errors import InputError
from mpsolve.numbers.model import quantities
from mpsolve.presets.written import input_file, names
from mpsolve.problem.inputfile import read_problem
from mpsolve.schemas.input import input_schema

EXAMPLES = Path(__file__).parents[2] / "examples"
SCHEMA = input_schema()
NAMES = ("two_layer_bogie", "train_8_coaches", "rail_60e1", "dimensionless", "loads")
FILES = [EXAMPLES / f"{name}.toml" for name in NAMES]


def test_it_is_a_schema() -> None:
    validators = pytest.importorskip("jsonschema").validators
    validators.Draft202012Validator.check_schema(SCHEMA)
    for file in FILES:
        validators.Draft202012Validator(SCHEMA).validate(tomllib.loads(file.read_text("utf-8")))


@pytest.mark.parametrize("file", FILES, ids=lambda file: file.stem)
def test_every_example(file: Path) -> None:
    assert errors(tomllib.loads(file.read_text("utf-8")), SCHEMA) == []


@pytest.mark.parametrize("name", names("track"))
def test_every_preset(name: str) -> None:
    assert errors(tomllib.loads(input_file(name)), SCHEMA) == []


def test_every_model_and_parameter_is_in_it() -> None:
    for kind, catalogue in (("track", tracks.CATALOGUE), ("vehicle", vehicles.CATALOGUE)):
        for model in catalogue:
            section = SCHEMA["$defs"][f"{kind}-{model.name}"]
            assert set(quantities(model)) <= set(section["properties"])
            for name, quantity in quantities(model).items():
                if "x-unit" in section["properties"][name]:
                    assert section["properties"][name]["x-unit"] == quantity.unit


@pytest.mark.parametrize(
    "change",
    [
        {"v": -1},
        {"v": None},
        {"speed": 3},
        {"track": {"model": "string", "T": 0, "m": 1}},
        {"track": {"model": "string", "T": 1}},
        {"track": {"model": "string", "T": 1, "m": 1, "EI": 1}},
        {"track": {"model": "strong", "T": 1, "m": 1}},
        {"vehicle": []},
        {"vehicle": {"model": "mass", "M": 1}},
        {"vehicle": [{"model": "mass", "M": 1, "count": 0, "spacing": 1}]},
        {"load": [{"force": 1}]},
    ],
)
def test_both_refuse(tmp_path: Path, change: dict[str, Any]) -> None:
    right: dict[str, Any] = {
        "v": 1,
        "track": {"model": "string", "T": 1, "m": 1, "k": 1, "c": 1},
        "vehicle": [{"model": "mass", "M": 1}],
    }
    assert errors(right, SCHEMA) == []
    assert errors(right | change, SCHEMA) != []
    file = tmp_path / "x.toml"
    file.write_text(_toml(right), "utf-8")
    read_problem(file)
    if None not in change.values():
        file.write_text(_toml(right | change), "utf-8")
        with pytest.raises(InputError):
            read_problem(file)


def _toml(table: dict[str, Any]) -> str:
    return "\n".join(f"{key} = {_value(value)}" for key, value in table.items())


def _value(value: Any) -> str:
    if isinstance(value, dict):
        return "{" + ", ".join(f"{key} = {_value(inner)}" for key, inner in value.items()) + "}"
    if isinstance(value, list):
        return "[" + ", ".join(map(_value, value)) + "]"
    return f'"{value}"' if isinstance(value, str) else str(value)
