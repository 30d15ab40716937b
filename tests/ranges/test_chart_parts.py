"""Parts of a chart: each has the number of the certified point in it, and what is not counted is open."""

from __future__ import annotations

from fractions import Fraction
from itertools import pairwise
from typing import Any

import numpy as np
import pytest
from free_cases import BEAM, PAIR

from mpsolve import Effort, Problem, certify, stability_chart, tracks, vehicles
from mpsolve.outcome import Status
from mpsolve.progress import silent
from mpsolve.ranges import chart_parts
from mpsolve.ranges.cells import BOUNDARY, OPEN
from mpsolve.ranges.chart import Chart
from mpsolve.ranges.chart_parts import _most, counted, point_in
from mpsolve.report.ranges_asked import asked
from mpsolve.report.robust_words import said_of_chart

PROBLEM = Problem(BEAM, PAIR, v="0.9")
OVER = {"v": (Fraction(1, 2), Fraction(1)), "scale.mass": (Fraction(1), Fraction(2))}
EDGES = tuple(tuple(a + (b - a) * Fraction(k, 4) for k in range(5)) for a, b in OVER.values())


def of(fine: Any, spent: int = 0) -> Any:
    detail, effort = np.where(fine > 0, 0, -1), Effort(evaluations=100)
    effort.spend(spent)
    found = counted(PROBLEM, OVER, EDGES, (fine, fine), detail, effort, silent, False)
    return (*found, detail)


def test_parts_are_counted_at_a_point_the_greatest_first(monkeypatch: pytest.MonkeyPatch) -> None:
    fine = np.array([[1, 1, 0, 0], [1, 1, 0, 0], [0, 0, 0, 0], [2, 2, 2, 2]])
    fine[0] = 1
    found, regions, reason, detail = of(fine)
    assert reason is None
    assert [part.cells for part in found] == [6, 4]
    for number, part in enumerate(found):
        where = regions == number
        assert where.sum() == part.cells
        assert (detail[where] == part.roots).all()
        i, j = (int((part.point[path] - a) / (b - a) * 4) for path, (a, b) in OVER.items())
        assert where[i, j]
        point = PROBLEM.changed("v", part.point["v"]).changed("scale.mass", part.point["scale.mass"])
        assert certify(point, region="unstable", check=False).unstable == part.roots
    assert (detail[regions < 0] == -1).all()
    monkeypatch.setattr(chart_parts, "_MOST_PARTS", 1)
    found, regions, reason, detail = of(fine)
    assert (len(found), reason.code) == (1, "parts")
    assert (detail[fine == 2] == OPEN).all()
    assert (regions[fine == 2] == -1).all()


def test_what_effort_does_not_reach_is_open() -> None:
    found, regions, reason, detail = of(np.ones((4, 4), int), 100)
    assert reason is not None
    assert (found[0].roots, found[0].spectrum) == (None, None)
    assert (detail == OPEN).all()
    assert (regions == -1).all()


def test_a_point_is_the_middle_of_an_inner_cell() -> None:
    where = np.zeros((4, 4), bool)
    where[2, 3] = True
    assert point_in(OVER, EDGES, where) == {"v": Fraction(13, 16), "scale.mass": Fraction(15, 8)}


BEAM = tracks.EulerBernoulli(EI="1/4", m=1, k=1)
MASS = Problem(BEAM, vehicles.Mass(10), v="0.9")
PAIR = Problem(BEAM, vehicles.train(vehicles.Mass(10), 2, "1.5"), v="0.9")
STRING = Problem(tracks.String(T=4, m=1, k=1, c="0.1"), vehicles.Mass(10), v="1.3")


def chart(problem: Problem, over: dict[str, Any]) -> Chart:
    return stability_chart(problem, over=over, depth=3, check=False)


def certified(found: Chart, number: int = 6) -> None:
    """Cells chosen at random have the number of a certified point in them."""
    cells = np.argwhere(found.counts >= 0)
    for i, j in np.random.default_rng(1).permutation(cells)[:number]:
        problem: Any = found.problem
        for path, edges, k in zip(found.over, (found.x, found.y), (i, j), strict=True):
            problem = problem.changed(path, edges[k] + (edges[k + 1] - edges[k]) * Fraction(2, 3))
        assert certify(problem, region="unstable", digits=15, check=False).unstable == found.counts[i, j]


@pytest.mark.parametrize("turned", [False, True])
def test_one_mass_slower_and_faster_than_the_cuts_join(turned: bool) -> None:
    """At v = 1, which is inside of a cell."""
    over = {"v": ("0.5", "1.5625"), "scale.mass": ("0.5", 2)}
    found = chart(MASS, dict(reversed(over.items())) if turned else over)
    assert (found.status, found.share) == (Status.UNVERIFIED, 7 / 8)
    along = found.counts if turned else found.counts.T
    edges = found.y if turned else found.x
    expected = [0 if b <= 1 else 2 if a > 1 else BOUNDARY for a, b in pairwise(edges)]
    assert (along == expected).all()
    assert [(part.roots, part.spectrum is None) for part in found.parts] == [(0, True), (2, False)]
    certified(found)
    said = said_of_chart(found, asked(found.problem, "", [f"{path}={a}..{b}" for path, (a, b) in over.items()]))
    assert "of the chart, by a theorem" in said.text
    assert "without certificate" in said.text


def test_a_pair_is_open_where_it_is_faster() -> None:
    found = chart(PAIR, {"v": ("0.5", "1.5"), "scale.mass": ("0.5", 2)})
    assert found.status is Status.UNDECIDED
    assert found.reason is not None
    assert found.reason.code == "undamped"
    assert (found.counts == np.repeat([0, OPEN], 4)[:, None]).all()
    assert found.at("0.7", 1) == 0
    assert found.at("1.2", 1) is None


@pytest.mark.parametrize(
    "over", [{"track.k": ("0.5", 2), "v": ("0.5", "1.2")}, {"track.k": ("0.5", 2), "track.EI": ("0.1", "0.3")}]
)
def test_of_the_track_cells_are_quiet_up_to_the_curve(over: dict[str, Any]) -> None:
    """2 √(EI k) = v² there: nothing is claimed of a cell that it meets."""
    found = chart(MASS, over)
    for i in range(8):
        for j in range(8):
            corner = {"v": Fraction("0.9"), "track.EI": Fraction("0.25")} | {
                path: edges[k + (path == "v")]
                for path, edges, k in zip(over, (found.x, found.y), (i, j), strict=True)
            }
            quiet = 4 * corner["track.EI"] * corner["track.k"] >= corner["v"] ** 4
            assert found.counts[i, j] == (0 if quiet else OPEN)
    certified(found, 4)


def test_charts_that_one_theorem_decides_as_a_whole() -> None:
    over: dict[str, Any] = {"vehicles.M": (1, 2), "scale.mass": ("0.1", 30)}
    found = chart(MASS.changed("v", "1.3"), over)
    assert (found.counts == 2).all()
    certified(found, 2)
    slow = chart(STRING, {"vehicles.M": (1, 2), "v": ("0.1", "1.9")})
    assert (slow.counts == 0).all()
    assert "string" in slow.note
    certified(slow, 3)


def test_boxes_are_to_tell_of_the_rest() -> None:
    edges = [(Fraction(1), Fraction(2))] * 2
    damped = MASS.changed("track.c", "0.1")
    over = {"v": (Fraction(1), Fraction(2)), "scale.mass": (Fraction(1), Fraction(2))}
    assert chart_parts.decided(damped, over, edges) is None


def test_the_greatest_number() -> None:
    assert [_most(lambda m, k=k: m <= k, 5) for k in range(7)] == [0, 1, 2, 3, 4, 5, 5]
