"""Premises of a batch: exact decisions, once for each different track."""

from __future__ import annotations

import numpy as np
import pytest

from mpsolve import Problem, tracks, vehicles
from mpsolve.batch.entries import entries_of
from mpsolve.batch.premises import premise, premises


def test_speeds_of_short_waves() -> None:
    assert premise(tracks.String(T=27000, m=3, k=500, c=2)).speed == pytest.approx((27000 / 3) ** 0.5, rel=1e-7)
    beam = tracks.Timoshenko(EI="6.38e6", m="60.2", S="2.4e8", J="0.24", k="1e6", c=770)
    assert premise(beam).speed == pytest.approx(min((2.4e8 / 60.2) ** 0.5, (6.38e6 / 0.24) ** 0.5), rel=1e-7)
    assert premise(tracks.EulerBernoulli(EI=1, m=1, k=1, c=1)).speed == np.inf


def test_what_is_refused() -> None:
    beam = tracks.EulerBernoulli(EI="0.25", m=1, k=1, c="0.1")
    entries = entries_of(Problem(beam, vehicles.Mass(1), v=1), {"track.N": [0, 1.5, 0], "track.c": [0.1, 0.1, 0]})
    known, which = premises(entries)
    stated = [known[k].refused for k in which]
    assert stated[0] == ""
    assert "buckles" in stated[1]
    assert "without damping" in stated[2]


def test_one_decision_for_a_track_however_many_entries() -> None:
    beam = tracks.EulerBernoulli(EI="0.25", m=1, k=1, c="0.1")
    entries = entries_of(Problem(beam, vehicles.Mass(1), v=1), {"v": np.linspace(0, 1, 500), "track.k": 2})
    known, which = premises(entries)
    assert len(known) == 1
    assert known[0].passive
    assert known[0].vanishes
    assert (which == 0).all()
