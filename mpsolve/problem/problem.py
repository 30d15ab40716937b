"""A problem as exact data: a track, vehicles at their places, and the velocity of all of them."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from fractions import Fraction
from typing import Any

from mpsolve.errors import InputError
from mpsolve.numbers.model import rational, shown
from mpsolve.tracks.waveguide import Track, Waveguide
from mpsolve.vehicles.vehicle import Pencil, Placed, Vehicle, checked_pencil


@dataclass(frozen=True, init=False)
class Problem:
    """Vehicles that move at the velocity v along a track; one consistent set of units, SI by default.

    vehicles: any number of vehicles at their places (`Mass("900").at("2.5")`), in any order; a bare one stands at 0.
    v ≥ 0. InputError names the argument that cannot be used.
    """

    track: Track | Waveguide
    vehicles: tuple[Placed, ...]
    v: Fraction

    def __init__(self, track: Any, vehicles: Any, v: object) -> None:
        if not isinstance(track, (Track, Waveguide)):
            raise InputError("track", f"is of type {type(track).__name__}: give one of mpsolve.tracks")
        velocity = rational(v, "v")
        if velocity < 0:
            raise InputError("v", f"is {shown(velocity)}, but must not be below 0: x runs ahead, turn the vehicles round")
        placed = _placed(vehicles)
        if not placed:
            raise InputError("vehicles", "is empty: give at least one vehicle")
        vars(self).update(track=track, vehicles=placed, v=velocity)

    @property
    def pencil(self) -> Pencil:
        """All vehicles as one: bodies in the order of the vehicles, contacts from rear to front."""
        return checked_pencil(_together([(placed.vehicle.pencil, placed.position) for placed in self.vehicles]))


def _placed(vehicles: Any) -> tuple[Placed, ...]:
    entries = vehicles if isinstance(vehicles, Iterable) and not isinstance(vehicles, Vehicle) else [vehicles]
    out: list[Placed] = []
    for j, entry in enumerate(entries, 1):
        if isinstance(entry, Vehicle):
            out.append(entry.at(0))
        elif isinstance(entry, Placed):
            out.append(entry)
        else:
            given = type(entry).__name__
            raise InputError(f"vehicles[{j}]", f"is of type {given}: give a vehicle, or a vehicle.at(x)")
    return tuple(out)


def _together(parts: list[tuple[Pencil, Fraction]]) -> Pencil:
    """The vehicles as one pencil with contacts sorted by place."""
    order = sorted(
        ((position + place, k, j) for k, (pencil, position) in enumerate(parts) for j, place in enumerate(pencil.places))
    )
    size = sum(pencil.size for pencil, _ in parts)
    blocks: dict[str, list[list[Fraction]]] = {key: [[Fraction(0)] * size for _ in range(size)] for key in "MCK"}
    B = [[Fraction(0)] * len(order) for _ in range(size)]
    names: list[str] = []
    column = {(k, j): i for i, (_, k, j) in enumerate(order)}
    for k, (pencil, _) in enumerate(parts):
        first = len(names)
        for key, matrix in blocks.items():
            for i, row in enumerate(getattr(pencil, key)):
                matrix[first + i][first : first + pencil.size] = row
        for i, row in enumerate(pencil.B):
            for j, value in enumerate(row):
                B[first + i][column[k, j]] = value
        names += [name if len(parts) == 1 else f"{name} of vehicle {k + 1}" for name in pencil.names]
    h = tuple(parts[k][0].h[j] for _, k, j in order)
    M, C, K = (tuple(tuple(row) for row in blocks[key]) for key in "MCK")
    return Pencil(M, C, K, tuple(map(tuple, B)), tuple(place for place, _, _ in order), h, tuple(names))
