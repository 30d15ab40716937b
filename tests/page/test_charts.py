"""The chart of a page: what is proved is on it, at the right place."""

from __future__ import annotations

from dataclasses import replace

import pytest

from mpsolve import read_problem
from mpsolve.page.budget import Part
from mpsolve.page.charts import chart, chart_status, sure_of
from mpsolve.page.parts import NOT_ASKED, Parts, chart_of, gather


@pytest.fixture(scope="module")
def parts() -> Parts:
    source = read_problem("examples/rail_60e1.toml")
    return gather(source.given, "", digits=15, seconds=15, tell=lambda *_: None)


def test_lines_and_a_box_through_the_case(parts: Parts) -> None:
    along, up, box = sure_of(parts, 3.6, 20.0)
    assert along.x == pytest.approx((0, 688.3), abs=0.1)
    assert along.y == (20, 20)
    assert (up.x, up.y) == ((360, 360), (4, 80))
    assert box.x[0] < 360 < box.x[1]
    assert box.y[0] < 20 < box.y[1]


def test_a_proved_chart_and_a_computed_one(parts: Parts) -> None:
    assert chart_status(parts) == "proved"
    drawn = chart(parts)
    assert drawn is not None
    assert "proved, and so are the curves" in drawn.caption
    assert 'class="boundary"' in drawn.svg
    assert parts.chart is NOT_ASKED
    counted = Part("chart", chart_of(parts.problem, parts.top))
    floats = replace(parts, proved_chart=NOT_ASKED, chart=counted)
    assert chart_status(floats) == "computed"
    drawn = chart(floats)
    assert drawn is not None
    assert "computed in floats" in drawn.caption
    assert chart(replace(floats, chart=NOT_ASKED)) is None
