"""Axes: round ticks, and points where their numbers are."""

from __future__ import annotations

import re
from xml.etree import ElementTree

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from mpsolve.pictures.axes import (
    BOTTOM,
    HIGH,
    LEFT,
    STYLE,
    TOP,
    WIDE,
    Axes,
    alone,
    box,
    curve_class,
    line,
    plain,
    svg,
    ticks,
)


@given(st.floats(-1e6, 1e6), st.floats(1e-3, 1e6))
def test_ticks_are_few_round_and_inside(a: float, width: float) -> None:
    found = ticks(a, a + width)
    assert 1 <= len(found) <= 7
    assert all(a - 1e-6 * width <= t <= a + 1.000001 * width for t in found)


def test_corners() -> None:
    axes = Axes((0.0, 2.0), (-1.0, 1.0))
    assert float(axes.px(0)) == LEFT
    assert float(axes.py(-1)) == HIGH - BOTTOM
    assert float(axes.py(1)) == TOP
    assert LEFT < float(axes.px(2)) < WIDE


def test_a_line_is_broken_where_a_point_is_missing() -> None:
    axes = Axes((0.0, 5.0), (0.0, 1.0))
    x = np.arange(6.0)
    y = np.array([0, 1, np.nan, 0.5, 0.5, 0.5])
    said = line(axes, x, y, "curve")
    assert said.count("<polyline") == 2
    assert "nan" not in said
    assert pytest.approx(float(axes.px(3)), abs=0.05) == float(said.split('points="')[2].split(",")[0])


def test_curves_differ_in_grey_too() -> None:
    """Four curves of a picture have four kinds of dashes; roots that grow have another form than those that decay."""
    dashes = {}
    for k in range(4):
        for name in curve_class(k).split():
            found = re.search(rf"\.picture \.{name} \{{[^}}]*stroke-dasharray: ([^;}}]*)", STYLE)
            dashes[k] = found[1] if found else dashes.get(k, "none")
    assert len(set(dashes.values())) == 4


def test_a_picture_alone_is_seen_in_programs_that_know_no_variables() -> None:
    """Office programs and converters drew nothing of it, or black on black: colours were variables of CSS."""
    said = alone(svg([box(1, 2, 3, 4)], "A box"))
    ElementTree.fromstring(said)
    for unknown in ("var(", "currentColor", "Canvas", "paint-order"):
        assert unknown in STYLE
        assert unknown not in said
    assert "stroke: #0072b2" in plain()
    assert "stroke: #123456" in plain({"--blue": "#123456"})
    assert set(re.findall(r"#\w+", plain())) == {one for one in re.findall(r"#\w+", plain()) if len(one) in (4, 7)}
