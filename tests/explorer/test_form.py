"""The form keeps the last change of each parameter; what it sets itself is no change."""

from __future__ import annotations

from typing import Any

import pytest

from mpsolve import read_problem
from mpsolve.explorer.session import Session

pytest.importorskip("nicegui", reason="the extra `explore` is not installed")

from mpsolve.explorer.form import Form, _told, key


class Told:
    """In place of a field or a slider: what it was set to."""

    def __init__(self, then: Any = lambda _: None) -> None:
        self.value, self.then = None, then

    def set_value(self, value: Any) -> None:
        self.value = value
        self.then(value)


@pytest.fixture
def form() -> Form:
    """A form without a page."""
    made = object.__new__(Form)
    made.session = Session.of(read_problem("examples/two_layer_bogie.toml").problem)
    made.pending, made.fields, made.slid, made.edited, made.setting = {}, {}, set(), set(), ""
    from mpsolve.explorer.knobs import knobs

    made.knobs = knobs(made.session.problem, made.session.parameters())
    return made


def test_the_last_change_counts(form: Form) -> None:
    form.typed("v", "12,5")
    form.moved("v", 100.0)
    form.typed("track.m", "70")
    assert form.taken() == {"v": "1000", "track.m": "70"}  # from 100 m/s
    assert form.taken() == {}


def test_a_slider_that_follows_a_field_changes_nothing(form: Form) -> None:
    entry, slider = Told(), Told(lambda position: form.moved("v", position))
    form.fields["v"] = (entry, slider)
    form.typed("v", "200")
    for path, value in form.taken().items():
        form.session.nudge(path, value)
        form.follow(path)
    assert (entry.value, slider.value, form.pending) == ("200", 30, {})


def test_a_field_that_is_typed_in_is_not_overwritten(form: Form) -> None:
    entry = Told(lambda _: form.editing("v"))
    form.fields["v"] = (entry, Told())
    form.session.nudge("v", "200")
    form.editing("v")  # the next value is on its way
    form.follow("v")
    assert entry.value is None
    form.typed("v", "300")
    form.follow("v")
    assert entry.value is None
    for path, value in form.taken().items():
        form.session.nudge(path, value)
        form.follow(path)
    assert entry.value == "300"
    assert not form.edited


def test_what_is_left_out_has_an_empty_field(form: Form) -> None:
    path = "vehicles[0].k_contact"
    form.fields[path] = (entry, slider) = (Told(), Told())
    form.session.change(path, "")
    form.follow(path)
    assert (entry.value, slider.value) == ("", None)


def test_names() -> None:
    assert [_told(part) for part in ("v", "track", "vehicles[1]", "gap[0]")] == [
        "Velocity",
        "Track",
        "Vehicle 1",
        "Gap 0",
    ]
    assert key("vehicles[0].bogie.k") == "vehicles-0-bogie-k"
