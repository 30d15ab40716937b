"""A chart shades what grows, hatches what is open, and marks the case without hiding it."""

from __future__ import annotations

import re
import xml.etree.ElementTree as ET

import numpy as np
import pytest

from mpsolve.pictures.axes import BOTTOM, HIGH, LEFT, RIGHT, TOP, WIDE
from mpsolve.pictures.chart import Border, Sure, chart_picture


def test_areas_are_those_of_the_counts() -> None:
    counts = np.zeros((11, 5), int)
    counts[6:, :] = 2
    counts[0, 0] = -1
    tree = ET.fromstring(chart_picture(np.arange(11), np.arange(5), counts, "v", "m", "Chart", here=(3.0, 2.0)))
    (shaded,) = [e.attrib["d"] for e in tree.iter("path") if e.get("class") == "area some"]
    widths = [float(w) for w in re.findall(r"h(\d[\d.]*)", shaded)]
    assert widths == pytest.approx([0.45 * (WIDE - LEFT - RIGHT)] * 5, rel=0.01)
    (dotted,) = [e.attrib["d"] for e in tree.iter("path") if e.get("fill") == "url(#chart-open)"]
    assert dotted.count("M") == 1
    said = [e.text for e in tree.iter("text")]
    assert {"blank: none grows", "dotted: open", "hatched: 2 roots grow", "this case"} <= set(said)


def test_kinds_differ_without_colour_and_are_parted_by_a_line() -> None:
    counts = np.array([[0, 1, 2], [4, 4, -1]])
    tree = ET.fromstring(chart_picture([0, 1], [0, 1, 2], counts, "v", "m", "Chart"))
    assert {e.get("fill") for e in tree.iter("path") if "area" in e.get("class", "")} == {
        "url(#chart-some)", "url(#chart-many)", "url(#chart-open)"
    }  # fmt: skip
    (border,) = [e.attrib["d"] for e in tree.iter("path") if e.get("class") == "border"]
    assert (border.count("V"), border.count("H")) == (3, 2)


def test_the_legend_stands_below_everything() -> None:
    tree = ET.fromstring(chart_picture([0, 1], [0, 1], np.array([[0, 1], [2, 3]]), "v", "m", "Chart"))
    title = max(float(e.attrib["y"]) for e in tree.iter("text") if e.text == "v")
    words = [e for e in tree.iter("text") if (e.text or "").split(":")[0] in ("blank", "hatched", "crossed")]
    assert len(words) == 3
    assert all(title < float(e.attrib["y"]) - 10 for e in words)
    assert max(float(e.attrib["y"]) for e in words) < float(tree.attrib["viewBox"].split()[-1])


def test_what_is_proved_is_outlined_within_the_frame() -> None:
    sure = [Sure((2, 4), (-9, 9)), Sure((1, 7), (2, 2))]
    tree = ET.fromstring(chart_picture(np.arange(11), np.arange(5), np.zeros((11, 5), int), "v", "m", "C", sure=sure))
    found = [e.attrib["d"] for e in tree.iter("path") if e.get("class") == "sure"]
    wide, high = zip(*(map(float, re.findall(r"[hv]([\d.]+)", d)[:2]) for d in found), strict=True)
    assert np.array(wide) / (WIDE - LEFT - RIGHT) * 10 == pytest.approx([2, 6], rel=0.01)
    assert high == pytest.approx([HIGH - TOP - BOTTOM, 0], abs=0.2)


def test_proved_curves_take_the_place_of_lines_between_cells() -> None:
    counts = np.array([[0, 0], [2, 2]])
    curves = [Border([1, 1.2], [0, 2]), Border([0.5, 0.5], [0, 2], at_zero=True)]
    tree = ET.fromstring(chart_picture([0, 1, 2], [0, 1, 2], counts, "v", "m", "Chart", boundaries=curves))
    assert not [e for e in tree.iter("path") if e.get("class") == "border"]
    first, second = [e for e in tree.iter("polyline") if "boundary" in e.get("class", "")]
    x, y = first.attrib["points"].split()[0].split(",")
    assert float(x) == pytest.approx(LEFT + 0.5 * (WIDE - LEFT - RIGHT), abs=0.1)
    assert float(y) == pytest.approx(HIGH - BOTTOM, abs=0.1)
    assert second.get("class") == "boundary zero"
    said = {(e.text or "").split(":")[0] for e in tree.iter("text")}
    assert {"line", "dashed line"} <= said


def test_points_and_numbers_stand_where_they_belong() -> None:
    counts = np.array([[0, 0], [2, 2]])
    picture = chart_picture(
        [0, 1, 2], [0, 1, 2], counts, "v", "m", "C", meetings=[(1.0, 1.0, "two pairs")], numbers=[(1.5, 1.0, 2)]
    )
    tree = ET.fromstring(picture)
    marks = [e for e in tree.iter("circle") if e.get("class") == "point"]
    middle = LEFT + (WIDE - LEFT - RIGHT) / 2
    assert float(marks[0].attrib["cx"]) == pytest.approx(middle, abs=0.1)
    assert len(marks) == 2  # and one in the legend
    (number,) = [e for e in tree.iter("text") if e.text == "2" and e.get("class") == "halo"]
    assert float(number.attrib["x"]) > middle
    assert "circle" in {(e.text or "").split(":")[0] for e in tree.iter("text")}
