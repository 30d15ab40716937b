"""The small paper of these tests, and what an audit of it finds."""

from __future__ import annotations

from pathlib import Path

import pytest

from mpsolve.claims import Paper
from mpsolve.claims.load import audit, load
from mpsolve.claims.report import Report

TOY = Path(__file__).parent / "toy"


@pytest.fixture(scope="session")
def toy() -> Paper:
    return load(TOY)


@pytest.fixture(scope="session")
def toy_report(toy: Paper) -> Report:
    return audit(toy, workers=1)
