"""A box round a problem that is stable at its corners, and none where there is none."""

from __future__ import annotations

from fractions import Fraction
from itertools import product

from mpsolve import Problem, certify, tracks, vehicles
from mpsolve.ranges.region import stable_region

TRACK = tracks.EulerBernoulli(EI="6.4e6", m=60, k="1e6", c=770)
PAIR = Problem(TRACK, vehicles.train(vehicles.Mass(10000), 2, "3.4"), v=150)
HALF = Fraction(1, 2)


def test_it_is_stable_at_every_corner_and_holds_the_case() -> None:
    box = stable_region(PAIR, {"v": HALF, "track.k": HALF}, 30)
    assert box is not None
    assert box["v"][0] < 150 < box["v"][1] < Fraction(191)
    for v, k in product(*box.values()):
        corner = PAIR.changed("v", v).changed("track.k", k)
        assert certify(corner, region="unstable", digits=15, check=False).stable


def test_there_is_none_round_what_grows_and_none_of_what_is_0() -> None:
    assert stable_region(PAIR.changed("v", 250), {"v": HALF}, 30) is None
    assert stable_region(PAIR, {"v": HALF, "track.N": HALF}, 30) is None
    assert stable_region(PAIR, {"v": HALF}, 0) is None
