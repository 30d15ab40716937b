"""Certificates fit their schemas, those that are committed and those that are written now."""

from __future__ import annotations

import json
from pathlib import Path

import pytest
from schema_check import errors
from schema_outputs import ROOT, checked, refused_mutants, run

from mpsolve.schemas.catalogue import schema_of


@pytest.mark.parametrize("name", ["certificate", "zeros-certificate"])
def test_outputs_fit(name: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)
    checked(name)


COMMITTED = sorted(file for place in (".", "ranges", "roots") for file in (ROOT / "certs" / place).glob("*.json"))


@pytest.mark.parametrize("file", COMMITTED, ids=lambda file: file.stem)
def test_committed_certificates_fit(file: Path) -> None:
    content = json.loads(file.read_text("utf-8"))
    name = "ranges-certificate" if content["kind"] in ("crossings", "stable", "chart") else "certificate"
    if file.parent.name == "roots":
        name = "zeros-certificate"
    assert errors(content, schema_of(name)) == []
    refused_mutants(content, schema_of(name))


def test_zeros_on_an_interval_and_with_a_cut_fit(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)
    run("roots z^2-2 --real -3 3 -o real.json")
    run("roots sqrt(z)-1/2 --rectangle -3 3 -2 2 --cut 0 0 -1 0 -o cut.json")
    for file in ("real.json", "cut.json"):
        assert errors(json.loads(Path(file).read_text("ascii")), schema_of("zeros-certificate")) == []
