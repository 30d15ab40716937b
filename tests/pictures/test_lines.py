"""Curves with marks: names do not lie over each other, and what is beyond the model is grey."""

from __future__ import annotations

import xml.etree.ElementTree as ET

import numpy as np

from mpsolve.pictures.lines import Curve, Mark, lines_picture


def drawn(**more: object) -> ET.Element:
    x = np.linspace(0, 10, 41)
    curves = [Curve(x, np.sin(x) * 1e-3 + k * 1e-6, f"wheel {k}", beyond=4.0 if k == 0 else None) for k in range(5)]
    return ET.fromstring(lines_picture(curves, "t, s", "w, m", "Motion", name="m", **more))  # type: ignore[arg-type]


def test_names_keep_apart() -> None:
    ys = sorted(float(e.attrib["y"]) for e in drawn().iter("text") if (e.text or "").startswith("wheel"))
    assert len(ys) == 5
    assert min(np.diff(ys)) > 13.9


def test_what_is_beyond_is_grey() -> None:
    grey = [e for e in drawn().iter("polyline") if "beyond" in e.attrib["class"]]
    assert len(grey) == 1


def test_marks_outside_are_left_out() -> None:
    tree = drawn(marks=[Mark(5.0, "onset"), Mark(50.0, "far")], grows_above=0.0)
    said = [e.text for e in tree.iter("text")]
    assert "onset" in said
    assert "far" not in said
    assert "grows" in said
