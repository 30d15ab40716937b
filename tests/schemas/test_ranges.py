"""Answers over ranges fit their schemas."""

from __future__ import annotations

import json
import tomllib
from pathlib import Path
from typing import Any

import pytest
from schema_check import errors
from schema_outputs import EXAMPLES, checked, refused_mutants, run

from mpsolve import Case, cut_points, sensitivity
from mpsolve.schemas.catalogue import schema_of

HEAVY = Case(alpha="0.5", eta_b=0, eta_m=(40, 40), positions=(0, "0.5"))


@pytest.mark.parametrize("name", ["onset", "unstable_ranges", "crossings", "lines", "worst", "robust", "chart"])
def test_outputs_fit(name: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)
    checked(name)


def test_a_range_without_end_fits(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)
    Path("pair.toml").write_text(
        "[dimensionless]\nalpha = 0.9\neta_b = 0.05\neta_m = [1, 1]\npositions = [0, 1.5]\n", "utf-8"
    )
    found = json.loads(run("onset pair.toml --all --over scale.mass=1.. --json"))
    assert errors(found, schema_of("unstable_ranges")) == []
    assert found["ranges"]["scale.mass"]["high"] is found["answer"]["intervals"][0]["end"] is None


@pytest.mark.parametrize(
    ("name", "answer"),
    [
        ("sensitivity", lambda: sensitivity(HEAVY, check=False)),
        ("cut_points", lambda: cut_points(HEAVY, over={"v": ("0.7", "0.8")})),
    ],
)  # fmt: skip
def test_answers_of_the_library_fit(name: str, answer: Any) -> None:
    found = json.loads(answer().to_json())
    assert errors(found, schema_of(name)) == []
    refused_mutants(found, schema_of(name))
    (first, *_) = found["roots" if name == "sensitivity" else "points"]
    assert name != "sensitivity" or "v" in first["by"]


def test_outputs_fit_tables(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)
    checked("table")


@pytest.mark.parametrize(("pattern", "name"), [("rail_table.toml", "table-file"), ("onset_table.toml", "table-file")])
def test_files_that_ask_fit(pattern: str, name: str) -> None:
    for file in sorted(EXAMPLES.glob(pattern)):
        content = tomllib.loads(file.read_text("utf-8"))
        assert errors(content, schema_of(name)) == [], file
        assert errors(content | {"colour": "blue"}, schema_of(name))
        assert errors({key: value for key, value in content.items() if key in ("title", "problem")}, schema_of(name))
