"""Benches are collected only when they are named: `pytest tests/bench -n0 -s`, never by a bare `pytest`."""

from __future__ import annotations

import sys
from pathlib import Path

import pytest

HERE = Path(__file__).parent
sys.path.insert(0, str(HERE))


def pytest_collect_file(file_path: Path, parent: pytest.Collector) -> pytest.Module | None:
    """A file named on the command line is collected by pytest itself."""
    named = any(Path(argument).resolve() == HERE for argument in parent.config.args)
    if named and file_path.match("bench_*.py") and not parent.session.isinitpath(file_path):
        return pytest.Module.from_parent(parent, path=file_path)
    return None
