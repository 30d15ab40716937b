"""Roots of a group: as many as counted, zeros of Δ̂ found another way, and the helpers on rows of them."""

from __future__ import annotations

import numpy as np

from mpsolve import Problem, tracks, vehicles
from mpsolve.batch.count import count_group
from mpsolve.batch.entries import entries_of
from mpsolve.batch.groups import groups_of
from mpsolve.batch.passive import first_passive
from mpsolve.batch.roots import Search, weight, whole
from mpsolve.characteristic.floats import Floats
from mpsolve.problem.reduced import reduce_problem

BEAM = tracks.EulerBernoulli(EI="0.25", m=1, k=1, c="0.1")


def test_a_band_of_roots_is_found() -> None:
    problem = Problem(BEAM, vehicles.train(vehicles.Mass(40), 10, "1.5"), v="0.75")
    entries = entries_of(problem, {"v": [0.6, 0.75, 0.9]})
    ((group,), _) = groups_of(entries, np.arange(3))
    rho = first_passive(group)
    counted = count_group(group, rho, np.zeros(3))
    assert counted.count.max() > 6
    search = Search(group, counted, rho, np.zeros(3))
    assert search.solve().all()
    for row in range(3):
        reduced = reduce_problem(entries.exact(row))
        q = search.q[row][np.isfinite(search.q[row])] * group.unit[row] / float(reduced.frequency_unit)
        value, slope = Floats(reduced).delta(1j * q)
        assert (np.abs(value / slope) < 1e-9 * np.abs(q)).all()


def test_a_single_root_on_the_imaginary_axis() -> None:
    """Divergence: two masses joined by a spring; one root alone has passed q = 0."""
    track = tracks.EulerBernoulli(EI="0.25", m=1, k=1, c=1)
    joined = vehicles.Vehicle(
        M=[[10, 0], [0, 10]], C=[[0, 0], [0, 0]], K=[[10, -10], [-10, 10]], B=[[1, 0], [0, 1]], places=[0, "1.5"]
    )
    ((group,), _) = groups_of(entries_of(Problem(track, joined, v="1.3"), {}), np.arange(1))
    rho = first_passive(group)
    search = Search(group, count_group(group, rho, np.zeros(1)), rho, np.zeros(1))
    assert search.solve().all()
    assert search.counted.count.tolist() == [1]
    assert np.allclose(search.q[0, 0] * group.unit[0], -0.0851741452j, rtol=1e-8)


def test_rows_with_their_mirrors() -> None:
    q = np.array([[1 - 2j, -3j, np.nan], [np.nan, np.nan, np.nan]])
    assert weight(q).tolist() == [3, 0]
    row = whole(q)[0]
    assert row[:3].tolist() == [-1 - 2j, -3j, 1 - 2j]
    assert np.isnan(row[3:]).all()
