"""Points where curves of a chart meet: float counts all round each of them are those of its kind."""

from __future__ import annotations

import pickle
from itertools import groupby
from typing import Any

import numpy as np
import pytest
from chart_meetings import MEETINGS

from mpsolve import frequencies
from mpsolve.errors import PrecisionError
from mpsolve.ranges.boundary import Boundary
from mpsolve.ranges.chart import Chart, stability_chart
from mpsolve.ranges.meeting import _crossing, meetings
from mpsolve.ranges.scope import checked_over, scope_of

STEPS = {"two pairs": {2, -2}, "pair and divergence": {1, -1, 2, -2}, "pair from q = 0": {1, 2}}
SIDES = {"two pairs": 4, "pair and divergence": 4, "pair from q = 0": 3}


@pytest.fixture(scope="module", params=MEETINGS)
def chart(request: pytest.FixtureRequest) -> tuple[str, Chart]:
    problem, over = MEETINGS[request.param]
    return request.param, stability_chart(problem, over=over, depth=3, check=False)


def floats(chart: Chart, x: Any, y: Any) -> Any:
    """Counts in floats."""
    seen = frequencies(chart.problem, dict(zip(chart.over, (x, y), strict=True)), roots=False)
    assert (seen.status == "ok").all()
    return seen.count


def test_the_point_is_found_and_named(chart: tuple[str, Chart]) -> None:
    kind, found = chart
    assert [one.kind for one in found.meetings] == [kind]
    assert found.traced
    (one,) = found.meetings
    assert all(float(ball.rad()) < 1e-6 for ball in (one.x, one.y, *one.q))
    assert [float(q) > 0 for q in one.q] == {
        "two pairs": [True, True], "pair and divergence": [True, False], "pair from q = 0": [False],
    }[kind]  # fmt: skip
    again = pickle.loads(pickle.dumps(found))
    assert again.meetings[0].x.overlaps(one.x)


def test_counts_all_round_the_point_are_those_of_its_kind(chart: tuple[str, Chart]) -> None:
    """On a small circle, by floats: so many sides, between which so many roots cross."""
    kind, found = chart
    (one,) = found.meetings
    angle = 2 * np.pi * (np.arange(72) + 0.3) / 72
    width = [float(edges[-1] - edges[0]) for edges in (found.x, found.y)]
    x, y = (float(ball.mid()) + 0.02 * w * f(angle)
            for ball, w, f in zip((one.x, one.y), width, (np.cos, np.sin), strict=True))  # fmt: skip
    runs = [count for count, _ in groupby(floats(found, x, y).tolist())]
    runs = runs[1:] if len(runs) > 1 and runs[0] == runs[-1] else runs
    assert len(runs) == SIDES[kind]
    steps = {b - a for a, b in zip(runs, [*runs[1:], runs[0]], strict=True)}
    assert {abs(step) for step in steps} == {abs(step) for step in STEPS[kind]}


def test_every_cell_round_it_has_the_right_number(chart: tuple[str, Chart]) -> None:
    _, found = chart
    rng = np.random.default_rng(2)
    cells = np.argwhere(found.detail >= 0)
    cells = cells[rng.permutation(len(cells))[:150]]
    share = (cells + rng.uniform(size=cells.shape)) / found.detail.shape
    x, y = (float(e[0]) + share[:, k] * float(e[-1] - e[0]) for k, e in enumerate((found.x, found.y)))
    assert (floats(found, x, y) == found.detail[tuple(cells.T)]).all()
    assert len(set(found.detail[found.detail >= 0].tolist())) >= 3


def test_where_nothing_meets_nothing_is_proved(chart: tuple[str, Chart]) -> None:
    """Polygons that cross beside the curves."""
    _, found = chart
    scope = scope_of(found.problem, checked_over(found.problem, found.over))
    (a, b), (c, d) = (tuple(map(float, ends)) for ends in found.over.values())
    x, y = np.array([a + (b - a) / 4, a + (b - a) / 2]), np.array([c + (d - c) / 4, c + (d - c) / 2])
    q = np.array([0.9, 0.9])
    wrong = (Boundary(x, y, q, False, False, (0.0, 0.0)), Boundary(x, y[::-1], q / 2, False, False, (0.0, 0.0)))
    for one in meetings(scope, wrong):  # Newton's method may lead to one that is there
        (true,) = found.meetings
        assert one.x.overlaps(true.x)
        assert one.y.overlaps(true.y)


def test_one_root_is_not_taken_for_two(chart: tuple[str, Chart]) -> None:
    """Any point of a curve fulfils both equations with one root twice: there the zero is not isolated."""
    _, found = chart
    curve = next(one for one in found.boundaries if not one.divergence)
    k = len(curve.x) // 2
    scope = scope_of(found.problem, checked_over(found.problem, found.over))
    units = np.array([float(scope.family.frequency_unit), *map(float, scope.family.units)])
    at = np.array([curve.q[k], curve.q[k], curve.x[k], curve.y[k]]) / units[[0, 0, 1, 2]]
    with pytest.raises(PrecisionError):
        _crossing(scope, at, np.full(4, 2.0**-6))
