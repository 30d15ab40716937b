"""A session shows what its problem says, and finds its way back."""

from __future__ import annotations

from pathlib import Path

import pytest

from mpsolve import InputError, read_problem
from mpsolve.explorer.session import Session

PROBLEM = read_problem("examples/two_layer_bogie.toml").problem


def test_changes_units_and_the_way_back() -> None:
    session = Session.of(PROBLEM, "bogie")
    session.change("v", "5040 km/h")
    assert session.problem.v == 1400
    assert session.view is not None
    assert session.view.growing == 4
    assert "grow" in session.verdict()
    assert "not proved" in session.verdict()
    session.undo()
    assert session.problem == PROBLEM
    assert "No growing" in session.verdict()


def test_a_moved_slider_is_one_step() -> None:
    session = Session.of(PROBLEM)
    for v in range(101, 120):
        session.nudge("v", v)
    session.undo()
    assert session.problem == PROBLEM


def test_what_cannot_be_changes_nothing() -> None:
    session = Session.of(PROBLEM)
    with pytest.raises(InputError):
        session.change("v", "-1")
    with pytest.raises(InputError):
        session.change("track.nothing", 1)
    assert session.problem == PROBLEM


def test_the_state_is_a_file_that_reproduces_it(tmp_path: Path) -> None:
    session = Session.of(PROBLEM, "bogie")
    session.change("track.k_pad", "1e8")
    copy = tmp_path / "state.toml"
    copy.write_text(session.toml(), encoding="utf-8")
    again = read_problem(copy)
    assert again.problem == session.problem
    assert again.title == "bogie"


def test_the_chosen_vibration_is_followed() -> None:
    session = Session.of(PROBLEM)
    assert session.view is not None
    session.choose(len(session.view.roots) - 1)
    before = session.view.roots[-1]
    session.change("v", "101")
    assert session.view is not None
    assert session.chosen is not None
    assert abs(session.view.roots[session.chosen] - before) < 0.02 * abs(before)
    assert session.shape().startswith("<svg")
    assert "ring" in session.plane()


def test_zoom() -> None:
    session = Session.of(PROBLEM)
    assert session.view is not None
    width = session.view.window.width
    session.zoom(0.5)
    assert session.view.window.width == width / 2
    session.zoom(None)
    assert session.view.window.width == width
