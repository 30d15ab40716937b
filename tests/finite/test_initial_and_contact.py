"""The finite track from a steady state, its first lift-off, and wheels that leave the rail and come back."""

from __future__ import annotations

import numpy as np
import pytest
from track_models import DAMPED
from vehicle_models import BOGIE

from mpsolve import InputError, Load, Problem, finite_track, response, vehicles

BOGIE_ON = Problem(DAMPED["two-layer"], vehicles.Bogie(**BOGIE, k_contact="1.4e9"), v=40)
WHEEL = Problem(
    DAMPED["two-layer"], vehicles.Oscillator(wheel=900, body=3000, k="1e6", c="2e4", k_contact="1.4e9"), v=20
)


def test_a_steady_state_stays() -> None:
    """Constant loads that have moved for ever: nothing happens, and all is as on the endless track."""
    times = np.linspace(0.02, 0.2, 10)
    found = finite_track(BOGIE_ON, length=120, modes=1200, times=times, initial="steady", steps=400)
    known = response(BOGIE_ON, times=times, initial="steady")
    size = np.abs(known.rail).max()
    assert np.abs(found.rail - known.rail).max() < found.error.total + 1e-4 * size
    assert found.rail.std(1).max() < 2e-3 * size
    assert found.contact_force == pytest.approx(known.contact_force, rel=1e-3)
    assert found.vehicle["frame bounce"] == pytest.approx(known.vehicle["frame bounce"], rel=1e-3)
    assert found.lift_off is None


def test_a_harmonic_load_from_a_steady_state() -> None:
    times = np.linspace(0.02, 0.2, 10)
    loads = [Load(30000, 8000, 200), Load(30000, 5000, 90, "0.4")]
    found = finite_track(BOGIE_ON, loads, length=120, modes=1000, times=times, initial="steady", tolerance=1e-3)
    known = response(BOGIE_ON, loads, times=times, initial="steady")
    assert (
        np.abs(found.rail - known.rail).max() < found.error.total + known.error.rail + 1e-4 * np.abs(known.rail).max()
    )
    assert np.abs(found.contact_force - known.contact_force).max() < 1e-3 * known.contact_force.max()


def test_the_first_lift_off_is_that_of_the_endless_track() -> None:
    loads = {"body": Load(39000, 0, 0), "wheel": Load(0, -60000, 60)}
    found = finite_track(WHEEL, loads, length=80, modes=800, times=[0.2], initial="steady", tolerance=1e-3)
    known = response(WHEEL, loads, times=[0.2], initial="steady").lift_off
    assert found.lift_off is not None
    assert known is not None
    assert found.lift_off.time == pytest.approx(known.time, abs=found.lift_off.tolerance + known.tolerance)
    assert found.lift_off.contact == known.contact == 1


def test_a_wheel_that_leaves_the_rail_comes_back() -> None:
    """Up to the first lift-off nothing differs; then the force is 0, never below, and presses again, five times.

    What holds is told by no formula of the march: f = k max(e, 0) with the compression e of the contact, and the
    momentum of wheel and body is the impulse of loads and contact, through every loss and every blow.
    """
    loads, steps = {"body": Load(39000), "wheel": Load(0, -60000, 60)}, 2000
    times = np.linspace(0, 0.2, steps + 1)
    options = {"length": 40, "modes": 200, "times": times, "initial": "steady", "steps": steps}
    free = finite_track(WHEEL, loads, unilateral=True, **options)
    tied = finite_track(WHEEL, loads, **options)
    assert tied.contact_force.min() < -1000
    assert free.lift_off is not None
    assert tied.lift_off is not None
    assert abs(free.lift_off.time - tied.lift_off.time) <= free.lift_off.tolerance < 3e-4
    before = times < free.lift_off.time - free.lift_off.tolerance
    assert free.rail[:, before] == pytest.approx(tied.rail[:, before], rel=1e-9)

    wheel, body, force = free.vehicle["wheel"], free.vehicle["body"], free.contact_force[0]
    open_ = force == 0
    assert force.min() == 0
    assert 0.5 < open_.mean() < 0.8
    assert (open_[:-1] & ~open_[1:]).sum() >= 5
    assert np.abs(force - 1.4e9 * np.maximum(wheel - free.rail[0], 0)).mean() < 1e-3 * force.max()
    h, push = times[1], 39000 - 60000 * np.sin(60 * times) - force
    impulse = np.concatenate([[0], np.cumsum(push[1:] + push[:-1]) * h / 2])
    momentum = 900 * np.gradient(wheel, h, edge_order=2) + 3000 * np.gradient(body, h, edge_order=2)
    assert momentum - momentum[0] == pytest.approx(impulse, abs=2e-3 * np.abs(momentum).max())


def test_in_the_air_a_wheel_falls_freely() -> None:
    """A wheel alone, thrown up by its load and then let go by the rail: M ÿ = load, whatever the rail does."""
    problem = Problem(
        DAMPED["two-layer"], vehicles.Vehicle([[900]], [[0]], [[0]], [[1]], [0], k_contact="1.4e9"), v=20
    )
    times = np.linspace(0.001, 0.12, 240)
    loads = [Load(9000, -30000, 60)]
    found = finite_track(
        problem, loads, length=60, modes=400, times=times, initial="steady", steps=3000, unilateral=True
    )
    y, h = found.vehicle["coordinate 1"], times[1] - times[0]
    acceleration = (y[2:] - 2 * y[1:-1] + y[:-2]) / h**2
    free = np.abs(found.contact_force[0]) < 1e-9 * 9000
    inside = free[2:] & free[1:-1] & free[:-2]
    assert inside.sum() > 20
    load = 9000 - 30000 * np.sin(60 * times[1:-1])
    assert acceleration[inside] == pytest.approx(load[inside] / 900, rel=2e-3, abs=0.05)


def test_what_cannot_be_is_refused() -> None:
    tight = Problem(DAMPED["two-layer"], vehicles.Mass(900), v=20)
    with pytest.raises(InputError, match="k_contact"):
        finite_track(tight, length=60, modes=100, times=[0.1], unilateral=True)
    with pytest.raises(InputError, match="initial"):
        finite_track(tight, length=60, modes=100, times=[0.1], initial="moving")
