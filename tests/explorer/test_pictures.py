"""Pictures are well formed, and marks stand where the numbers are."""

from __future__ import annotations

import xml.etree.ElementTree as ET

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from mpsolve import read_problem
from mpsolve.explorer.live import View, Window
from mpsolve.explorer.pictures import moving_shape, plane, ticks

PROBLEM = read_problem("examples/two_layer_bogie.toml").problem


@given(st.floats(-1e6, 1e6), st.floats(1e-3, 1e6))
def test_ticks_are_few_round_and_inside(a: float, width: float) -> None:
    found = ticks(a, a + width)
    assert 1 <= len(found) <= 7
    assert all(a - 1e-6 * width <= t <= a + 1.000001 * width for t in found)


def test_growing_roots_are_squares_at_their_places() -> None:
    view = View(PROBLEM, Window(100.0, 10.0, 10.0), np.array([50 + 5j, -50 - 5j]), (np.array([0j, 100 + 8j]),))
    tree = ET.fromstring(plane(view, chosen=1))
    (circle,) = [e for e in tree.iter("circle") if e.get("class") == "root"]
    (square,) = [e for e in tree.iter("rect") if e.get("class") == "root unstable"]
    frame = next(e for e in tree.iter("rect") if e.get("class") == "frame")
    left, top, wide, high = (float(frame.attrib[k]) for k in ("x", "y", "width", "height"))
    assert float(circle.attrib["cx"]) == pytest.approx(left + 0.75 * wide, abs=0.1)
    assert float(circle.attrib["cy"]) == pytest.approx(top + 0.25 * high, abs=0.1)
    assert float(square.attrib["y"]) + 6 == pytest.approx(top + 0.75 * high, abs=0.1)
    assert "1 of them grow" in tree.attrib["aria-label"]


def test_the_shape_moves_through_one_period() -> None:
    x = np.linspace(-3, 3, 31)
    tree = ET.fromstring(moving_shape(x, np.exp(-np.abs(x)) * (1 + 1j), [0.0], {"a <b>": 1 + 0j}, 2.0))
    (rail,) = [e for e in tree.iter("polyline") if e.get("class") == "rail"]
    frames = rail[0].attrib["values"].split(";")
    assert frames[0] == frames[-1] == rail.attrib["points"]
    assert len(set(frames)) > 10
    assert any(e.text == "a <b>" for e in tree.iter("text"))
