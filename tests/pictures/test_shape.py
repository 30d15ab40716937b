"""The shape moves through one period, and names its bodies."""

from __future__ import annotations

import xml.etree.ElementTree as ET

import numpy as np
import pytest

from mpsolve import Problem, response, tracks, vehicles
from mpsolve.pictures.shape import film, moving_shape, numbered, shape_in_time


def test_one_period() -> None:
    x = np.linspace(-3, 3, 31)
    tree = ET.fromstring(moving_shape(x, np.exp(-np.abs(x)) * (1 + 1j), [0.0], {"a <b>": 1 + 0j}, 2.0))
    (rail,) = [e for e in tree.iter("polyline") if e.get("class") == "rail"]
    frames = rail[0].attrib["values"].split(";")
    assert frames[0] == frames[-1] == rail.attrib["points"]
    assert len(set(frames)) > 10
    assert any(e.text == "a <b>" for e in tree.iter("text"))


def test_a_motion_in_time_has_one_scale_for_all_times() -> None:
    x, grows = np.linspace(-3, 3, 31), np.linspace(0, 2, 11)
    drawn = shape_in_time(x, np.outer(grows, np.exp(-np.abs(x))), [0.0], {"a": -grows}, 8.0)
    tree = ET.fromstring(drawn)
    (rail,) = [e for e in tree.iter("polyline") if e.get("class") == "rail"]
    lows = [max(float(p.split(",")[1]) for p in f.split()) for f in rail[0].attrib["values"].split(";")]
    assert np.diff(lows) == pytest.approx([(lows[-1] - lows[0]) / 10] * 10, abs=0.11)
    (box,) = [e for e in tree.iter("rect") if e.get("class") == "body"]
    assert np.all(np.diff(np.array(box[0].attrib["values"].split(";"), float)) < 0)  # up
    assert shape_in_time(x, np.zeros((2, 31)), [0.0], {}, 8.0).startswith("<svg")


def test_many_coordinates_are_numbered() -> None:
    x = np.linspace(-3, 3, 5)
    tree = ET.fromstring(moving_shape(x, np.ones(5), [0.0], {f"body {k}": 1 + 0j for k in range(9)}, 1.0))
    said = [e.text for e in tree.iter("text")]
    assert "9" in said
    assert "body 8" not in said


def test_numbers_stand_for_names_where_there_are_many() -> None:
    assert numbered({"a": 1j}) == ""
    assert numbered(dict.fromkeys(("a", "<b>", "c", "d", "e"), 1j)) == "<p>1: a, 2: &lt;b&gt;, 3: c, 4: d, 5: e</p>"


def test_a_film_moves_the_rail_as_it_was_computed_and_pales_after_the_lift_off() -> None:
    beam = tracks.EulerBernoulli(EI="6.4e6", m=60, k="1e6", c=770)
    pair = Problem(beam, [vehicles.Mass(10_000).at(0), vehicles.Mass(10_000).at("3.4")], v=250)
    found = response(pair, times=np.linspace(0, 1, 41), places=[0, "1.7", "3.4"])
    root = ET.fromstring(film(found, "A & B"))
    space = "{http://www.w3.org/2000/svg}"
    moved = {e.attrib["attributeName"]: e.attrib["values"].split(";") for e in root.iter(f"{space}animate")}
    within = int(found.within.sum())
    assert 0 < within < 41
    heights = [float(frame.split()[1].split(",")[1]) for frame in moved["points"]][:within]
    assert np.corrcoef(heights, found.rail[1, :within])[0, 1] > 0.9999
    assert [colour == "#c8c8c8" for colour in moved["stroke"]] == (~found.within).tolist()
    words = [text.text for text in root.iter(f"{space}text")]
    assert "A & B" in words
    assert any("beyond the model" in (word or "") for word in words)
