"""The plane: marks stand where the numbers are, and tell growth from decay by their form."""

from __future__ import annotations

import xml.etree.ElementTree as ET

import numpy as np
import pytest

from mpsolve import Case, certify
from mpsolve.pictures.plane import plane_picture, spectrum_picture


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


def test_a_spectrum_has_its_roots_and_tells_whether_a_cut_is_seen() -> None:
    for eta_b, seen in (("0.05", False), ("0", True)):
        found = certify(Case(alpha="0.67", eta_b=eta_b, eta_m=(70, 70), positions=(0, "1.5")), check=False)
        picture, cut = spectrum_picture(found, "own")
        marks = [e for e in ET.fromstring(picture).iter("g") if "data-root" in e.attrib]
        shown = [complex(float(e.attrib["data-re"]), float(e.attrib["data-im"])) for e in marks]
        assert shown == pytest.approx([complex(root.q.mid()) for root in found.roots], rel=1e-8)
        assert cut is seen
        assert 'id="own-inside"' in picture
