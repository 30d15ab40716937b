"""Tones are loads and irregularities: their transforms against integrals, their motion against the sines."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from track_models import DAMPED
from vehicle_models import TYPICAL

from mpsolve import (
    InputError,
    Irregularity,
    Load,
    Problem,
    out_of_round,
    rail_roughness,
    receptance,
    response,
    vehicles,
)
from mpsolve.vehicles.loads import outer_forces
from mpsolve.vibration.forcing import forced, tones, transform
from mpsolve.vibration.image import Image

IMAGE = Image(Problem(DAMPED["two-layer"], TYPICAL["bogie"], v=10), ())


def test_the_transform_is_the_integral_of_the_force() -> None:
    loads = [Load(3, 2, 4096, "0.7"), Load(0, 1, -8192, "0.2")]
    acting = tones(IMAGE, outer_forces(IMAGE.pencil, loads), ())
    assert [tone.frequency * IMAGE.rate for tone in acting] == [0, 4096, 8192]
    sigma, rows = 0.8 + 0.3j, IMAGE.size + IMAGE.contacts
    nodes, weights = np.polynomial.legendre.leggauss(400)
    t = 30 * (nodes + 1)
    forces = [3 + 2 * np.sin(4096 * t / IMAGE.rate + 0.7), np.sin(-8192 * t / IMAGE.rate + 0.2)]
    unit = [IMAGE.column(np.eye(IMAGE.size)[j], np.zeros(2)) for j in (0, 1)]
    known = sum(
        30 * (weights * f * np.exp(-sigma * t)).sum() * column for f, column in zip(forces, unit, strict=True)
    )
    assert transform(acting, np.array([sigma]), rows)[0] == pytest.approx(known, rel=1e-10)


def test_an_irregularity_begins_where_it_is() -> None:
    rough = (Irregularity(2.0, 4096.0, 0.5), Irregularity(0.0, 1.0))
    acting = tones(IMAGE, outer_forces(IMAGE.pencil, [Load(0), Load(0)]), rough)
    unit = IMAGE.column(np.zeros(IMAGE.size), np.array([1.0, 0.0]))
    for t in (0.0, 0.3, 2.0):
        value = sum((tone.column * np.exp(1j * tone.frequency * t)).real for tone in acting)
        assert value == pytest.approx(2 * (np.sin(t + 0.5) - np.sin(0.5)) * unit, abs=1e-12 * np.abs(unit).max())


def test_nothing_acts_where_all_is_0() -> None:
    assert tones(IMAGE, outer_forces(IMAGE.pencil, [Load(0), Load(0)]), ()) == ()
    assert not transform((), np.ones(3), 7).any()


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
