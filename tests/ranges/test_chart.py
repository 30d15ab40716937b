"""Charts: every cell's number is the certified one, and strips hide no region."""

from __future__ import annotations

from fractions import Fraction
from typing import Any

import numpy as np
import pytest
from chart_counts import floats_agree

from mpsolve import Effort, InputError, Problem, certify, tracks, vehicles
from mpsolve.outcome import Status
from mpsolve.ranges.cells import BOUNDARY, OPEN
from mpsolve.ranges.chart import Chart, stability_chart

TRACK = tracks.EulerBernoulli(EI="6.4e6", m=60, k="1e6", c=770)
PAIR = Problem(TRACK, vehicles.train(vehicles.Mass(10000), 2, "3.4"), v=150)
OVER: dict[str, Any] = {"v": (205, 240), "scale.mass": ("0.4", "0.9")}


@pytest.fixture(scope="module")
def chart() -> Chart:
    return stability_chart(PAIR, over=OVER, depth=4, check=False)


def test_regions_are_decided_and_strips_are_thin(chart: Chart) -> None:
    assert chart.status is Status.UNVERIFIED
    assert chart.share > 0.96
    assert {part.roots for part in chart.parts} == {0, 2}
    assert sum(part.cells for part in chart.parts) == (chart.detail >= 0).sum()


def test_numbers_are_those_of_certified_points(chart: Chart) -> None:
    rng = np.random.default_rng(3)
    chosen = rng.permutation(np.argwhere(chart.counts >= 0))[:8]
    for i, j in chosen:
        v, factor = (edges[k] + (edges[k + 1] - edges[k]) / 3 for edges, k in ((chart.x, i), (chart.y, j)))
        found = certify(PAIR.changed("v", v).changed("scale.mass", factor), region="unstable", digits=15, check=False)
        assert found.unstable == chart.counts[i, j] == chart.at(v, factor)


def test_a_strip_is_where_the_number_changes(chart: Chart) -> None:
    """Between neighbouring regions with other numbers there is always a strip."""
    for a, b in ((chart.counts[:-1], chart.counts[1:]), (chart.counts[:, :-1], chart.counts[:, 1:])):
        both = (a >= 0) & (b >= 0)
        assert (a[both] == b[both]).all()
    assert (chart.counts == BOUNDARY).any()


def test_little_effort_keeps_what_is_known() -> None:
    found = stability_chart(PAIR, over=OVER, depth=4, effort=Effort(evaluations=50), check=False)
    assert found.status is Status.UNDECIDED
    assert found.reason is not None
    assert found.counts.shape == (16, 16)
    assert found.at(210, "0.7") in (None, 0, 2)


def test_the_boundary_is_one_proved_curve_with_a_fold(chart: Chart) -> None:
    """Counts by the certified half-plane on both sides of it, and real roots on it by another count."""
    (curve,) = chart.boundaries
    assert chart.traced
    assert curve.whole
    assert not curve.divergence
    assert max(curve.radius) < 1e-5
    step = np.diff(curve.y)
    assert (step > 0).any()
    assert (step < 0).any()
    for k in range(5, len(curve.x), len(curve.x) // 4):
        normal = np.array([curve.y[k + 1] - curve.y[k - 1], curve.x[k - 1] - curve.x[k + 1]]) * [1.0, 1e-4]
        counts = set()
        for side in (-0.3, 0.3):
            v, factor = (float(z) for z in np.array([curve.x[k], curve.y[k]]) + side * normal)
            point = PAIR.changed("v", v).changed("scale.mass", factor)
            counts.add(certify(point, region="unstable", digits=15, check=False).unstable)
        assert counts == {0, 2}


def test_what_cannot_be() -> None:
    with pytest.raises(InputError, match="two parameters"):
        stability_chart(PAIR, over={"v": (1, 2)})
    with pytest.raises(InputError, match="depth"):
        stability_chart(PAIR, over=OVER, depth=30)


def test_points_outside_are_refused(chart: Chart) -> None:
    with pytest.raises(InputError, match="outside the chart"):
        chart.at(10, 1)
    assert chart.x[0] == Fraction(205)
    assert OPEN < BOUNDARY < 0


def test_a_divergence_has_a_boundary_of_its_own() -> None:
    """Two masses joined by a spring: a single root grows beyond f(0) = 0, whatever the masses."""
    damped = tracks.EulerBernoulli(EI="1/4", m=1, k=1, c=1)
    joined = vehicles.Vehicle(
        M=[[10, 0], [0, 10]], C=[[0, 0], [0, 0]], K=[[10, -10], [-10, 10]], B=[[1, 0], [0, 1]], places=[0, "1.5"]
    )
    over = {"v": (1, "1.4"), "scale.mass": ("0.2", 2)}
    found = stability_chart(Problem(damped, joined, v="1.3"), over=over, depth=5, check=False)
    assert [part.roots for part in found.parts][:2] == [0, 1]
    assert found.share > 0.98
    (curve,) = [one for one in found.boundaries if one.divergence]
    assert curve.whole
    assert not curve.q.any()
    assert np.ptp(curve.x) < 1e-6
    assert found.at("1.22", 1) == 0
    assert found.at("1.27", 1) == 1


@pytest.mark.parametrize(("above", "curves"), [(Fraction(-1, 10**5), 1), (Fraction(1, 10**5), 2)])
def test_a_curve_that_touches_the_edge(above: Fraction, curves: int) -> None:
    """The fold lies at a factor of 0.5068594417 to ten digits: just inside of the chart, or just outside of it."""
    low = Fraction("0.5068594417") + above
    found = stability_chart(PAIR, over={"v": (222, 229), "scale.mass": (low, "0.52")}, depth=3, check=False)
    assert found.traced
    assert len(found.boundaries) == curves
    assert all(curve.y.min() > float(low) - 1e-12 and curve.whole for curve in found.boundaries)
    floats_agree(found)


@pytest.mark.slow  # 20,000 boxes: elastic foundations at which a pair is unstable, for distances near one
def test_a_closed_loop_has_its_own_number_inside() -> None:
    beam = tracks.EulerBernoulli(EI="0.25", m=1, k=1, c="0.1")
    problem = Problem(beam, [vehicles.Mass(40).at(0), vehicles.Mass(40).at(2)], v="0.75")
    found = stability_chart(problem, over={"gap[0]": ("1.2", 2), "track.k": ("0.6", 3)}, depth=3, check=False)
    (curve,) = found.boundaries
    assert curve.whole
    assert (curve.x[0], curve.y[0]) == (curve.x[-1], curve.y[-1])
    assert found.at("1.22", "0.62") == found.at("1.98", "2.9") == 0
    assert found.at("1.57", "1.5") == 2
    floats_agree(found)
