"""The outer forces of a problem on the coordinates of its vehicles: its weights, or what was given."""

from __future__ import annotations

from collections.abc import Mapping, Set
from dataclasses import dataclass
from typing import Any

import numpy as np

from mpsolve.errors import InputError
from mpsolve.vehicles.bounce import rigid_bounce
from mpsolve.vehicles.load import GRAVITY, Load
from mpsolve.vehicles.vehicle import Pencil


@dataclass(frozen=True)
class Outer:
    """g(t) = Σ_k direction_k · (constant_k + amplitude_k sin(frequency_k t + phase_k)); directions (size, terms)."""

    direction: Any
    constant: Any
    amplitude: Any
    frequency: Any
    phase: Any

    @property
    def fastest(self) -> float:
        """The highest frequency that acts."""
        acting = self.amplitude != 0
        return float(np.max(np.abs(self.frequency[acting]))) if acting.any() else 0.0


def outer_forces(pencil: Pencil, loads: Any) -> Outer:
    """The forces: one `Load` for each contact from rear to front, or by names; by default the weights."""
    if loads is None:
        return _weights(pencil)
    if isinstance(loads, Mapping):
        return _by_name(pencil, loads)
    if isinstance(loads, (str, bytes, Set)) or not hasattr(loads, "__iter__"):
        raise InputError("loads", f"is {type(loads).__name__}: give one Load for each contact, or a dict by names")
    given = tuple(loads)
    if len(given) != pencil.contacts:
        stated = f"has {len(given)} loads for {pencil.contacts} contacts"
        raise InputError("loads", f"{stated}: give one for each, from rear to front")
    return _outer([(f"loads[{j}]", one) for j, one in enumerate(given, 1)], np.array(pencil.B, float))


def _by_name(pencil: Pencil, loads: Mapping[Any, Any]) -> Outer:
    columns = []
    for name in loads:
        if name not in pencil.names:
            known = ", ".join(pencil.names)
            raise InputError("loads", f"names {name!r}, which the vehicles do not have: they have {known}")
        columns.append([float(other == name) for other in pencil.names])
    direction = np.array(columns).reshape(-1, pencil.size).T
    return _outer([(f"loads[{name!r}]", one) for name, one in loads.items()], direction)


def _outer(given: list[tuple[str, Any]], direction: Any) -> Outer:
    for key, one in given:
        if not isinstance(one, Load):
            raise InputError(key, f"is {type(one).__name__}, not a Load: write Load(constant=…)")
    rows = [(one.constant, one.amplitude, one.frequency, one.phase) for _, one in given]
    table = np.array([[float(x) for x in row] for row in rows]).reshape(-1, 4)
    return Outer(direction, *table.T)


def _weights(pencil: Pencil) -> Outer:
    bounce = rigid_bounce(pencil)
    if bounce is None:
        stated = "are missing, and the weights are not known: the vehicle has no vertical motion that strains nothing"
        raise InputError("loads", f"{stated}: give one Load for each contact, or a [[load]] in a file")
    weight = float(GRAVITY) * np.array(
        [float(sum(m * r for m, r in zip(row, bounce, strict=True))) for row in pencil.M]
    )
    return Outer(weight[:, None], np.ones(1), np.zeros(1), np.zeros(1), np.zeros(1))
