"""The explorer begins with a file or with a preset."""

from __future__ import annotations

from pathlib import Path

import pytest

from mpsolve import InputError
from mpsolve.explorer.begin import begun, problem_of


def test_a_file_and_a_preset() -> None:
    problem, title = begun(Path("examples/two_layer_bogie.toml"))
    assert problem.v == 100
    assert "bogie" in title
    assert begun(None)[0].track.parameters


def test_a_file_that_is_none(tmp_path: Path) -> None:
    with pytest.raises(InputError):
        begun(tmp_path / "none.toml")


def test_a_preset_with_another_vehicle() -> None:
    usual, other = problem_of("ballasted")[0], problem_of("ballasted", "shinkansen")[0]
    assert usual.track == other.track
    assert usual.pencil.M != other.pencil.M
