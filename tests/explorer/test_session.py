"""A session shows what its problem says, and finds its way back."""

from __future__ import annotations

import time
from pathlib import Path

import pytest

from mpsolve import InputError, Problem, read_problem, tracks, vehicles
from mpsolve.explorer.session import Session
from mpsolve.presets.written import names, problem_of

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


def test_what_is_left_out_comes_and_goes_and_the_file_and_the_proof_follow(tmp_path: Path) -> None:
    session, path, body = Session.of(PROBLEM, "bogie"), "vehicles[0].k_contact", "vehicles[0].body"
    assert list(session.fields())[-1] == body
    assert session.fields()[body] is None
    session.change(path, "")
    assert session.fields()[path] is None
    session.change(path, "2 MN/mm")
    assert session.parameters()[path] == 2 * 10**9
    session.change(path, "")
    for given in ("again.toml", "with.toml"):
        copy = tmp_path / given
        copy.write_text(session.toml(), encoding="utf-8")
        assert read_problem(copy).problem == session.problem
        session.undo()  # the spring is there again
    session.redo()
    session.redo()
    assert session.fields()[path] is None
    proving = session.start_proof()
    session.stop_proof()
    assert proving.problem == session.problem


def test_undo_forgets_what_waits() -> None:
    session, body = Session.of(PROBLEM), "vehicles[0].body"
    with pytest.raises(InputError):
        session.change(body, "5 t")
    session.undo()
    session.change("vehicles[0].k2", "0")
    assert session.problem == PROBLEM
    assert session.waiting.values == {}


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


BARE = {
    "rayleigh": tracks.Rayleigh(EI="6.4e6", m=60, k="1e6", c=770, J="0.24"),
    "timoshenko": tracks.Timoshenko(EI="6.4e6", m=60, k="1e6", c=770, J="0.24", S="4e8"),
}
TRACKS = [*BARE, *(name for name in names("track") if name not in ("embankment", "paper"))]


def track_of(name: str) -> object:
    return BARE[name] if name in BARE else problem_of(name)[0].track


def test_every_track_is_among_them() -> None:
    assert {type(track_of(name)) for name in TRACKS} == set(tracks.CATALOGUE)


@pytest.mark.parametrize("name", TRACKS)
def test_a_change_under_two_contacts_takes_less_than_a_tenth_of_a_second(name: str) -> None:
    """Of the processor, the best of ten: what a slider asks for at each move, pictures included."""
    pair = vehicles.train(vehicles.Mass(8 if name == "contact-wire" else 1000), 2, "2.5")
    session, taken = Session.of(Problem(track_of(name), pair, v=20)), []
    for k in range(10):
        start = time.process_time()
        session.nudge("v", 21 + k)
        session.plane(), session.shape(), session.verdict(), session.chart_picture()
        taken.append(time.process_time() - start)
    assert min(taken) < 0.1


def test_a_quick_look_is_followed_by_a_thorough_one() -> None:
    session = Session.of(PROBLEM)
    session.nudge("v", 1400)
    assert session.quick
    assert session.settle()
    assert not session.quick
    assert session.view is not None
    assert session.view.growing == 4
    assert not session.settle()


def test_a_chart_of_another_kind_of_problem_is_not_shown() -> None:
    session = Session.of(PROBLEM)
    assert session.chart_axes() is None
    session.draw_chart("v", "vehicles[0].wheel")
    assert session.chart_axes() == ("v", "vehicles[0].wheel")
    session.open(*problem_of("paper"))
    assert session.chart_axes() is None
    assert session.chart_picture() == ""
    session.undo()
    assert session.chart_picture().startswith("<svg")
