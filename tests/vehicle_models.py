"""Vehicles for tests: one typical record of each kind in SI, and random ones."""

from __future__ import annotations

from fractions import Fraction
from typing import Any

from hypothesis import strategies as st

from mpsolve import vehicles
from mpsolve.numbers.model import quantities

BOGIE = {"wheel": 1813, "frame": 2615, "inertia": 1476, "wheelbase": "2.56", "k": "2.4e6", "c": "8e3"}
TYPICAL = {
    "mass": vehicles.Mass(900),
    "oscillator": vehicles.Oscillator(wheel=900, body=5000, k="1e6", c="2e4", k_contact="1.4e9"),
    "bogie": vehicles.Bogie(**BOGIE, k_contact="1.4e9", body=16000, k2="4e5", c2="2e4"),
    "coach": vehicles.Coach(
        body=32000, inertia="1.97e6", bogie=vehicles.Bogie(**BOGIE), pivots=19, k2="4.3e5", c2="2e4"
    ),
    "matrices": vehicles.Vehicle(
        M=[[10, 1], [1, 5]], C=[[1, 0], [0, 0]], K=[[3, -3], [-3, 3]], B=[[1], [0]], places=[0]
    ),
}
"""By name."""


def _values(draw: Any, model: type[Any]) -> dict[str, Any]:
    out: dict[str, Any] = {}
    for name, quantity in quantities(model).items():
        if quantity.optional or name == "bogie":
            continue
        least = 1 if quantity.above == 0 or name in ("k", "k2") else 0
        out[name] = Fraction(draw(st.integers(least, 40)), draw(st.sampled_from([1, 4])))
    if "k_contact" in quantities(model) and draw(st.booleans()):
        out["k_contact"] = draw(st.integers(1, 40))
    return out


@st.composite
def random_vehicles(draw: st.DrawFn) -> vehicles.AnyVehicle:
    """Any model but the one by matrices, with small rational parameters."""
    model = draw(st.sampled_from(vehicles.CATALOGUE[:-1]))
    values = _values(draw, model)
    if model is vehicles.Bogie:
        if draw(st.booleans()):
            values["body"] = 7
        else:
            values["k2"] = values["c2"] = 0
    if model is vehicles.Coach:
        values["bogie"] = vehicles.Bogie(**(_values(draw, vehicles.Bogie) | {"k2": 0, "c2": 0}))
    return model(**values)
