"""A chart is told with its regions and its curves."""

from __future__ import annotations

from dataclasses import replace
from fractions import Fraction
from types import SimpleNamespace

import numpy as np

from mpsolve.numbers.balls import arb
from mpsolve.outcome import Status
from mpsolve.problem.over import Over
from mpsolve.ranges.boundary import Boundary
from mpsolve.ranges.chart import Chart
from mpsolve.ranges.chart_parts import Part
from mpsolve.ranges.meeting import Meeting
from mpsolve.report.ranges_words import trust
from mpsolve.report.robust_words import _chart, _chart_verdict, _what_is_certified


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


def test_why_there_is_no_certificate_is_told() -> None:
    found = replace(chart(True), note="a checker would take too long", proofs=(SimpleNamespace(base=None),))
    assert "the verifier has passed: a checker would take too long." in trust(found)
    assert _what_is_certified(found) == []
    assert "of each cell" in _what_is_certified(replace(found, certificate=object()))[0]


def test_a_region_that_is_not_counted_has_no_certified_point() -> None:
    found = chart(True)
    open_part = replace(found.parts[0], roots=None, spectrum=None)
    other = replace(found.parts[1], spectrum=object())
    said = _chart(replace(found, parts=(open_part, other)), Nothing())
    assert said[1] == "  open: 50 % of the chart"
    assert said[2].startswith("  2 roots grow: 25 % of the chart, certified at")


def test_each_point_where_curves_meet_has_a_line() -> None:
    asked = SimpleNamespace(
        overs=(Over("v", Fraction(0), Fraction(9), "m/s", "km/h"), Over("track.c", Fraction(0), Fraction(9), "", ""))
    )
    points = tuple(Meeting(arb(5), arb("0.5"), tuple(map(arb, q))) for q in ((1, 2), (1, 0), (0,)))
    crossed, at_zero, ended = _chart(replace(chart(True), parts=(), boundaries=(), meetings=points), asked)[1:4]
    assert crossed == "  two boundaries cross, with two pairs of roots real, at v = 18 km/h and track.c = 0.5"
    assert "one of divergence" in at_zero
    assert "as q comes to 0" in ended
