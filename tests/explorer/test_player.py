"""A player is one picture with a button and a slider that have names."""

from __future__ import annotations

import re
import xml.etree.ElementTree as ET

import numpy as np
import pytest

from mpsolve import InputError, Problem, read_problem, response, tracks, vehicles
from mpsolve.batch.view import look
from mpsolve.explorer.player import CSS, PLACES, POINTS, motion_pictures, player, root_picture
from mpsolve.explorer.session import Session
from mpsolve.pictures.shape import stretch


def test_a_player_has_controls_and_says_where_the_model_ends() -> None:
    tree = ET.fromstring(player("<svg/>", 2.0, 8.0, 0.5))
    assert [(tree.get(f"data-{name}")) for name in ("lasts", "played", "end")] == ["2", "8", "0.5"]
    assert tree.find("svg") is not None
    assert [e.text for e in tree.iter("button")] == ["Pause"]
    (slider,) = tree.iter("input")
    assert (slider.get("max"), slider.get("aria-label")) == ("2", "Time, s")
    assert ET.fromstring(player("<svg/>", 2.0, 8.0, None)).get("data-end") is None


def test_the_same_colours_in_light_and_in_dark() -> None:
    light, dark = (set(re.findall(r"(--\w+):", part)) for part in re.findall(r"(?::root|body--dark) {([^}]*)}", CSS))
    assert light == dark


def test_every_picture_has_its_size() -> None:
    assert {"#plane", "#shape", "#chart", "#motion", "#moving"} <= set(re.findall(r"(#\w+) svg", CSS))


TRACK = tracks.EulerBernoulli(EI="6.4e6", m=60, k="1e6", c=770)
PAIR = Problem(TRACK, vehicles.train(vehicles.Mass(10000), 2, "3.4"), v=100)


def test_both_pictures_and_the_lift_off() -> None:
    drawn, moving = motion_pictures(PAIR, 1.0)
    assert drawn.count("<svg") == 2
    assert ">lift-off<" in drawn
    assert "beyond" in drawn
    assert ">contact 2<" in drawn
    motion = response(PAIR, times=np.linspace(0, 1, POINTS))
    assert motion.lift_off is not None
    assert motion.lift_off.time < 1
    assert f'data-end="{float(motion.lift_off.time):.6g}"' in moving


def test_the_shape_in_time_is_the_response() -> None:
    """Each frame of the drawn rail is the deflection under its places, in one scale; bodies likewise."""
    tree = ET.fromstring(motion_pictures(PAIR, 0.2)[1])
    (rail,) = [e for e in tree.iter("polyline") if e.get("class") == "rail"]
    frames = np.array([[p.split(",") for p in f.split()] for f in rail[0].attrib["values"].split(";")], float)
    assert frames.shape == (101, PLACES, 2)
    truth = response(PAIR, times=np.linspace(0, 0.2, 101), places=stretch(PAIR, PLACES))
    down = frames[..., 1] - frames[0, :, 1]
    scale = down.max() / truth.rail.max()
    assert scale > 0
    assert np.abs(down - scale * truth.rail.T).max() < 0.11  # px, drawn to a tenth
    boxes = [e for e in tree.iter("rect") if e.get("class") == "body"]
    assert len(boxes) == len(truth.vehicle) == 2
    for box, moved in zip(boxes, truth.vehicle.values(), strict=True):
        ys = np.array(box[0].attrib["values"].split(";"), float)
        assert np.corrcoef(ys, moved)[0, 1] > 0.999


def test_a_session_draws_it_and_says_what_cannot_be() -> None:
    session = Session.of(read_problem("examples/two_layer_bogie.toml").problem)
    assert session.motion == session.moving == ""
    session.draw_motion("0.05 s")
    assert session.motion.count("<svg") == 2
    assert ">lift-off<" not in session.motion
    session.zoom(0.5)
    assert session.motion
    assert "data-end" not in session.moving
    assert session.moving
    session.change("v", 90)
    assert session.motion == session.moving == ""  # it was that of another problem
    for wrong in ("0", "-1", "a while", "3 kg"):
        with pytest.raises(InputError):
            session.draw_motion(wrong)


PROBLEM = read_problem("examples/two_layer_bogie.toml").problem


def test_it_reaches_beyond_the_contacts() -> None:
    x = stretch(PROBLEM, 81)
    assert len(x) == 81
    assert x[0] < min(PROBLEM.pencil.places) < max(PROBLEM.pencil.places) < x[-1]


def test_a_root_moves_rail_and_bodies() -> None:
    drawn = root_picture(PROBLEM, complex(look(PROBLEM).roots[-1]))
    assert drawn.count("<animate") >= 1 + 2 + len(PROBLEM.pencil.names)
