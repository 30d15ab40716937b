"""What a tone keeps up: against the receptance and the vehicle's equations; limits where p-roots meet zeros of N."""

from __future__ import annotations

import numpy as np
import pytest
from track_models import DAMPED

from mpsolve import InputError, Load, Problem, receptance, vehicles
from mpsolve.vehicles.loads import outer_forces
from mpsolve.vibration.forcing import tones
from mpsolve.vibration.image import Image
from mpsolve.vibration.steady import forced


@pytest.mark.parametrize("omega", [0, 40, 700])
def test_a_mass_under_a_force(omega: int) -> None:
    """w = G f, f = P + M ω² w."""
    problem = Problem(DAMPED["two-layer"], vehicles.Mass(900), v=30)
    image = Image(problem, ())
    load = Load(7) if not omega else Load(0, 7, omega, np.pi / 2)
    (tone,) = tones(image, outer_forces(image.pencil, [load]), ())
    G = receptance(problem.track, 0, omega, 30)[0, 0]
    w = 7 * G / (1 - 900 * omega**2 * G)
    assert forced(image, tone).amplitude == pytest.approx(np.array([w, w / G]), rel=1e-9)
    times = np.array([0.0, 1.0])
    assert forced(image, tone).motion(times * image.rate)[0] == pytest.approx((w * np.exp(1j * omega * times)).real)


@pytest.mark.parametrize("v", [2, 20])
def test_floating_ice_at_rest_in_the_moving_frame(v: int) -> None:
    """At σ = 0 N and D vanish together at p = 0: the deflection is the limit, that of a slow harmonic force."""
    problem = Problem(DAMPED["floating-ice"], vehicles.Mass(900), v=v)
    image = Image(problem, ())
    (tone,) = tones(image, outer_forces(image.pencil, [Load(1000)]), ())
    near = [receptance(problem.track, 0, x, v)[0, 0] for x in (1e-4, -1e-4)]
    assert forced(image, tone).amplitude[0].real == pytest.approx(1000 * np.mean(near).real, rel=1e-5)


def test_a_motion_without_bound_is_refused() -> None:
    sinking = Problem(DAMPED["two-layer"], vehicles.Oscillator(wheel=900, body=500, k=0, c=1000), v=10)
    image = Image(sinking, ())
    (tone,) = tones(image, outer_forces(image.pencil, None), ())
    with pytest.raises(InputError, match="are constant"):
        forced(image, tone)
