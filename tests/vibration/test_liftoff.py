"""The first lift-off is a zero of the contact force, and the same for every grid of times."""

from __future__ import annotations

import numpy as np
import pytest
from track_models import DAMPED
from vehicle_models import TYPICAL

from mpsolve import Case, Load, Problem, response, vehicles
from mpsolve.problem.cases import as_problem
from mpsolve.vibration.liftoff import first_lift_off, only
from mpsolve.vibration.of_case import motion_of_case as by_the_paper

CASE = Case(alpha="0.67", eta_b="0.05", eta_m=("70", "70"), positions=("0", "1.5"))
LOADS = [Load(1), Load(1)]


def test_the_papers_beam_loses_contact_when_it_did() -> None:
    known = by_the_paper(CASE, LOADS, None, np.linspace(40, 43, 3001)).contact_loss
    found = response(as_problem(CASE), LOADS, times=[0, 60]).lift_off
    assert found is not None
    assert known[found.contact - 1] == pytest.approx(found.time, abs=1e-5)
    assert 0 < found.tolerance < 1e-3


def test_the_event_does_not_hang_on_the_times() -> None:
    grids = ([60.0], np.linspace(0, 60, 7), np.linspace(0, 60, 2000))
    events = [response(as_problem(CASE), LOADS, times=grid).lift_off for grid in grids]
    assert all(event is not None for event in events)
    times = [event.time for event in events if event]
    assert max(times) - min(times) <= max(event.tolerance for event in events if event)


def test_the_force_is_0_there_and_was_above_before() -> None:
    found = response(as_problem(CASE), LOADS, times=[0, 60])
    event = found.lift_off
    assert event is not None
    close = response(as_problem(CASE), LOADS, times=[event.time - 0.1, event.time, event.time + 0.1])
    before, there, after = close.contact_force[event.contact - 1]
    assert before > 0 > after
    assert abs(there) < 1e-5
    assert close.within[[0, 2]].tolist() == [True, False]
    assert found.within.tolist() == [True, False]


def test_a_harmonic_load_lifts_a_wheel_at_its_first_trough() -> None:
    """On a steady start the wheel leaves when the load has taken off its weight: slowly, on a stiff track."""
    problem = Problem(DAMPED["two-layer"], vehicles.Mass(900), v=1)
    found = response(problem, [Load(1000, -2000, 1)], times=[0, 10], initial="steady")
    assert found.lift_off is not None
    assert found.lift_off.time == pytest.approx(np.pi / 6, rel=1e-3)


def test_a_contact_that_nothing_presses_is_not_judged() -> None:
    problem = Problem(DAMPED["two-layer"], TYPICAL["bogie"], v=10)
    two = Problem(problem.track, [vehicles.Mass(900), vehicles.Mass(900).at(3)], v=10)
    assert response(two, [Load(1000), Load(0)], times=[0, 0.2]).lift_off is None
    still = response(problem, times=[0.2], initial="steady")
    assert first_lift_off(still.solution, 0.0) is None
    force = only(still.solution, np.array([5, 6]))(np.array([1.0, 100.0]))
    assert force == pytest.approx(np.repeat(still.contact_force, 2, 1))
