"""A response as a table: CSV for people and spreadsheets, NPZ for programs; written whole or not at all."""

from __future__ import annotations

from typing import Any

import numpy as np

from mpsolve.vibration.case_motion import Response
from mpsolve.vibration.case_units import Scale

_ARRAYS = "xi tau w steady steady_harmonic harmonic transient velocity acceleration contact_forces within"
_PARTS = ("w", "steady", "harmonic", "transient")


def columns(found: Response, scale: Scale) -> dict[str, Any]:
    """Name and values of each column, by time: the four displacements at each ξ, the contact force of each mass.

    The last one is 1 up to the first lift-off and 0 beyond it. In the units of `scale`, which the names tell where
    they are physical.
    """
    table = time_columns(found.tau, scale)
    for k, place in enumerate(found.xi):
        at = repr(float(place)).removesuffix(".0")  # all its digits: two places are two columns
        for part in _PARTS:
            table[named(f"{part}[xi={at}]", scale.length_name, scale)] = getattr(found, part)[k] * scale.length
    for j, row in enumerate(found.contact_forces, 1):
        table[named(f"contact_force[{j}]", scale.force_name, scale)] = row * scale.force
    table[named("within the model", "1", scale)] = found.within.astype(float)
    return table


def time_columns(tau: Any, scale: Scale) -> dict[str, Any]:
    """τ, and t where there is a unit of time."""
    return {"tau": tau} | ({"t [s]": tau * scale.time} if scale.physical else {})


def named(name: str, unit: str, scale: Scale) -> str:
    """The name of a column with its unit, if it has one."""
    return f"{name} [{unit}]" if scale.physical else name


def arrays(found: Response, scale: Scale) -> dict[str, Any]:
    """The arrays of the response under their names, dimensionless; `units` tells what one of them is.

    units: of τ in `unit_names[0]`, of displacements in [1], of forces in [2].
    """
    out: dict[str, Any] = {name: getattr(found, name) for name in _ARRAYS.split()}
    out["units"] = np.array([scale.time, scale.length, scale.force])
    out["unit_names"] = np.array([scale.time_name, scale.length_name, scale.force_name])
    return out | {"q": np.array([pair.q for pair in found.harmonic_pairs], complex)}
