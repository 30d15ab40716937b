"""Where the number of growing roots is that of a point that could not be counted, nothing is claimed."""

from __future__ import annotations

from fractions import Fraction

import pytest

from mpsolve import Problem, Status, certify, tracks, vehicles
from mpsolve.progress import silent
from mpsolve.ranges import without_damping as module
from mpsolve.ranges.without_damping import without_damping

LONE = Problem(tracks.EulerBernoulli(EI="1/4", m=1, k=1), vehicles.Mass(10), v="1.2")
OVER = {"v": (Fraction(1, 2), Fraction(2))}


def test_a_pair_comes_where_the_cuts_join() -> None:
    found = without_damping(LONE, OVER, 20, None, silent, check=False)
    (one,) = found.crossings
    assert (found.counts, one.direction, float(one.value), float(one.q)) == ((0, 2), 2, 1.0, 0.0)
    assert found.status is Status.UNVERIFIED


def test_an_open_count_stays_open(monkeypatch: pytest.MonkeyPatch) -> None:
    near = LONE.changed("v", "1.0000001")  # two branch points next to each other
    found = certify(near, region="unstable", check=False)
    assert not found.proved
    monkeypatch.setattr(module, "base_at", lambda *_, **__: found)
    answer = without_damping(LONE, OVER, 20, None, silent, check=False)
    assert answer.status is Status.UNDECIDED
    assert answer.counts is None
    assert answer.crossings == ()
