"""What is drawn of a proved chart: strips beside a proved curve belong to its sides, others stay dotted."""

from __future__ import annotations

from dataclasses import replace
from fractions import Fraction

import numpy as np
import pytest

from mpsolve.numbers.balls import arb
from mpsolve.outcome import Status
from mpsolve.pictures.proved_chart import borders, drawn, ends, numbers, open_words, places
from mpsolve.ranges.boundary import Boundary
from mpsolve.ranges.chart import Chart
from mpsolve.ranges.chart_parts import Part
from mpsolve.ranges.meeting import Meeting

EDGES = tuple(Fraction(k, 4) for k in range(5))


def chart(detail: np.ndarray, traced: bool) -> Chart:
    curve = Boundary(np.array([0.48, 0.48]), np.array([0.0, 1.0]), np.ones(2), False, True, (0.0, 0.0))
    counts = detail[::4, ::4]
    return Chart(
        None,
        {"v": (EDGES[0], EDGES[-1]), "m": (EDGES[0], EDGES[-1])},
        Status.UNVERIFIED,
        x=EDGES,
        y=EDGES,
        counts=counts,
        meetings=(Meeting(arb("0.5"), arb("0.25"), (arb(1), arb(0))),),
        parts=(Part(200, {"v": Fraction(1, 4), "m": Fraction(1, 2)}, 2), Part(1, {"v": EDGES[1], "m": EDGES[1]}, 0)),
        boundaries=(curve,),
        traced=traced,
        detail=detail,
    )


def test_a_strip_is_drawn_as_its_sides_up_to_the_curve_and_other_open_cells_are_not() -> None:
    detail = np.zeros((16, 16), int)
    detail[8:] = 2
    detail[7:9] = -1
    detail[2, 2], detail[14, 14] = -1, -2
    found = drawn(chart(detail, False))
    shares = (np.arange(len(found)) + 0.5) / len(found)
    assert len(found) >= 512
    known = found[:, -1]
    assert (known[shares < 0.479] == 0).all()
    assert (known[shares > 0.481] == 2).all()
    each = len(found) // 16
    assert (found[2 * each : 3 * each, 2 * each : 3 * each] == -1).all()
    assert (found < 0).sum() == 2 * each**2


def test_a_cell_between_areas_that_no_curve_parts_stays_open() -> None:
    detail = np.zeros((16, 16), int)
    detail[8:] = 2
    detail[8] = -1
    assert (drawn(replace(chart(detail, False), boundaries=())) < 0).mean() == 1 / 16
    away = Boundary(np.array([0.6, 0.6]), np.array([0.0, 1.0]), np.ones(2), False, True, (0.0, 0.0))
    found = drawn(replace(chart(detail, False), boundaries=(away,)))
    assert (found < 0).any()


def test_units_and_words() -> None:
    found = chart(np.zeros((16, 16), int), True)
    (one,) = borders(found, (3.6, 2.0))
    assert one.x[0] == pytest.approx(3.6 * 0.48)
    assert one.y[-1] == 2
    assert ends(found.x, 16)[-1] == 1
    assert places(found, (2.0, 4.0)) == [(1.0, 1.0, "pair and divergence")]
    assert numbers(found, (2.0, 4.0)) == [(0.5, 2.0, 2)]
    assert (open_words(found), open_words(chart(found.detail, False))) == (
        "open",
        "not decided, a boundary may run there",
    )
