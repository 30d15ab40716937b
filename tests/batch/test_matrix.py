"""log Δ̂ and its slope in batches against the arrays of one problem, and where exponents leave the range of floats."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

from mpsolve import Problem, tracks, vehicles
from mpsolve.batch.entries import entries_of
from mpsolve.batch.groups import Group, groups_of
from mpsolve.batch.matrix import log_delta, log_det, log_slope
from mpsolve.characteristic.floats import Floats
from mpsolve.problem.reduced import reduce_problem

BEAM = tracks.EulerBernoulli(EI="0.25", m=1, k=1, c="0.1", eta="0.02")
TWO_LAYER = tracks.TwoLayer(
    EI="6.38e6", m="60.2", k_pad="300e6", c_pad="3e4", m_sleeper="250", k_ballast="100e6", c_ballast="8e4"
)
BOGIE = vehicles.Bogie(wheel=900, frame=1500, inertia=800, wheelbase="2.5", k="1.2e6", c="1e4", k_contact="1e9")
COACH = vehicles.Coach(body=30000, inertia="1e6", bogie=BOGIE, pivots=17, k2="0.4e6", c2="2e4")
PROBLEMS = {
    "masses, two at one place": Problem(TWO_LAYER, [vehicles.Mass(900).at(x) for x in (0, "2.5", "2.5", 9)], v=100),
    "equal gaps": Problem(BEAM, vehicles.train(vehicles.Mass(40), 6, "1.5"), v="0.8"),
    "coach": Problem(TWO_LAYER, COACH, v=300),
    "at rest": Problem(BEAM, vehicles.train(vehicles.Oscillator(wheel=3, body=5, k=2, c=1), 2, 2), v=0),
}


def group_of(problem: Problem) -> Group:
    ((group,), _) = groups_of(entries_of(problem, {}), np.arange(1))
    return group


def points(n: int = 30) -> Any:
    rng = np.random.default_rng(1)
    return rng.uniform(0.01, 3, n) + 1j * rng.uniform(0, 3, n)


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
