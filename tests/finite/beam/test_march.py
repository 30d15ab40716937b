"""The march of the finite beam: energy, momentum and order."""

from __future__ import annotations

import numpy as np
import pytest
from beam_loads import constant
from hypothesis import given, settings
from hypothesis import strategies as st
from oracle import grid

from mpsolve.finite.beam.march import march
from mpsolve.finite.beam.modes import Beam


@settings(max_examples=15)
@given(
    eta_m=st.lists(grid(0.1, 80), min_size=1, max_size=3),
    gaps=st.lists(grid(0, 3), min_size=2, max_size=2),
    forces=st.lists(grid(-2, 2), min_size=3, max_size=3),
    steps=st.integers(3, 40),
    axial=grid(-1, 0.9),
)
def test_a_resting_load_keeps_the_energy_at_any_step(
    eta_m: list[float], gaps: list[float], forces: list[float], steps: int, axial: float
) -> None:
    n = len(eta_m)
    beam = Beam(30.0, 50, 0.0, axial, 0.0, tail=False)
    places = [13.0, 13.0 + gaps[0], 13.0 + gaps[0] + gaps[1]][:n]
    motion = march(beam, constant(forces[:n], places, eta_m), 20.0, steps)
    k, rate, weight = beam.exponentials
    a, a_rate = (weight * motion.state).real, (weight * rate * motion.state).real
    kinetic = beam.length / 4 * np.sum(a_rate**2) + np.sum(eta_m * motion.velocity[:, -1] ** 2) / 2
    work = forces[:n] @ motion.deflection[:, -1]
    assert kinetic + beam.length / 4 * np.sum(beam.stiffness(k) * a**2) - work == pytest.approx(
        0, abs=1e-10 * (1 + kinetic)
    )


def test_the_driver_of_a_moving_load_pays_with_the_momentum_of_the_waves() -> None:
    """Energy − work of the forces + α ∫ w_τ w_x dx stays 0, until waves reach the supports."""
    beam, forces = Beam(160.0, 800, 0.7, 0.0, 0.0, tail=False), [2.0, 1.0]
    motion = march(beam, constant(forces, [70.0, 71.5], [30.0, 10.0]), 15.0, 240)
    k, rate, weight = beam.exponentials
    a, a_rate = (weight * motion.state).real, (weight * rate * motion.state).real
    energy = beam.length / 4 * np.sum(a_rate**2 + beam.stiffness(k) * a**2)
    energy += np.sum([30.0, 10.0] * motion.velocity[:, -1] ** 2) / 2
    x = np.linspace(0, 160, 4801)
    angle = np.multiply.outer(x, k)
    momentum = np.trapezoid((np.sin(angle) @ a_rate) * (np.cos(angle) @ (k * a)), x)
    work = forces @ motion.deflection[:, -1]
    assert abs(0.7 * momentum) > 0.01 * energy
    assert energy - work + 0.7 * momentum == pytest.approx(0, abs=2e-4 * energy)


def test_errors_fall_with_the_step_at_third_order_or_better() -> None:
    beam, loading = Beam(80.0, 200, 0.6, 0.0, 0.02), constant([2.0, 1.0], [20.0, 21.5], [40.0, 15.0])
    fine = march(beam, loading, 30.0, 1920).deflection
    errors = [np.abs(march(beam, loading, 30.0, n).deflection - fine[:, :: 1920 // n]).max() for n in (15, 30, 60)]
    assert errors[0] > 6 * errors[1] > 36 * errors[2]
