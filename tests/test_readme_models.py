"""What README and the site show of own tracks and vehicles runs as it stands."""

from __future__ import annotations

import re
from pathlib import Path

from mpsolve import tracks, vehicles
from mpsolve.problem.inputfile import read_problem

ROOT = Path(__file__).parents[1]
README = (ROOT / "README.md").read_text("utf-8")


def test_the_own_track() -> None:
    section = (ROOT / "docs/how-to/own-track.md").read_text("utf-8")
    code = re.findall(r"```{code-cell} ipython3\n(.*?)```", section, flags=re.DOTALL)[0]
    names: dict[str, object] = {}
    exec(code, names)
    assert names["answer"].problem.pencil.places == (0, 2.5, 5)
    for path in re.findall(r"`(mpsolve/[\w/.]+)`", section):
        assert (ROOT / path).exists()


def test_every_model_of_an_input_file_is_named() -> None:
    shown = README.split("Any track and any vehicles")[1].split("The forces have a part")[0]
    assert all(model.name in shown for model in (*tracks.CATALOGUE, *vehicles.CATALOGUE))
    assert read_problem(ROOT / re.findall(r"`(examples/\w+\.toml)`", shown)[0]).problem
