"""Receptances in batches: waves gap by gap and companion matrices say the same as sums of residues."""

from __future__ import annotations

import numpy as np
import pytest
from batch_groups import BEAM, PROBLEMS, group_of, points

from mpsolve import Problem, vehicles
from mpsolve.batch import kernel, wave_sums
from mpsolve.batch.kernel import log_delta, log_det, log_slope, receptances
from mpsolve.characteristic.floats import Floats
from mpsolve.problem.reduced import reduce_problem


@pytest.mark.parametrize("name", PROBLEMS)
def test_waves_gap_by_gap_and_companions_say_the_same(name: str, monkeypatch: pytest.MonkeyPatch) -> None:
    group, sigma, rows = group_of(PROBLEMS[name]), points(), np.zeros(30, int)
    plain = receptances(group, rows, sigma, slope=True)
    unequal = (wave_sums, "_EQUAL", -1.0)  # all pairs, not one sum for each distance
    for changes in ((unequal,), (unequal, (wave_sums, "_REACH", 0.0)), ((kernel, "_LOST", 0.0),)):
        with monkeypatch.context() as other:
            for change in changes:
                other.setattr(*change, raising=True)
            found = receptances(group, rows, sigma, slope=True)
        size = np.abs(plain.G).max((1, 2), keepdims=True)
        assert (np.abs(found.G - plain.G) < 1e-9 * size).all()
        assert (np.abs(found.G_sigma - plain.G_sigma) < 1e-8 * np.abs(plain.G_sigma).max((1, 2), keepdims=True)).all()


@pytest.mark.parametrize("name", PROBLEMS)
def test_delta_is_that_of_one_problem(name: str) -> None:
    problem = PROBLEMS[name]
    group, sigma, rows = group_of(problem), points(), np.zeros(30, int)
    reduced = reduce_problem(problem)
    expected, slope = Floats(reduced).delta(sigma * group.unit[0] / float(reduced.frequency_unit))
    found, _ = log_delta(group, rows, sigma)
    ratio = np.exp(found) / expected
    assert np.allclose(ratio, ratio[0], rtol=1e-9)
    assert abs(ratio[0].imag) < 1e-9 * abs(ratio[0])
    rate = 1j * slope / expected * group.unit[0] / float(reduced.frequency_unit)
    assert np.allclose(log_slope(group, rows, -1j * sigma)[0], rate, rtol=1e-8)


def test_long_trains_leave_no_float() -> None:
    """Exponents beyond the range of float64."""
    group = group_of(Problem(BEAM, [vehicles.Mass(40).at(x) for x in (0, 1, 3000)], v="0.8"))
    log, _ = log_delta(group, np.zeros(5, int), 1j * np.linspace(0.1, 3, 5))
    alone = group_of(Problem(BEAM, [vehicles.Mass(40).at(x) for x in (0, 1)], v="0.8"))
    single = group_of(Problem(BEAM, vehicles.Mass(40), v="0.8"))
    parts = [log_delta(one, np.zeros(5, int), 1j * np.linspace(0.1, 3, 5))[0] for one in (alone, single)]
    rest = np.exp(log - parts[0] - parts[1])
    assert np.allclose(rest, rest[0], rtol=1e-8)  # far apart they do not feel one another


@pytest.mark.parametrize("size", [1, 2, 3])
def test_small_determinants_are_numpys(size: int) -> None:
    rng = np.random.default_rng(size)
    A = rng.normal(size=(50, size, size)) + 1j * rng.normal(size=(50, size, size))
    assert np.allclose(np.exp(log_det(A)), np.linalg.det(A), rtol=1e-12)
