"""What README and the site show of own tracks and vehicles runs as it stands."""

from __future__ import annotations

import re
from pathlib import Path
from typing import Any

import pytest

from mpsolve import tracks, vehicles
from mpsolve.problem.inputfile import read_problem

ROOT = Path(__file__).parents[1]
README = (ROOT / "README.md").read_text("utf-8")


def test_the_models_of_readme(capsys: pytest.CaptureFixture[str]) -> None:
    _, code = re.findall(r"```python\n(.*?)```", README, flags=re.DOTALL)
    exec(code, {})
    (said,) = re.findall(r"\.stable\)  # (\w+)", code)
    assert capsys.readouterr().out == f"{said}\n"


def test_the_own_track() -> None:
    section = (ROOT / "docs/how-to/own-track.md").read_text("utf-8")
    code = re.findall(r"```{code-cell} ipython3\n(.*?)```", section, flags=re.DOTALL)[0]
    names: dict[str, object] = {}
    exec(code, names)
    assert names["answer"].problem.pencil.places == (0, 2.5, 5)
    for path in re.findall(r"`(mpsolve/[\w/.]+)`", section):
        assert (ROOT / path).exists()


def cells(name: str) -> list[str]:
    """The code of a page, cell by cell."""
    text = (ROOT / "docs/how-to" / name).read_text("utf-8")
    return re.findall(r"```{code-cell} ipython3\n(.*?)```", text, flags=re.DOTALL)


def test_an_own_track_that_cannot_be_is_named(capsys: pytest.CaptureFixture[str]) -> None:
    names: dict[str, object] = {}
    _, refused = cells("own-track.md")
    exec("from sympy import I, symbols\nfrom mpsolve import tracks\np, Omega = symbols('p Omega')\n" + refused, names)
    assert "buckles by itself at p = 2.44949" in capsys.readouterr().out  # the least of y²/4 − 3y + 1: y = 6


def test_the_own_vehicle() -> None:
    """The code of the page runs, and its answers are proved."""
    names: dict[str, Any] = {}
    (code,) = cells("own-vehicle.md")
    exec(code, names)
    assert names["with_absorber"].proved
    assert names["without"].proved
    assert (names["with_absorber"].stable, len(names["vehicle"].pencil.M)) == (True, 2)


def test_the_guide_takes_a_page() -> None:
    for name in ("own-track.md", "own-vehicle.md"):
        assert len((ROOT / "docs/how-to" / name).read_text("utf-8").splitlines()) <= 60
        assert f"docs/how-to/{name}" in README


def test_every_model_of_an_input_file_is_named() -> None:
    shown = (ROOT / "docs/reference/input.md").read_text("utf-8").split("## Masses on one beam")[0]
    assert all(model.name in shown for model in (*tracks.CATALOGUE, *vehicles.CATALOGUE))
    assert read_problem(ROOT / re.findall(r"`(examples/\w+\.toml)`", shown)[0]).problem
