"""Tables and the files that ask for them fit their schemas."""

from __future__ import annotations

import tomllib
from pathlib import Path

import pytest
from schema_check import errors
from schema_outputs import EXAMPLES, checked

from mpsolve.schemas.catalogue import schema_of


def test_outputs_fit(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)
    checked("table")


@pytest.mark.parametrize(("pattern", "name"), [("rail_table.toml", "table-file"), ("onset_table.toml", "table-file")])
def test_files_that_ask_fit(pattern: str, name: str) -> None:
    for file in sorted(EXAMPLES.glob(pattern)):
        content = tomllib.loads(file.read_text("utf-8"))
        assert errors(content, schema_of(name)) == [], file
        assert errors(content | {"colour": "blue"}, schema_of(name))
        assert errors({key: value for key, value in content.items() if key in ("title", "problem")}, schema_of(name))
