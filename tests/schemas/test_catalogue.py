"""All schemas have names, addresses and versions, and none is left out."""

from __future__ import annotations

import json
import re
from pathlib import Path
from typing import Any

import pytest
from schema_outputs import OUTPUTS, checked

from mpsolve import InputError
from mpsolve.schemas.catalogue import CATALOGUE, listing, schema_of


def test_certify_fits(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)
    checked("certify")


def keywords(schema: Any) -> None:
    """Each schema has an address that ends in its version, and references that lead somewhere."""
    assert re.fullmatch(r"https://mpsolve\.invalid/[\w-]+/\d+", schema["$id"])
    for target in re.findall(r'"\$ref": "#/\$defs/([^"]*)"', json.dumps(schema)):
        assert target in schema["$defs"]


def test_names_and_versions() -> None:
    ids = []
    for name in CATALOGUE:
        schema = schema_of(name)
        keywords(schema)
        ids.append(schema["$id"])
        assert name in listing()
    assert len(set(ids)) == len(ids)
    with pytest.raises(InputError, match="which is unknown: there are input"):
        schema_of("poem")


def test_no_schema_is_left_out() -> None:
    others = {
        "ranges-certificate",
        "cut_points",
        "sensitivity",
        "study",
        "status",
        "seeds",
        "study-file",
        "table-file",
        "input",
    }
    assert {*OUTPUTS, *others} == set(CATALOGUE)
