"""The finite track and the endless one agree to the sum of the errors that both tell, and those are not idle."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from track_models import DAMPED
from vehicle_models import BOGIE, TYPICAL

from mpsolve import Problem, finite_track, response, vehicles

TIGHT = vehicles.Bogie(**BOGIE, body=16000, k2="4e5", c2="2e4")
BEAM, TWO = DAMPED["euler-bernoulli"], DAMPED["two-layer"]


def _shares(problem: Problem, known: Any, tolerance: float, **figures: Any) -> list[float]:
    """The difference of the two ways by the sum of their errors: rail, vehicle, contact forces."""
    found = finite_track(problem, times=known.times, tolerance=tolerance, **figures)
    told, own = found.error, known.error
    vehicle = np.max([np.abs(found.vehicle[name] - known.vehicle[name]).max() for name in found.vehicle])
    return [
        np.abs(found.rail - known.rail).max() / (told.total + own.rail),
        vehicle / (told.vehicle + max(own.vehicle.values())),
        np.abs(found.contact_force - known.contact_force).max() / (told.force + own.contact_force),
    ]


@pytest.mark.parametrize(
    ("track", "vehicle", "velocity", "duration", "length"),
    [
        (BEAM, TIGHT, 100, 0.063, 60),  # waves come back from the supports within the times
        (BEAM, TIGHT, 100, 0.063, 200),
        (BEAM, TYPICAL["bogie"], 100, 0.063, 200),  # a vibration of the beam between the springs is faster than steps
        (DAMPED["timoshenko"], vehicles.Mass(900), 40, 0.1, 60),
        (TWO, TYPICAL["oscillator"], 40, 0.1, 60),
        (DAMPED["slab"], TIGHT, 40, 0.1, 60),
    ],
)
def test_the_two_ways_agree_to_the_sum_of_their_errors(
    track: Any, vehicle: Any, velocity: int, duration: float, length: int
) -> None:
    problem = Problem(track, vehicle, v=velocity)
    known = response(problem, times=np.linspace(duration / 10, duration, 10))
    for tolerance in (1e-3, 1e-4, 1e-6):
        shares = _shares(problem, known, tolerance, length=length, modes=8 * length)
        assert max(shares) < 1
        assert min(shares) > 1e-3


def test_of_one_time_alone_the_error_is_told_too() -> None:
    """At one time a change may be small by chance: others before it are looked at."""
    problem = Problem(BEAM, TIGHT, v=100)
    for last in (0.031, 0.044, 0.063):
        known = response(problem, times=[last])
        assert all(max(_shares(problem, known, tolerance, length=100, modes=600)) < 1 for tolerance in (1e-3, 1e-6))


def test_guided_ends_send_a_wave_back_with_the_other_sign() -> None:
    """Half the change to them is what the supports do: the rest of the difference is that of a longer track."""
    problem, times = Problem(DAMPED["string"], vehicles.Mass(5), v=20), np.linspace(0.02, 0.3, 15)
    short, long = (finite_track(problem, length=x, modes=20 * x, times=times, steps=300) for x in (30, 120))
    felt = np.abs(short.rail - long.rail).max()
    assert felt > 20 * long.error.total
    assert short.error.supports == pytest.approx(1.3 * felt, rel=0.2)
