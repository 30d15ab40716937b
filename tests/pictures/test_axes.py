"""Axes: round ticks, and points where their numbers are."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from mpsolve.pictures.axes import BOTTOM, HIGH, LEFT, TOP, WIDE, Axes, line, ticks


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
