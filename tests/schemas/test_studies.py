"""Studies, their files, their progress and seeds fit their schemas."""

from __future__ import annotations

import json
import tomllib
from pathlib import Path

import pytest
from schema_check import errors
from schema_outputs import EXAMPLES, refused_mutants, run

from mpsolve import seeds
from mpsolve.schemas.catalogue import schema_of


def test_studies_fit(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)
    for name in ("study_certified", "study_float64"):
        file = EXAMPLES / f"{name}.toml"
        if name == "study_float64":
            text = file.read_text("utf-8").replace("two_layer_bogie", str(EXAMPLES / "two_layer_bogie"))
            file = tmp_path / "few.toml"
            file.write_text(text.replace("count = 500", "count = 5"), "utf-8")
        run(f"study {file} -o {name}.sqlite --workers 1")
        run(f"export {name}.sqlite --to json")
        found = json.loads(Path(f"{name}.json").read_text("utf-8"))
        assert errors(found, schema_of("study")) == []
        refused_mutants(found, schema_of("study"))
        assert errors(json.loads(run(f"status {name}.sqlite --json")), schema_of("status")) == []


def test_seeds_fit(tmp_path: Path) -> None:
    file = seeds(["0.67"], ["0.05"], [70], ["1.5"]).save(tmp_path / "seeds.json")
    assert errors(json.loads(file.read_text("utf-8")), schema_of("seeds")) == []


@pytest.mark.parametrize(("pattern", "name"), [("study_*.toml", "study-file")])
def test_files_that_ask_fit(pattern: str, name: str) -> None:
    for file in sorted(EXAMPLES.glob(pattern)):
        content = tomllib.loads(file.read_text("utf-8"))
        assert errors(content, schema_of(name)) == [], file
        assert errors(content | {"colour": "blue"}, schema_of(name))
        assert errors({key: value for key, value in content.items() if key in ("title", "problem")}, schema_of(name))
