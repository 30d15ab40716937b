"""Motions, receptances, critical velocities, trains and zeros fit their schemas."""

from __future__ import annotations

from pathlib import Path

import pytest
from schema_outputs import checked


@pytest.mark.parametrize("name", ["response", "receptance", "critical", "train", "roots"])
def test_outputs_fit(name: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)
    checked(name)
