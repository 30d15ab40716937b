"""Motions as tables: columns with units for CSV, arrays for programs; of a problem in SI, of a case of the paper."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import numpy as np

from mpsolve.numbers.arrays import Reals
from mpsolve.vibration.case_motion import Response, Scale
from mpsolve.vibration.motion import Vibration

_ARRAYS = "times places rail steady steady_harmonic harmonic transient contact_force within"
_PARTS = {"w": "rail", "steady": "steady", "harmonic": "harmonic", "transient": "transient"}
_CASE_ARRAYS = "xi tau w steady steady_harmonic harmonic transient velocity acceleration contact_forces within"
_CASE_PARTS = ("w", "steady", "harmonic", "transient")


def unit_of(name: str) -> str:
    """Of a coordinate."""
    return "rad" if "pitch" in name else "m"


def columns(found: Vibration) -> dict[str, Reals]:
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
    return _known(table)


def _known(table: dict[str, Reals]) -> dict[str, Reals]:
    """Without the times that an effort did not reach."""
    rows = np.isfinite(list(table.values())).all(0)
    return {name: values[rows] for name, values in table.items()}


def arrays(found: Vibration) -> dict[str, Reals]:
    """The arrays of the motion under their names, in SI; vehicle (coordinates, times), `names` of these."""
    out: dict[str, Any] = {name: getattr(found, name) for name in _ARRAYS.split()}
    out["vehicle"] = np.array(list(found.vehicle.values()))
    out["names"] = np.array(list(found.vehicle))
    out["q"] = np.array([part.q for part in found.induced], complex)
    return out


def deflection(found: Vibration | Response) -> Any:
    """At its first place, over the times."""
    return (found.w if isinstance(found, Response) else found.rail)[0]


def comparison(whole: Vibration | Response, curves: Mapping[str, Any], scale: Scale | None = None) -> dict[str, Any]:
    """Deflections at one place by their names, over the times of `whole`; in SI, or in the units of `scale`."""
    if isinstance(whole, Vibration):
        table = {"t [s]": whole.times} | {f"{name} [m]": row for name, row in curves.items()}
        return table | {"within the model [1]": whole.within.astype(float)}
    scale = scale or Scale()
    shown = {named(name, scale.length_name, scale): row * scale.length for name, row in curves.items()}
    within = {named("within the model", "1", scale): whole.within.astype(float)}
    return time_columns(whole.tau, scale) | shown | within


def case_columns(found: Response, scale: Scale) -> dict[str, Reals]:
    """Name and values of each column, by time: the four displacements at each ξ, the contact force of each mass.

    The last one is 1 up to the first lift-off and 0 beyond it. In the units of `scale`, which the names tell where
    they are physical.
    """
    table = time_columns(found.tau, scale)
    for k, place in enumerate(found.xi):
        at = repr(float(place)).removesuffix(".0")  # all its digits: two places are two case_columns
        for part in _CASE_PARTS:
            table[named(f"{part}[xi={at}]", scale.length_name, scale)] = getattr(found, part)[k] * scale.length
    for j, row in enumerate(found.contact_forces, 1):
        table[named(f"contact_force[{j}]", scale.force_name, scale)] = row * scale.force
    table[named("within the model", "1", scale)] = found.within.astype(float)
    return _known(table)


def time_columns(tau: Reals, scale: Scale) -> dict[str, Reals]:
    """τ, and t where there is a unit of time."""
    return {"tau": tau} | ({"t [s]": tau * scale.time} if scale.physical else {})


def named(name: str, unit: str, scale: Scale) -> str:
    """The name of a column with its unit, if it has one."""
    return f"{name} [{unit}]" if scale.physical else name


def case_arrays(found: Response, scale: Scale) -> dict[str, Any]:
    """The case_arrays of the response under their names, dimensionless; `units` tells what one of them is.

    units: of τ in `unit_names[0]`, of displacements in [1], of forces in [2].
    """
    out: dict[str, Any] = {name: getattr(found, name) for name in _CASE_ARRAYS.split()}
    out["units"] = np.array([scale.time, scale.length, scale.force])
    out["unit_names"] = np.array([scale.time_name, scale.length_name, scale.force_name])
    return out | {"q": np.array([pair.q for pair in found.harmonic_pairs], complex)}
