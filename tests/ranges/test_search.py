"""The search along an edge: its tree decides every box, and each zero in it stands once."""

from __future__ import annotations

from fractions import Fraction

import numpy as np
import pytest

from mpsolve import Case, Problem, certify, crossings, tracks, vehicles
from mpsolve.progress import silent
from mpsolve.proof.effort import Effort
from mpsolve.ranges.scope import Scope, scope_of
from mpsolve.ranges.search import Search

TRACK = tracks.EulerBernoulli(EI="6.4e6", m=60, k="1e6", c=770)
PAIR = Problem(TRACK, vehicles.train(vehicles.Mass(10000), 2, "3.4"), v=100)
RANGE = {"v": (Fraction(150), Fraction(230))}


@pytest.fixture(scope="module")
def scope() -> Scope:
    return scope_of(PAIR, RANGE)


def test_the_one_crossing_is_where_the_certified_count_changes(scope: Scope) -> None:
    search = Search(scope, 15)
    cover = search.cover(Effort(), silent)
    assert cover.reason is None
    assert not len(cover.tree.open)
    (one,) = search.found
    v = float(one.x.mid()) * float(scope.family.units[0])
    assert [certify(PAIR.changed("v", x), region="unstable").unstable for x in (v - 0.01, v + 0.01)] == [0, 2]


def test_a_zero_is_enclosed_once(scope: Scope) -> None:
    first = Search(scope, 15)
    first.cover(Effort(), silent)
    (one,) = first.found
    again, half = Search(scope, 15), np.array([1e-3, 1e-3])
    at = np.array([float(one.q.mid()), float(one.x.mid())])
    assert again.enclose(at, half)
    assert again.enclose(at + 1e-6, half)
    assert len(again.found) == 1


def test_an_effort_that_is_spent_leaves_boxes_open(scope: Scope) -> None:
    cover = Search(scope, 15).cover(Effort(evaluations=10), silent)
    assert cover.reason is not None
    assert cover.reason.code == "effort"


def test_a_heavy_mass_in_a_range_that_begins_with_light_ones() -> None:
    """The largest room of a crossing is in proportion to its mass; certified counts on both sides."""
    case = Case(alpha="0.5", eta_b="0.05", eta_m=(1, 1), positions=(0, "1.75"))
    found = crossings(case, over={"scale.mass": ("0.001", "1e6")}, check=False)
    assert (found.proved, found.counts) == (True, (0, 2)), found.reason
    assert float(found.crossings[0].value) == pytest.approx(1055.4474120771815, rel=1e-12)
    for mass, number in ((1050, 0), (1060, 2)):
        there = Case(alpha="0.5", eta_b="0.05", eta_m=(mass, mass), positions=(0, "1.75"))
        assert certify(there, region="unstable", check=False).unstable == number
