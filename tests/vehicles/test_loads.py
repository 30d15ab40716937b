"""Weights by default, loads by contacts, and by names."""

from __future__ import annotations

from fractions import Fraction
from typing import Any

import numpy as np
import pytest
from hypothesis import given, settings
from vehicle_models import TYPICAL, random_vehicles

from mpsolve import vehicles
from mpsolve.vehicles.load import Load
from mpsolve.vehicles.loads import exact_forces, outer_forces, rigid_bounce
from mpsolve.vehicles.mass import Mass


@pytest.mark.parametrize("name", ["mass", "oscillator", "bogie", "coach"])
def test_weights_act_on_masses_and_not_on_inertias(name: str) -> None:
    pencil = TYPICAL[name].pencil
    found = outer_forces(pencil, None)
    masses = [0 if "pitch" in body else float(pencil.M[i][i]) for i, body in enumerate(pencil.names)]
    assert found.direction[:, 0] == pytest.approx(9.80665 * np.array(masses), rel=1e-14)
    assert (found.constant, found.amplitude, found.fastest) == (1, 0, 0)


def test_loads_press_the_contacts_or_the_bodies_that_are_named() -> None:
    pencil = TYPICAL["bogie"].pencil
    found = outer_forces(pencil, [Load(3), Load(1, 2, 50, "0.5")])
    assert found.direction[:, 1].tolist() == [0, 1, 0, 0, 0]
    assert (found.amplitude.tolist(), found.frequency.tolist(), found.fastest) == ([0, 2], [0, 50], 50)
    assert outer_forces(pencil, {"body": Load(3)}).direction[:, 0].tolist() == [0, 0, 0, 0, 1]


def test_weights_are_exact() -> None:
    """g = 9.80665 m/s² times the mass that a rigid bounce moves with each coordinate."""
    ((direction, load),) = exact_forces(Mass("0.1").pencil, None)
    assert direction == (Fraction("0.980665"),)
    assert load == Load(1)


@settings(max_examples=20)
@given(random_vehicles())
def test_a_free_vehicle_rises_without_strain(vehicle: Any) -> None:
    pencil = vehicle.pencil
    bounce = rigid_bounce(pencil)
    assert bounce is not None
    for rows in (pencil.K, pencil.C):
        assert all(sum(a * b for a, b in zip(row, bounce, strict=True)) == 0 for row in rows)
    assert all("pitch" in name or x == 1 for name, x in zip(pencil.names, bounce, strict=True))
    assert all(x == 0 for name, x in zip(pencil.names, bounce, strict=True) if "pitch" in name)


def test_a_held_vehicle_has_no_weight_that_is_known() -> None:
    assert rigid_bounce(vehicles.Vehicle([[1]], [[0]], [[3]], [[1]], [0]).pencil) is None
    assert rigid_bounce(TYPICAL["coach"].pencil) == tuple(
        Fraction(int("pitch" not in name)) for name in TYPICAL["coach"].pencil.names
    )
