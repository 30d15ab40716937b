"""The findings: each asserts its numbers and is drawn, and what it asserts can fail."""

from __future__ import annotations

import importlib
from pathlib import Path
from typing import Any

import pytest

FOLDER = Path(__file__).parents[2] / "examples" / "findings"
FINDINGS = sorted(path.stem for path in FOLDER.glob("*.py"))
WRONG: dict[str, dict[str, Any]] = {
    "decomposition_planes": {"ONSET": "367.129179177"},
    "passivity_over_damping": {"VELOCITIES": {"0.05": "1.0201285772"}},
    "rail_damping": {"ONSETS": {"0": "191.183147740035"}},
    "rows_of_masses": {"ROWS": {2: "0.737876937094"}},
    "slight_damping": {"COUNTS": {"0.1": (0, 2, 0)}},
    "soft_contact": {"COUNTS": {"1e7": (0, 2, 0, 2, 2)}},
    "sprung_wheel": {"COUNTS": (0, 2, 2, 2)},
    "two_layer_window": {"CRITICAL": ("1243.49036287",)},
}


@pytest.fixture
def load(monkeypatch: pytest.MonkeyPatch) -> Any:
    """Imports a module of the findings as it is when run as a script."""
    monkeypatch.syspath_prepend(str(FOLDER))
    return importlib.import_module


SLOW = {"rows_of_masses", "decomposition_planes"}  # rows are proved in test_examples.py, too, charts in test_chart.py


@pytest.mark.parametrize("name", [pytest.param(n, marks=pytest.mark.slow if n in SLOW else ()) for n in FINDINGS])
def test_its_numbers_are_right_and_drawn(
    name: str, load: Any, monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    module = load(name)
    module.check()
    assert module.visualize(tmp_path / f"{name}.svg").read_text("utf-8").rstrip().endswith("</svg>")
    text = (FOLDER / f"{name}.md").read_text("utf-8").format_map(module.numbers())
    assert "{" not in text
    for key, value in WRONG[name].items():
        monkeypatch.setattr(module, key, value)
    with pytest.raises(AssertionError):
        module.check()


def test_the_list_tells_of_each() -> None:
    text = (FOLDER / "README.md").read_text("utf-8")
    assert all(f"`{name}.py`" in text for name in FINDINGS)
