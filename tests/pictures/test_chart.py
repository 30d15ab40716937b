"""A chart shades what grows, hatches what is open, and marks the case without hiding it."""

from __future__ import annotations

import xml.etree.ElementTree as ET

import numpy as np
import pytest

from mpsolve.pictures.axes import LEFT, RIGHT, WIDE
from mpsolve.pictures.chart import chart_picture


def test_areas_are_those_of_the_counts() -> None:
    counts = np.zeros((11, 5), int)
    counts[6:, :] = 2
    counts[0, 0] = -1
    tree = ET.fromstring(chart_picture(np.arange(11), np.arange(5), counts, "v", "m", "Chart", here=(3.0, 2.0)))
    shaded = [e for e in tree.iter("rect") if e.get("class") == "grows"]
    assert len(shaded) == 5
    assert float(shaded[0].attrib["width"]) == pytest.approx(0.45 * (WIDE - LEFT - RIGHT), rel=0.01)
    assert len([e for e in tree.iter("rect") if e.get("fill") == "url(#chart-open)"]) == 1
    said = [e.text for e in tree.iter("text")]
    assert {"blank: stable", "hatched: open", "shaded: 2 roots grow", "this case"} <= set(said)
