"""A free vehicle rises as a whole without strain; a held one has no such motion."""

from __future__ import annotations

from fractions import Fraction
from typing import Any

from hypothesis import given, settings
from vehicle_models import TYPICAL, random_vehicles

from mpsolve import vehicles
from mpsolve.vehicles.bounce import rigid_bounce


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
