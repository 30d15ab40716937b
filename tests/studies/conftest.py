"""Small studies for all tests here."""

from __future__ import annotations

from typing import Any

import pytest

from mpsolve import Study, study
from mpsolve.studies.blocks import Block, Result, pack
from mpsolve.studies.spec import read_spec

MASS: dict[str, Any] = {"alpha": "0.5", "eta_b": "0.05", "eta_m": [40], "positions": [0]}


PAIR: dict[str, Any] = {"alpha": "0.67", "eta_b": "0.05", "eta_m": [70, 70], "positions": [0, "1.5"]}
SPECS: dict[str, dict[str, Any]] = {
    "certified": {
        "study": {"kind": "certified", "digits": 25, "region": "sheet"},
        "dimensionless": PAIR,
        "parameters": {"vehicles.M": "70.01", "gap[0]": ["1.4", "1.5"]},
    },
    "float64": {
        "study": {"kind": "float64", "region": "sheet"},
        "dimensionless": PAIR,
        "parameters": {"v": ["0.67", "2/3"], "track.c": ["0.1", 2], "gap[0]": ["1.4", "1.5"]},
    },
    "SI": {
        "study": {"kind": "float64"},
        "v": 100,
        "track": {"model": "euler-bernoulli", "EI": "6.4e6", "m": 60, "k": "1e6", "c": 770},
        "vehicle": [{"model": "mass", "M": 10000, "count": 2, "spacing": "3.4"}],
        "parameters": {"v": [150, 210, 240], "vehicles.M": [8000, 12000]},
    },
}


@pytest.fixture(scope="session", params=SPECS)
def made(request: pytest.FixtureRequest, tmp_path_factory: pytest.TempPathFactory) -> Study:
    spec = SPECS[request.param]
    return study(spec, store=tmp_path_factory.mktemp("study") / "study.sqlite", workers=1)


@pytest.fixture
def certified() -> dict[str, Any]:
    """Four certified entries of one mass, two of which buckle."""
    parameters = {"v": ["0.5", "1.1"], "track.N": [0, 1]}
    return {"study": {"kind": "certified"}, "dimensionless": MASS, "parameters": parameters}


@pytest.fixture
def wide() -> dict[str, Any]:
    """A study with so many blocks that tests never come to its end."""
    parameters = {"v": {"start": 0, "stop": 1, "step": "0.0001"}}
    return {"study": {"kind": "certified"}, "dimensionless": MASS, "parameters": parameters}


@pytest.fixture
def block(wide: dict[str, Any]) -> Any:
    """Blocks of the study `wide` with reasons of some length, for tests of the store."""
    assert read_spec(wide).blocks == 10_001

    def make(number: int, size: int = 1000) -> Block:
        result = Result("proved", chr(97 + number % 26) * size, 2, 0, ())
        return Block(number, f"key {number}", pack([result]), 2, '{"proved": 1}').sealed

    return make
