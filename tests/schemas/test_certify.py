"""What certify prints as JSON is as its schema says, whatever the answer."""

from __future__ import annotations

import json
from dataclasses import replace
from typing import Any

import pytest
from flint import acb
from reported import SPRUNG, fast, wire, without_theorem
from schema_check import errors

from mpsolve import Case, Effort, PhysicalCase, Rectangle, certify
from mpsolve.report.spectrum_data import spectrum_data
from mpsolve.schemas.certify import certify_schema

SCHEMA = certify_schema()
RAIL = PhysicalCase(EI="6.4e6", m=60, k="1e6", c=770, v=250, masses=[(10000, 0), (10000, "3.4")])


WARNED = ("unstable", "fast", "undecided")
NAMES = ["a wire", "unstable", "a half-disc", "roots apart", "sprung", "a case", "a rectangle", "fast", "undecided"]


def found(name: str) -> Any:
    case = Case(alpha="0.67", eta_b="0.05", eta_m=(70, 70), positions=(0, "1.5"))
    return {
        "a wire": wire,
        "unstable": fast,
        "a half-disc": without_theorem,
        "roots apart": lambda: replace(wire(), unfelt=(acb(1, 1),), neutral=1),
        "sprung": lambda: certify(SPRUNG, region="unstable", digits=15, check=False),
        "a case": lambda: certify(case, digits=15, check=False),
        "a rectangle": lambda: certify(case, digits=15, region=Rectangle(-1, 1, -1, 0), check=False),
        "fast": lambda: certify(RAIL, region="unstable", digits=15, check=False),
        "undecided": lambda: certify(RAIL, region="unstable", digits=15, effort=Effort(seconds=1e-9), check=False),
    }[name]()


@pytest.mark.parametrize("name", NAMES)
def test_every_kind_of_answer(name: str) -> None:
    spectrum = found(name)
    data = json.loads(json.dumps(spectrum_data(spectrum, "title")))
    assert errors(data, SCHEMA) == []
    assert [warning["code"] for warning in data["warnings"]] == ["velocity-unlikely"] * (name in WARNED)
    assert (data["status"] == "undecided") == (name == "undecided")


def test_what_is_wrong_is_seen() -> None:
    data = spectrum_data(wire())
    for change in ({"count": "2"}, {"roots": [{}]}, {"more": 1}, {"status": "true"}, {"region": {"kind": "half"}}):
        assert errors(data | change, SCHEMA) != []
    assert errors({key: value for key, value in data.items() if key != "verdict"}, SCHEMA) != []
