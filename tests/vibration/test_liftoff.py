"""The first lift-off is a zero of the contact force, and the same for every grid of times."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from track_models import DAMPED
from vehicle_models import TYPICAL

from mpsolve import Case, Load, Problem, read_problem, receptance, response, vehicles
from mpsolve.problem.cases import as_problem
from mpsolve.vibration.liftoff import first_fall, first_lift_off, last_above
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


WHEEL = Problem(DAMPED["two-layer"], vehicles.Mass(900), v=1)


@pytest.mark.parametrize("amplitude", ["1000.0001", "1001"])
def test_a_force_that_hardly_comes_to_0(amplitude: str) -> None:
    """The forced part is known: c + a |H| sin(t + arg H), H = 1/(1 − MG). Few samples are below 0, if any."""
    H = 1 / (1 - 900 * receptance(WHEEL.track, 0, 1, 1)[0, 0])
    known = np.pi + np.arcsin(1000 / (float(amplitude) * abs(H))) - np.angle(H)
    for times in ([5], np.linspace(0, 5, 200)):
        event = response(WHEEL, [Load(1000, amplitude, 1)], times=times, initial="steady").lift_off
        assert event is not None
        assert abs(event.time - known) < event.tolerance + 1e-6  # what is left of the free part
    assert response(WHEEL, [Load(1000, 999, 1)], times=[5], initial="steady").lift_off is None


def test_a_lift_off_before_the_first_time_asked_for() -> None:
    """It comes at 0.317 s; nothing but the last time is wanted, long after, or hardly after."""
    problem = read_problem("examples/rail_60e1.toml").problem
    events = [response(problem, times=times).lift_off for times in ([0.4], [5.0], np.linspace(0, 5, 5000))]
    for event in events:
        assert event is not None
        assert event.contact == 1
        assert event.time == pytest.approx(0.31731601, abs=2 * event.tolerance + 1e-8)
        assert event.tolerance < 1e-4
    assert response(problem, times=[0.31]).lift_off is None


def test_a_long_time_is_not_searched_once_all_is_calm() -> None:
    """200 s are two million steps of its fastest vibration."""
    assert response(Problem(DAMPED["two-layer"], TYPICAL["bogie"], v=20), times=[0, 200]).lift_off is None


def test_a_load_that_pulls_at_once_lifts_at_once() -> None:
    event = response(WHEEL, [Load(1000, -3000, 1, "1.5")], times=[4, 8]).lift_off
    assert event is not None
    assert event.time == 0
    assert event.tolerance < 1e-3


def test_of_two_contacts_that_leave_together_the_first_one_is_told_on_any_grid() -> None:
    """Loads a thousandth of a radian apart: when the one is told to leave, the other is still pressed."""
    two = Problem(DAMPED["two-layer"], [vehicles.Mass(900).at(0), vehicles.Mass(900).at(3)], v=40)
    loads = [Load(9000, -20000, 200), Load(9000, -20000, 200, "1e-3")]
    events = [response(two, loads, times=t, initial="steady").lift_off for t in ([0.05], np.linspace(0, 0.05, 200))]
    one, other = (event for event in events if event)
    assert one.contact == other.contact
    assert abs(one.time - other.time) <= one.tolerance + other.tolerance < 1e-7
    force = response(two, loads, times=[one.time], initial="steady").contact_force[:, 0]
    assert abs(force[one.contact - 1]) < 1e-3 * force[2 - one.contact]
    assert force[2 - one.contact] < 0.02 * 9000


def test_a_contact_that_nothing_presses_is_not_judged() -> None:
    problem = Problem(DAMPED["two-layer"], TYPICAL["bogie"], v=10)
    two = Problem(problem.track, [vehicles.Mass(900), vehicles.Mass(900).at(3)], v=10)
    assert response(two, [Load(1000), Load(0)], times=[0, 0.2]).lift_off is None
    still = response(problem, times=[0.2], initial="steady")
    assert first_lift_off(still.solution, 0.0) is None
    some = still.solution.only(np.array([5, 6]))
    force = some.moved(np.array([1.0, 100.0])) + some.held[:, None]
    assert force == pytest.approx(np.repeat(still.contact_force, 2, 1))


NOISE = 1e-9


def found(f: Any, grid: Any, above: float | None = None) -> Any:
    return first_fall(f, grid, f(grid), NOISE, above)


@pytest.mark.parametrize("count", [4, 5, 50, 5001])
def test_a_zero_does_not_hang_on_the_samples(count: int) -> None:
    fall = found(np.cos, np.linspace(0, 3, count))
    assert fall.time == pytest.approx(np.pi / 2, abs=1e-12)
    assert NOISE < fall.off < 2e-7


@pytest.mark.parametrize("depth", [1e-3, 1e-6, 1e-8])
@pytest.mark.parametrize("count", [12, 13, 100, 101, 4001])
def test_a_dip_between_samples_and_one_that_hardly_crosses(depth: float, count: int) -> None:
    """1 − (1 + d) sin t = 0 at sin t = 1/(1 + d): samples within the noise on the way do not hide it."""
    fall = found(lambda t: 1 - (1 + depth) * np.sin(t), np.linspace(0, 3, count))
    assert abs(fall.time - np.arcsin(1 / (1 + depth))) < fall.off
    assert fall.off < 3 * NOISE / np.sqrt(2 * depth) + 1e-7


@pytest.mark.parametrize("depth", [0.0, -1e-12, -0.1, 1e-10])
def test_what_touches_0_within_its_error_does_not_fall(depth: float) -> None:
    assert found(lambda t: 1 - (1 + depth) * np.sin(t), np.linspace(0, 3, 31)) is None


def test_it_is_known_from_earlier_samples_that_it_was_above() -> None:
    def f(t: Any) -> Any:
        return np.where(t < 1, 1 - t, np.where(t < 2, 0.0, 2 - t))

    grid = np.linspace(1.05, 3, 30)
    fall = found(f, grid, 0.5)
    assert fall.time == pytest.approx(1)
    assert fall.time + fall.off >= 2
    assert found(f, grid) == found(f, grid, None)
    assert found(f, grid).time == 0
    assert last_above(grid, f(grid), NOISE, 0.5) == 0.5
    assert last_above(np.array([0.2, 0.6]), np.array([1, 0.0]), NOISE, None) == 0.2
