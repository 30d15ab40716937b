"""The outer forces of a problem on the coordinates of its vehicles: its weights, or what was given.

The motion of a vehicle as a whole carries its weights.
"""

from __future__ import annotations

from collections.abc import Mapping, Set
from dataclasses import dataclass
from fractions import Fraction
from typing import Any

import numpy as np

from mpsolve.errors import InputError
from mpsolve.numbers.linear import kernel
from mpsolve.vehicles.load import GRAVITY, Load
from mpsolve.vehicles.vehicle import Pencil

Term = tuple[tuple[Fraction, ...], Load]
"""A load and the direction in which it acts on the coordinates."""


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


def exact_forces(pencil: Pencil, loads: Any) -> list[Term]:
    """The forces: one `Load` for each contact from rear to front, or by names; by default the weights."""
    if loads is None:
        return [(_weights(pencil), Load(1))]
    if isinstance(loads, Mapping):
        given = [(f"loads[{name!r}]", _named(pencil, name), one) for name, one in loads.items()]
    elif isinstance(loads, (str, bytes, Set)) or not hasattr(loads, "__iter__"):
        raise InputError("loads", f"is {type(loads).__name__}: give one Load for each contact, or a dict by names")
    else:
        listed = tuple(loads)
        if len(listed) != pencil.contacts:
            stated = f"has {len(listed)} loads for {pencil.contacts} contacts"
            raise InputError("loads", f"{stated}: give one for each, from rear to front")
        columns = zip(*pencil.B, strict=True)
        given = [(f"loads[{j}]", *both) for j, both in enumerate(zip(columns, listed, strict=True), 1)]
    for key, _, one in given:
        if not isinstance(one, Load):
            raise InputError(key, f"is {type(one).__name__}, not a Load: write Load(constant=…)")
    return [(direction, one) for _, direction, one in given]


def outer_forces(pencil: Pencil, loads: Any) -> Outer:
    """The same in float64."""
    terms = exact_forces(pencil, loads)
    rows = [(one.constant, one.amplitude, one.frequency, one.phase) for _, one in terms]
    table, direction = (
        np.array(some, float).reshape(-1, width)
        for some, width in ((rows, 4), ([direction for direction, _ in terms], pencil.size))
    )
    return Outer(direction.T, *table.T)


def _named(pencil: Pencil, name: Any) -> tuple[Fraction, ...]:
    if name not in pencil.names:
        known = ", ".join(pencil.names)
        raise InputError("loads", f"names {name!r}, which the vehicles do not have: they have {known}")
    return tuple(Fraction(int(name == other)) for other in pencil.names)


def _weights(pencil: Pencil) -> tuple[Fraction, ...]:
    bounce = rigid_bounce(pencil)
    if bounce is None:
        stated = "are missing, and the weights are not known: the vehicle has no vertical motion that strains nothing"
        raise InputError("loads", f"{stated}: give one Load for each contact, or a [[load]] in a file")
    masses = (sum((m * r for m, r in zip(row, bounce, strict=True)), Fraction(0)) for row in pencil.M)
    return tuple(GRAVITY.as_fraction() * mass for mass in masses)


def rigid_bounce(pencil: Pencil) -> tuple[Fraction, ...] | None:
    """The motion that lifts every contact by 1 and strains nothing, unique where there is one; None where not."""
    size = pencil.size
    rows = [[*row, Fraction(0)] for row in (*pencil.K, *pencil.C)]
    rows += [[*(row[j] for row in pencil.B), Fraction(-1)] for j in range(pencil.contacts)]
    found = [vector for vector in kernel(rows, size + 1) if vector[size]]
    if not found:
        return None
    return tuple(x / found[0][size] for x in found[0][:size])
