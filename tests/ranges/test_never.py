"""Each theorem tells of its own tracks, with its own words, and of no others."""

from __future__ import annotations

from fractions import Fraction

import pytest

from mpsolve import Problem, tracks, vehicles
from mpsolve.ranges import on_string, undamped
from mpsolve.ranges.never import never_unstable

PAIR = vehicles.train(vehicles.Mass(40), 2, "1.5")
BEAM = {"EI": "1/4", "m": 1, "k": 1}  # cuts join at v = 1


@pytest.mark.parametrize(
    ("problem", "high", "said"),
    [
        (Problem(tracks.EulerBernoulli(**BEAM), PAIR, v=0), "0.9", undamped.NOTE),
        (Problem(tracks.EulerBernoulli(**BEAM), PAIR, v=0), "1.1", None),
        (Problem(tracks.EulerBernoulli(**BEAM, c="0.1"), PAIR, v=0), "0.9", None),  # unstable from 0.74 on
        (Problem(tracks.String(T=4, m=1, k=1, c=1), vehicles.Mass(40), v=0), "1.9", on_string.SLOWER),
        (Problem(tracks.String(T=4, m=1, k=1, c=1), PAIR, v=0), "1.9", None),
    ],
)
def test_who_tells(problem: Problem, high: str, said: str | None) -> None:
    assert never_unstable(problem, {"v": (Fraction(0), Fraction(high))}) == said
