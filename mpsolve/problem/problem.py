"""A problem as exact data: a track, vehicles at their places, and the velocity of all of them."""

from __future__ import annotations

from collections.abc import Iterable
from fractions import Fraction
from typing import Any

from mpsolve.errors import InputError
from mpsolve.frozen import frozen
from mpsolve.numbers.model import Quantity, rational, shown, typed
from mpsolve.problem.parameters import changed, parameters_of, quantity_of
from mpsolve.tracks.waveguide import Track, Waveguide
from mpsolve.vehicles.vehicle import AnyVehicle, Pencil, Placed, checked_pencil, joined

_MOST = 2000
"""Coordinates of all vehicles together."""


@frozen
class Problem:
    """Vehicles that move at the velocity v along a track; one consistent set of units, SI by default.

    A text may carry a unit of its own ("360 km/h"), which is converted to SI.
    vehicles: any number of vehicles at their places (`Mass("900").at("2.5")`) and trains of them, in any order; a
    bare one stands at 0.
    v ≥ 0. InputError names the argument that cannot be used.
    """

    track: Track | Waveguide
    vehicles: tuple[Placed, ...]
    v: Fraction

    def __init__(self, track: Any, vehicles: Any, v: object) -> None:
        if not isinstance(track, (Track, Waveguide)):
            raise InputError("track", f"is of type {type(track).__name__}: give one of mpsolve.tracks")
        velocity = rational(v, "v", "m/s", "velocity")
        if velocity < 0:
            raise InputError(
                "v", f"is {shown(velocity, v)}, but must not be below 0: x runs ahead, turn the vehicles round"
            )
        placed = _placed(vehicles)
        if not placed:
            raise InputError("vehicles", "is empty: give at least one vehicle")
        vars(self).update(track=track, vehicles=placed, v=velocity)

    def __repr__(self) -> str:
        return f"Problem({self.track!r}, {list(self.vehicles)!r}, v={typed(self.v)})"

    @property
    def parameters(self) -> dict[str, Fraction]:
        """Every parameter by its path (mpsolve/problem/parameters.py) with its value."""
        return parameters_of(self.track, self.vehicles, self.v)

    def quantity(self, path: str) -> Quantity:
        """Unit, meaning and bound of the parameter at `path`; InputError lists the paths there are."""
        return quantity_of(self.track, self.vehicles, self.v, path)

    def changed(self, path: str, value: object) -> Problem:
        """The same problem with the parameter at `path` set to `value`; InputError lists the paths there are.

        >>> from mpsolve import tracks, vehicles
        >>> Problem(tracks.String(T=1, m=1), vehicles.Mass(2), v=0).changed("scale.mass", 3).vehicles[0].vehicle.M
        Fraction(6, 1)
        """
        return Problem(*changed(self.track, self.vehicles, self.v, path, value))

    @property
    def pencil(self) -> Pencil:
        """All vehicles as one: bodies in the order of the vehicles, contacts from rear to front."""
        one = len(self.vehicles) == 1
        endings = ["" if one else f" of vehicle {k}" for k in range(1, len(self.vehicles) + 1)]
        pencils = [placed.vehicle.pencil for placed in self.vehicles]
        size = sum(pencil.size for pencil in pencils)
        if size > _MOST:  # matrices of this size are kept whole
            raise InputError("vehicles", f"have {size} coordinates together: give vehicles with at most {_MOST}")
        pencils = [checked_pencil(pencil) for pencil in pencils]
        places = [placed.position for placed in self.vehicles]
        return joined(list(zip(pencils, places, endings, strict=True)))


def require_problem(given: Any) -> None:
    """InputError for anything else than a Problem."""
    if not isinstance(given, Problem):
        raise InputError("problem", f"is of type {type(given).__name__}: give a Problem")


def _placed(vehicles: Any) -> tuple[Placed, ...]:
    entries = vehicles if _many(vehicles) else [vehicles]
    flat = [(j, one) for j, entry in enumerate(entries, 1) for one in (entry if _many(entry) else [entry])]
    out: list[Placed] = []
    for j, entry in flat:
        if isinstance(entry, AnyVehicle):
            out.append(entry.at(0))
        elif isinstance(entry, Placed):
            out.append(entry)
        else:
            given = type(entry).__name__
            raise InputError(f"vehicles[{j}]", f"is of type {given}: give a vehicle, a vehicle.at(x), or a train")
    return tuple(out)


def _many(entry: Any) -> bool:
    return isinstance(entry, Iterable) and not isinstance(entry, (str, bytes, AnyVehicle, Placed))
