"""A motion as a table: CSV for people and spreadsheets, NPZ for programs; headers with units."""

from __future__ import annotations

from typing import Any

import numpy as np

from mpsolve.vibration.motion import Vibration

_ARRAYS = "times places rail steady steady_harmonic harmonic transient contact_force within"
_PARTS = {"w": "rail", "steady": "steady", "harmonic": "harmonic", "transient": "transient"}


def unit_of(name: str) -> str:
    """Of a coordinate."""
    return "rad" if "pitch" in name else "m"


def columns(found: Vibration) -> dict[str, Any]:
    """Name and values of each column by time, in SI: rail and its parts, coordinates, contact forces.

    The last one is 1 up to the first lift-off and 0 beyond it, where the model does not hold.
    """
    table = {"t [s]": found.times}
    for k, place in enumerate(found.places):
        at = repr(float(place)).removesuffix(".0")  # all its digits: two places are two columns
        for name, part in _PARTS.items():
            table[f"{name} at x = {at} m [m]"] = getattr(found, part)[k]
    for name, row in found.vehicle.items():
        table[f"{name} [{unit_of(name)}]"] = row
    for j, row in enumerate(found.contact_force, 1):
        table[f"contact force {j} [N]"] = row
    table["within the model [1]"] = found.within.astype(float)
    return table


def arrays(found: Vibration) -> dict[str, Any]:
    """The arrays of the motion under their names, in SI; vehicle (coordinates, times), `names` of these."""
    out: dict[str, Any] = {name: getattr(found, name) for name in _ARRAYS.split()}
    out["vehicle"] = np.array(list(found.vehicle.values()))
    out["names"] = np.array(list(found.vehicle))
    out["q"] = np.array([part.q for part in found.induced], complex)
    return out
