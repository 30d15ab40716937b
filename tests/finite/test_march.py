"""The march keeps the energy of a resting load, at any step, through tight contacts and springs."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from mpsolve import tracks, vehicles
from mpsolve.finite.carriage import carriage
from mpsolve.finite.discretization import discretized
from mpsolve.finite.exponentials import exponentials
from mpsolve.finite.march import Setting, march
from mpsolve.vehicles.load import Load
from mpsolve.vehicles.loads import outer_forces

BEAM = tracks.EulerBernoulli(EI="0.25", m=1, k=1)


def _setting(vehicle: Any, loads: Any, velocity: float = 0.0, **more: Any) -> Setting:
    pencil = vehicle.pencil
    track = exponentials(discretized(BEAM.waveguide, 30.0, 50))
    contacts = np.array([float(x) for x in pencil.places])
    given_ = {"contacts": contacts, "points": contacts, "origin": 13.0, "duration": 20.0} | more
    vehicle_, outer = carriage(pencil), outer_forces(pencil, loads)
    return Setting(track=track, length=30.0, vehicle=vehicle_, outer=outer, velocity=velocity, **given_)


@settings(max_examples=12)
@given(steps=st.integers(5, 60), k_contact=st.sampled_from([None, 3, 10**6]), k=st.integers(1, 9))
def test_a_resting_bogie_keeps_the_energy_at_any_step(steps: int, k_contact: int | None, k: int) -> None:
    """Kinetic and elastic energy of the bogie and of the contacts, and that of the modes, against the work."""
    bogie = vehicles.Bogie(wheel=5, frame=7, inertia=4, wheelbase=2, k=k, k_contact=k_contact)
    setting = _setting(bogie, {"frame bounce": Load(2), "frame pitch": Load("0.7")})
    found = march(setting, steps)
    y, speed = found.state[:, -1], found.state_rate[:, -1]
    vehicle = setting.vehicle
    energy = (speed @ vehicle.M @ speed + y @ vehicle.K @ y) / 2
    energy += 0 if k_contact is None else k_contact * np.sum((vehicle.B.T @ y - found.rail[:, -1]) ** 2) / 2
    # the rail took ∫ f dw: what the forces did on it, in closed form with the mean and P₁ of its rate
    work = 2 * y[2] + 0.7 * y[3]
    again = _modal_energy(setting, found.force, steps)
    assert energy + again == pytest.approx(work, abs=1e-9 * (1 + energy))


def _modal_energy(setting: Setting, force: Any, steps: int) -> float:
    """Of undamped modes under forces linear in each step, by their own exact integration in real numbers."""
    k, h = setting.track.k, setting.duration / steps
    omega = np.sqrt(k**4 / 4 + 1)
    shape = np.sin(np.multiply.outer(setting.origin + setting.contacts, k))
    a, rate = np.zeros((2, len(k)))
    for step in range(steps):
        low, rise = (2 / setting.length * (f @ shape) / omega**2 for f in
                     (force[:, 0, step] - force[:, 1, step], 2 * force[:, 1, step]))  # fmt: skip
        # particular solution low + rise θ of a'' + ω² a = ω² (low + rise θ)
        c, s = a - low, (rate - rise / h) / omega
        cos, sin = np.cos(omega * h), np.sin(omega * h)
        a, rate = low + rise + c * cos + s * sin, rise / h + omega * (s * cos - c * sin)
    return float(setting.length / 4 * np.sum(rate**2 + omega**2 * a**2))


def test_a_spring_that_is_stiff_is_a_tight_contact() -> None:
    tight, stiff = (
        march(_setting(vehicles.Oscillator(wheel=5, body=9, k=1, k_contact=k), [Load(1)], 0.4, duration=10.0), 400)
        for k in (None, 10**7)
    )
    assert np.abs(tight.state - stiff.state).max() < 1e-5 * np.abs(tight.state).max()
    assert np.abs(tight.rail - stiff.rail).max() < 1e-5 * np.abs(tight.rail).max()
    contact = tight.state[0] - tight.rail[0]
    assert np.abs(contact).max() < 1e-11 * np.abs(tight.rail).max()
