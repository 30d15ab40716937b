"""Rough rails and uneven wheels: what each contact sees, and what a wheel on a stiff spring does."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from track_models import DAMPED
from vehicle_models import TYPICAL

from mpsolve import InputError, Problem, out_of_round, rail_roughness, receptance, response, vehicles

PROBLEM = Problem(DAMPED["two-layer"], TYPICAL["bogie"], v=30)


def test_both_wheels_run_over_the_same_wave() -> None:
    """What the rear wheel sees is what the front wheel saw a wheelbase earlier."""
    rear, front = rail_roughness(PROBLEM, "2e-5", "0.8", 0.3)
    late = 2.56 / 30
    t = np.linspace(0, 1, 7)
    assert np.sin(rear.frequency * (t + late) + rear.phase) == pytest.approx(
        np.sin(front.frequency * t + front.phase)
    )
    assert rear.frequency == pytest.approx(2 * np.pi * 30 / 0.8)


def test_an_uneven_wheel() -> None:
    one = out_of_round(PROBLEM, "1e-4", "0.46", order=3, contact=2)
    assert [part.amplitude for part in one] == [0.0, 1e-4]
    assert one[1].frequency == pytest.approx(3 * 30 / 0.46)
    assert [part.amplitude for part in out_of_round(PROBLEM, "1e-4", "0.46")] == [1e-4, 1e-4]


def test_the_force_that_a_wave_keeps_up() -> None:
    """f = r/(h + G + 1/(−Mω²)): the wheel's, the spring's and the rail's compliance in a row."""
    wheel = vehicles.Vehicle([[900]], [[0]], [[0]], [[1]], [0], k_contact="1.4e9")
    problem = Problem(DAMPED["two-layer"], wheel, v=30)
    (wave,) = rail_roughness(problem, "2e-5", "0.5", np.pi / 2)
    omega = wave.frequency
    found = response(problem, times=np.linspace(3, 3.1, 40), irregularities=[wave], initial="steady")
    G = receptance(problem.track, 0, omega, 30)[0, 0]
    f = 2e-5 / (1 / 1.4e9 + G - 1 / (900 * omega**2))
    assert np.ptp(found.contact_force[0]) / 2 == pytest.approx(abs(f), rel=2e-2)
    w = 2e-5 * G / (1 / 1.4e9 + G - 1 / (900 * omega**2))
    kept = (w * np.exp(1j * omega * found.times)).real
    assert found.steady_harmonic[0] == pytest.approx(kept, rel=1e-8, abs=1e-12)


@pytest.mark.parametrize(
    ("key", "make"),
    [
        ("wavelength", lambda: rail_roughness(PROBLEM, 1, 0)),
        ("radius", lambda: out_of_round(PROBLEM, 1, -1)),
        ("order", lambda: out_of_round(PROBLEM, 1, 1, 0)),
        ("contact", lambda: out_of_round(PROBLEM, 1, 1, contact=3)),
    ],
)
def test_what_cannot_be_is_named(key: str, make: Any) -> None:
    with pytest.raises(InputError) as error:
        make()
    assert error.value.key == key
