"""The plane: marks stand where the numbers are, and tell growth from decay by their form."""

from __future__ import annotations

import xml.etree.ElementTree as ET

import numpy as np
import pytest

from mpsolve.pictures.plane import plane_picture


def test_growing_roots_are_squares_at_their_places() -> None:
    roots, cuts = np.array([50 + 5j, -50 - 5j]), (np.array([0j, 100 + 8j]),)
    tree = ET.fromstring(plane_picture(roots, cuts, 100.0, 10.0, 10.0, chosen=1))
    (circle,) = [e for e in tree.iter("circle") if e.get("class") == "root"]
    (square,) = [e for e in tree.iter("rect") if e.get("class") == "root unstable"]
    frame = next(e for e in tree.iter("rect") if e.get("class") == "frame")
    left, top, wide, high = (float(frame.attrib[k]) for k in ("x", "y", "width", "height"))
    assert float(circle.attrib["cx"]) == pytest.approx(left + 0.75 * wide, abs=0.1)
    assert float(circle.attrib["cy"]) == pytest.approx(top + 0.25 * high, abs=0.1)
    assert float(square.attrib["y"]) + 6 == pytest.approx(top + 0.75 * high, abs=0.1)
    assert "1 of them grow" in tree.attrib["aria-label"]


def test_a_number_covers_no_mark() -> None:
    roots = np.array([11 + 0.6j, -11 + 0.6j, 51 + 12.7j, -51 + 12.7j])
    tree = ET.fromstring(plane_picture(roots, (), 450.0, 40.0, 160.0, numbers=("1", "", "2", "")))
    marks = [(float(e.attrib["cx"]), float(e.attrib["cy"])) for e in tree.iter("circle") if e.get("class") == "root"]
    words = [e for e in tree.iter("text") if e.text in ("1", "2") and "halo" in e.get("class", "")]
    assert len(words) == 2
    for e in words:
        x, y = float(e.attrib["x"]) + 4, float(e.attrib["y"]) - 4
        assert all(abs(x - a) > 9 or abs(y - b) > 9 for a, b in marks)
