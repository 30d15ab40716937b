"""Equal vehicles in a row."""

from __future__ import annotations

from mpsolve.errors import InputError
from mpsolve.numbers.model import rational, shown, whole
from mpsolve.vehicles.vehicle import AnyVehicle, Placed

_MOST = 1000


def train(vehicle: AnyVehicle, count: int, spacing: object) -> tuple[Placed, ...]:
    """`count` copies of a vehicle whose middles are `spacing` > 0 apart, the rearmost at x = 0.

    >>> from mpsolve.vehicles import Mass
    >>> [str(placed.position) for placed in train(Mass(900), 3, "2.5")]
    ['0', '5/2', '5']
    """
    if not isinstance(vehicle, AnyVehicle):
        raise InputError("vehicle", f"is of type {type(vehicle).__name__}: give one of mpsolve.vehicles, not placed")
    count = whole(count, "count", 1, _MOST)
    gap = rational(spacing, "spacing", "m", "distance of the vehicles")
    if gap <= 0:
        raise InputError("spacing", f"is {shown(gap)}, but must be above 0: give the distance in m")
    return tuple(vehicle.at(k * gap) for k in range(count))
