"""Lagrange's equations give the matrices that the numerical models hold, for all parameters at once."""

from __future__ import annotations

from types import SimpleNamespace
from typing import Any

import pytest
import sympy as sp
from vehicle_models import TYPICAL

from mpsolve import vehicles
from mpsolve.derivation.tracks import symbols_of
from mpsolve.derivation.vehicles import Energies, energies
from mpsolve.vehicles.vehicle import Pencil


def pencil_of(model: type[Any], names: Any) -> Pencil:
    """The pencil of a model whose parameters are symbols."""
    return type.__getattribute__(model, "pencil").fget(names)


def same(found: Energies, pencil: Pencil, values: dict[Any, Any]) -> bool:
    for derived, exact in zip(found.matrices, (pencil.M, pencil.C, pencil.K, pencil.B), strict=True):
        if sp.expand(derived.subs(values) - sp.Matrix([[sp.sympify(x) for x in row] for row in exact])).norm() != 0:
            return False
    places = [
        sp.expand(place.subs(values) - sp.sympify(x))
        for (place, _), x in zip(found.contacts, pencil.places, strict=True)
    ]
    return not any(places)


@pytest.mark.parametrize("model", [vehicles.Mass, vehicles.Oscillator, vehicles.Bogie])
def test_the_matrices_are_those_that_are_computed_with(model: type[Any]) -> None:
    names = symbols_of(model)
    names.k_contact = None
    if model is vehicles.Bogie:
        assert same(energies(model, body=True), pencil_of(model, names), {})
        names.body = None
    assert same(energies(model), pencil_of(model, names), {})


def test_so_are_those_of_a_coach() -> None:
    """The contacts are sorted by place: a long coach, so that symbols can be compared."""
    names, under = symbols_of(vehicles.Coach), symbols_of(vehicles.Bogie)
    gap = sp.Symbol("gap", positive=True)
    long = {names.pivots: under.wheelbase + gap}
    under.inertia = sp.Symbol("inertia_bogie", positive=True)
    under.k_contact = under.body = None
    names.pivots = under.wheelbase + gap
    names.bogie = SimpleNamespace(pencil=pencil_of(vehicles.Bogie, under))
    assert same(energies(vehicles.Coach), pencil_of(vehicles.Coach, names), long)


@pytest.mark.parametrize("name", ["mass", "oscillator", "bogie", "coach"])
def test_the_typical_ones_at_their_numbers(name: str) -> None:
    vehicle = TYPICAL[name]
    found = energies(type(vehicle), body=getattr(vehicle, "body", None) is not None)
    values = {sp.Symbol(key, positive=True): x for key, x in vehicle.parameters.items() if key != "bogie"}
    if name == "coach":
        inner = {sp.Symbol("inertia_bogie" if k == "inertia" else k, positive=True): x
                 for k, x in vehicle.bogie.parameters.items() if k not in ("k2", "c2")}  # fmt: skip
        values = inner | values
    assert same(found, vehicle.pencil, {key: sp.Rational(x) for key, x in values.items()})


def test_the_equations_are_those_of_the_matrices() -> None:
    found = energies(vehicles.Bogie, body=True)
    M, C, K, _ = found.matrices
    y = sp.Matrix(found.coordinates)
    (t,) = found.coordinates[0].args
    left = M * y.diff(t, 2) + C * y.diff(t) + K * y
    assert sp.expand(left - sp.Matrix(found.equations)).norm() == 0
