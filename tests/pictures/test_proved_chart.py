"""What is drawn of a proved chart: strips beside a proved curve belong to its sides, others stay dotted."""

from __future__ import annotations

from fractions import Fraction

import numpy as np

from mpsolve.outcome import Status
from mpsolve.pictures.proved_chart import borders, drawn, ends, open_words
from mpsolve.ranges.boundary import Boundary
from mpsolve.ranges.chart import Chart

EDGES = tuple(Fraction(k, 4) for k in range(5))


def chart(detail: np.ndarray, traced: bool) -> Chart:
    curve = Boundary(np.array([0.5, 0.5]), np.array([0.0, 1.0]), np.ones(2), False, True, (0.0, 0.0))
    counts = detail[::4, ::4]
    return Chart(
        None,
        {},
        Status.UNVERIFIED,
        x=EDGES,
        y=EDGES,
        counts=counts,
        boundaries=(curve,),
        traced=traced,
        detail=detail,
    )


def test_the_strip_is_drawn_as_beside_the_curve_and_other_open_cells_are_not() -> None:
    detail = np.zeros((16, 16), int)
    detail[8:] = 2
    detail[7:9] = -1
    detail[2, 2], detail[14, 14] = -1, -2
    found = drawn(chart(detail, False))
    assert set(np.unique(found[6:10])) == {0, 2}
    assert found[2, 2] == found[14, 14] == -1
    assert (found < 0).sum() == 2


def test_units_and_words() -> None:
    found = chart(np.zeros((16, 16), int), True)
    (one,) = borders(found, (3.6, 2.0))
    assert one.x[0] == 1.8
    assert one.y[-1] == 2
    assert ends(found.x, 16)[-1] == 1
    assert (open_words(found), open_words(chart(found.detail, False))) == (
        "open",
        "not decided, a boundary may run there",
    )
