"""Small studies for all tests here."""

from __future__ import annotations

from typing import Any

import pytest

from mpsolve.studies.blocks import Block
from mpsolve.studies.spec import read_spec


@pytest.fixture
def certified() -> dict[str, Any]:
    """Four certified cases of one mass, the last of which buckles."""
    parameters = {"alpha": ["0.5", "1.1"], "eta_b": "0.05", "eta_m": 40, "eta_n": [0, 1]}
    return {"study": {"kind": "certified", "masses": 1}, "parameters": parameters}


@pytest.fixture
def wide() -> dict[str, Any]:
    """A study with so many blocks that tests never come to its end."""
    parameters = {"alpha": {"start": 0, "stop": 1, "step": "0.0001"}, "eta_b": "0.05", "eta_m": 40}
    return {"study": {"kind": "certified", "masses": 1}, "parameters": parameters}


@pytest.fixture
def block(wide: dict[str, Any]) -> Any:
    """Blocks of the study `wide` that hold bytes instead of results, for tests of the store."""
    assert read_spec(wide).blocks == 10_001

    def make(number: int, size: int = 1000) -> Block:
        return Block(number, f"key {number}", bytes([number % 256]) * size, 2, '{"proved": 1}').sealed

    return make
