"""Frequencies of a vehicle on a track that is frozen at one: against bodies on rigid rails, by hand."""

from __future__ import annotations

from math import sqrt

import numpy as np

from mpsolve import Problem, tracks, vehicles
from mpsolve.characteristic.floats import Floats
from mpsolve.presets.written import problem_of
from mpsolve.problem.reduced import reduce_problem
from mpsolve.spectrum.on_frozen_track import on_frozen_track, on_rigid_rail

STIFF = tracks.EulerBernoulli(EI="6.4e6", m=60, k="1e12", c="1e3")


def found(problem: Problem, size: float) -> tuple[np.ndarray, float]:
    reduced = reduce_problem(problem)
    return on_frozen_track(Floats(reduced), size), float(reduced.frequency_unit)


def test_a_body_on_a_spring_and_a_damper_over_a_stiff_track() -> None:
    """M q² − i c q − k = 0: q = i c/2M ± √(k/M − c²/4M²)."""
    problem = Problem(STIFF, vehicles.Oscillator(wheel=1000, body=4000, k="2e6", c="1e4"), v=10)
    q, unit = found(problem, 4.0)
    truth = complex(sqrt(2e6 / 4000 - (1e4 / 8000) ** 2), 1e4 / 8000)
    assert np.abs(q * unit - truth).min() < 1e-4 * abs(truth)
    assert (q.real >= 0).all()


def test_a_heavy_mass_far_below_the_waves_of_a_wire() -> None:
    """q² = 2√(T k)/M, by hand, up to the damping."""
    wire = Problem(tracks.String(T=27_000, m="1.07", k=500, c=2), vehicles.Mass("1e30"), v=0)
    q, unit = found(wire, 2.0)
    truth = sqrt(2 * sqrt(27_000 * 500) / 1e30)
    assert np.abs(q * unit - truth).min() < 1e-6 * truth


def test_every_vibration_of_a_coach_has_a_start_near_it() -> None:
    """The car bounces and pitches on secondary springs over primary ones, its frames on both: as on a rigid rail."""
    q, unit = found(problem_of("ballasted", "manchester")[0], 2.0)
    car, frame = (430e3 * 2400e3 / (430e3 + 2400e3), 430e3 + 2400e3)
    for moved, stiffness in ((16000.0, 2 * car), (985000.0, 2 * car * 9.5**2), (1307.5, frame)):
        alone = sqrt(stiffness / moved)
        assert np.abs(np.abs(q) * unit - alone).min() < 0.06 * alone


def test_a_vehicle_that_nothing_holds_gives_no_start() -> None:
    q, _ = found(Problem(STIFF, vehicles.Mass("1e-3"), v=10), 1.0)
    assert q.shape == (0,)


def test_on_a_rigid_rail_contact_springs_hold_and_tight_contacts_are_free() -> None:
    """A mass on its contact spring: √(k/M). A wheel and a body on a spring between them: √(k (1/m + 1/M)), and 0."""
    sprung = vehicles.Oscillator(wheel="1e-6", body=100, k="1e9", k_contact="400")
    free = vehicles.Oscillator(wheel=8, body=15, k=150, c=1)
    for vehicle, truth in ((sprung, 2.0), (free, sqrt(150 * (1 / 8 + 1 / 15) - (1 / 8 + 1 / 15) ** 2 / 4))):
        reduced = reduce_problem(Problem(STIFF, vehicle, v=10))
        own = on_rigid_rail(reduced).imag * float(reduced.frequency_unit)
        assert np.abs(own - truth).min() < 1e-4 * truth
