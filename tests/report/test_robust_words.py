"""A chart is told with its regions and its curves."""

from __future__ import annotations

from fractions import Fraction

import numpy as np

from mpsolve.outcome import Status
from mpsolve.ranges.boundary import Boundary
from mpsolve.ranges.chart import Chart, Part
from mpsolve.report.robust_words import _chart, _chart_verdict


def chart(traced: bool) -> Chart:
    edges = (Fraction(0), Fraction(1), Fraction(2))
    curves = tuple(
        Boundary(np.arange(3.0), np.arange(3.0), np.ones(3), zero, not zero, (0, 0)) for zero in (True, False)
    )
    detail = np.array([[0, 0], [-1, 2]])
    parts = (Part(2, {}, 0), Part(1, {}, 2))
    more = {"parts": parts, "boundaries": curves, "traced": traced, "detail": detail}
    return Chart(None, {}, Status.UNVERIFIED, x=edges, y=edges, counts=detail, **more)


class Nothing:
    overs = ()


def test_what_runs_between_the_regions() -> None:
    assert (
        _chart_verdict(chart(True)) == "75 % of the chart is decided, in 2 regions; proved curves run between them."
    )
    assert "in strips the number may change" in _chart_verdict(chart(False))


def test_each_region_and_each_curve_has_a_line() -> None:
    said = "\n".join(_chart(chart(True), Nothing()))
    assert ": 50 % of the chart" in said
    assert said.count("a boundary, proved through 3 points") == 2
    assert "divergence); it could not be followed further" in said
    assert said.endswith("strips round the boundaries: 25 % of the chart")
