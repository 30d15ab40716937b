import numpy as np
import pytest

from mpsolve import (
    InputError,
    Irregularity,
    Load,
    Problem,
    finite_track,
    out_of_round,
    rail_roughness,
    response,
    tracks,
    vehicles,
)
from mpsolve.finite.rough import rough_rates

BEAM = tracks.EulerBernoulli(EI="6.4e6", m=60, k="1e7", c="2e5")


def test_rates_are_tested_as_quadrature_has_them():
    one = Irregularity(2.0, 3.0, 0.4)
    found = rough_rates((one,), 1, 0.5, 4)
    nodes, weights = np.polynomial.legendre.leggauss(12)
    for step in range(4):
        theta = (nodes + 1) / 2
        rate = 0.5 * 2.0 * 3.0 * np.cos(3.0 * 0.5 * (step + theta) + 0.4)
        assert found[step, 0] == pytest.approx([(weights / 2) @ rate, (weights / 2) @ (rate * nodes)], abs=1e-13)


def test_none_is_nothing():
    assert not rough_rates((), 2, 0.1, 3).any()


@pytest.mark.parametrize("kind", ["rail", "wheel"])
@pytest.mark.parametrize("tight", [True, False])
def test_the_endless_track_agrees_to_the_sum_of_both_errors(kind: str, tight: bool) -> None:
    """Two wheels on a damped beam; the two ways share the irregularity's definition alone."""
    wheel = (
        vehicles.Mass(400) if tight else vehicles.Oscillator(wheel=400, body=2000, k="1e6", c="2e4", k_contact="1e8")
    )
    problem = Problem(BEAM, [wheel.at(0), wheel.at(2)], v=40)
    rough = rail_roughness(problem, "1e-4", 3, 0.3) if kind == "rail" else out_of_round(problem, "1e-4", "0.46", 1, 2)
    loads, times = [Load(0), Load(0)], np.linspace(0.01, 0.25, 7)
    one = response(problem, loads, times=times, irregularities=rough)
    other = finite_track(problem, loads, length=60, modes=400, times=times, irregularities=rough, tolerance=1e-4)
    assert np.abs(one.rail).max() > 1e-6
    assert np.abs(one.rail - other.rail).max() < one.error.rail + other.error.total
    for name, row in one.vehicle.items():
        assert np.abs(row - other.vehicle[name]).max() < one.error.vehicle[name] + other.error.vehicle
    assert np.abs(one.contact_force - other.contact_force).max() < one.error.contact_force + other.error.force


def test_one_for_each_contact_is_wanted():
    problem = Problem(BEAM, vehicles.Mass(400), v=40)
    with pytest.raises(InputError, match="irregularities"):
        finite_track(problem, length=60, modes=40, times=[0.1], irregularities=[Irregularity(1, 1)] * 2)
