"""A coach and a pair of bogies on a beam in every function about ranges."""

from __future__ import annotations

from fractions import Fraction
from typing import Any

import pytest

from mpsolve import (
    Problem,
    certify,
    crossings,
    onset,
    prove_stable,
    sensitivity,
    stability_chart,
    stability_table,
    tracks,
    unstable_ranges,
    vehicles,
)
from mpsolve.ranges.margin import margin_in

SOFT = tracks.EulerBernoulli(EI="6.4e6", m=60, k="5e6", c="5e3")
BOGIE = vehicles.Bogie(wheel=1000, frame=1500, inertia=800, wheelbase="2.5", k="1.2e6", c="4e3")
COACH = vehicles.Coach(
    body=16000, inertia="985e3", pivots=19, k2="430e3", c2="20e3",
    bogie=vehicles.Bogie(wheel="906.5", frame="1307.5", inertia=738, wheelbase="2.56", k="1.2e6", c="4e3"),
)  # fmt: skip
TRAINS = {"coach": Problem(SOFT, COACH, v=200), "pair of bogies": Problem(SOFT, vehicles.train(BOGIE, 2, 10), v=200)}
FASTER = {"v": (150, 700)}


@pytest.mark.parametrize("name", TRAINS)
def test_one_parameter(name: str) -> None:
    """The velocity: certified counts on both sides of what is found."""
    problem = TRAINS[name]
    first = onset(problem, over=FASTER, check=False)
    parts = unstable_ranges(problem, over=FASTER, check=False)
    every = crossings(problem, over=FASTER, check=False)
    assert all(one.proved for one in (first, parts, every))
    assert every.counts is not None
    assert first.lower is not None
    assert parts.intervals[0].lower == first.lower
    left = margin_in(parts, Fraction(200))
    assert left.stable is True
    assert left.below is None
    assert left.above is parts.intervals[0].start
    for k, v in enumerate((150, *(round(float(c.upper), 1) + 0.1 for c in every.crossings))):
        assert certify(problem.changed("v", v), region="unstable", check=False).unstable == every.counts[k]


@pytest.mark.parametrize("name", TRAINS)
def test_several_parameters(name: str) -> None:
    problem = TRAINS[name]
    box: dict[str, Any] = {"v": (50, 100), "track.k": ("4e6", "6e6")}
    assert prove_stable(problem, over=box, check=False).proved
    chart = stability_chart(problem, over=box, depth=2)
    assert chart.proved
    assert (chart.counts == 0).all()
    slopes = sensitivity(problem)
    assert slopes.proved
    assert all(set(root.by) == set(slopes.roots[0].by) for root in slopes.roots)
    table = stability_table(
        problem, over={"v": (50, 100)}, rows={"track.k": ["4e6"]}, columns={"track.c": [5000]}, workers=1
    )
    assert table.proved
