"""Answers over ranges fit their schemas."""

from __future__ import annotations

from pathlib import Path

import pytest
from schema_outputs import checked


@pytest.mark.parametrize("name", ["onset", "unstable_ranges", "crossings", "worst", "robust", "chart"])
def test_outputs_fit(name: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)
    checked(name)
