"""Groups: scaled arrays against the exact scaled problem; what has a structure of its own."""

from __future__ import annotations

import numpy as np

from mpsolve import Problem, tracks, vehicles
from mpsolve.batch.entries import entries_of
from mpsolve.batch.groups import groups_of
from mpsolve.batch.kernel import coefficients
from mpsolve.characteristic.splitting import upper_count
from mpsolve.characteristic.symbol import Symbol
from mpsolve.problem.reduced import track_guide
from mpsolve.tracks.waveguide import moving

TWO_LAYER = tracks.TwoLayer(
    EI="6.38e6", m="60.2", k_pad="300e6", c_pad="3e4", m_sleeper="250", k_ballast="100e6", c_ballast="8e4"
)
WIRE = tracks.String(T=4, m=1, k=1, c=1)


def test_scaled_coefficients_are_those_of_the_moving_track() -> None:
    entries = entries_of(Problem(TWO_LAYER, vehicles.Mass(900), v=90), {"v": [30, 90], "track.m": [60, 75]})
    (group,), refused = groups_of(entries, np.arange(2))
    assert not refused
    for row in range(2):
        exact = entries.exact(row)
        D = moving(exact.track.waveguide.dispersion, exact.v)
        sigma = 0.3 + 0.7j
        found = coefficients(group.D, np.array([row]), np.array([sigma]))[0]
        # one factor for all, and powers of one unit of length
        expected = np.zeros(len(found), complex)
        for (i, j), c in D.items():
            expected[i] += float(c) * (sigma * group.unit[row]) ** j
        ratio = found / expected
        logs = np.log2(np.abs(ratio))
        assert np.allclose(np.diff(logs), np.diff(logs)[0], atol=1e-9)
        assert np.allclose(np.angle(ratio), 0, atol=1e-9)
        assert group.up == upper_count(Symbol.of(track_guide(exact.track, exact.v).D))


def test_entries_of_another_structure_stand_apart() -> None:
    entries = entries_of(Problem(WIRE, vehicles.Mass(1), v=1), {"v": [0, 1, 3, 5], "track.k": [1, 1, 0, 1]})
    groups, refused = groups_of(entries, np.arange(4))
    assert sorted(sorted(group.index.tolist()) for group in groups) == [[0], [1], [2], [3]]
    assert not refused
    assert {int(group.index[0]): group.up for group in groups} == {0: 1, 1: 1, 2: 0, 3: 0}


def test_a_wave_speed_is_refused() -> None:
    entries = entries_of(Problem(WIRE, vehicles.Mass(1), v=1), {"v": [1.0, 2.0]})
    groups, refused = groups_of(entries, np.arange(2))
    assert [group.index.tolist() for group in groups if len(group)] == [[0]]
    assert "wave speed" in refused[1]
