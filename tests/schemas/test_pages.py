"""The numbers in a page and the verdicts of an audit fit their schemas."""

from __future__ import annotations

from pathlib import Path

import pytest
from schema_outputs import checked


@pytest.mark.parametrize("name", ["page", "audit"])
def test_outputs_fit(name: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)
    checked(name)
