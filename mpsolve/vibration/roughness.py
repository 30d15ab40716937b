"""Irregularities of rail and wheels as harmonic inputs: one for each contact, from rear to front."""

from __future__ import annotations

from math import pi
from typing import Any

from mpsolve.errors import InputError
from mpsolve.numbers.model import rational
from mpsolve.problem.problem import Problem
from mpsolve.vibration.forcing import Irregularity


def rail_roughness(problem: Problem, amplitude: Any, wavelength: Any, phase: float = 0.0) -> tuple[Irregularity, ...]:
    """A wave on the rail, amplitude · sin(2πx/wavelength + phase) upwards, as every contact runs over it.

    Contacts meet it one after the other: that at ξ sees 2π(vt + ξ)/wavelength + phase. amplitude, wavelength in m.

    >>> from mpsolve import tracks, vehicles
    >>> pair = Problem(tracks.String(T=1, m=1, k=1, c=1), vehicles.train(vehicles.Mass(1), 2, "0.5"), v=3)
    >>> [round(one.phase, 3) for one in rail_roughness(pair, "1e-5", 2)]
    [0.0, 1.571]
    """
    size, length = rational(amplitude, "amplitude"), _positive(wavelength, "wavelength")
    turn = 2 * pi / length
    omega = turn * float(problem.v)
    return tuple(Irregularity(float(size), omega, turn * float(x) + phase) for x in problem.pencil.places)


def out_of_round(
    problem: Problem, amplitude: Any, radius: Any, order: int = 1, contact: int | None = None
) -> tuple[Irregularity, ...]:
    """Wheels of this radius whose tread swells and shrinks `order` times a turn, amplitude · sin(order · v t/radius).

    contact: the only one whose wheel is so, counted from 1 at the rear; without it all are. amplitude, radius in m.
    """
    size, length = float(rational(amplitude, "amplitude")), _positive(radius, "radius")
    count = problem.pencil.contacts
    if isinstance(order, bool) or not isinstance(order, int) or order < 1:
        raise InputError("order", f"is {order!r}: give a whole number from 1 on")
    if contact is not None and (
        isinstance(contact, bool) or not isinstance(contact, int) or not 1 <= contact <= count
    ):
        raise InputError("contact", f"is {contact!r}: give a whole number from 1 to {count}")
    omega = order * float(problem.v) / length
    return tuple(Irregularity(size if contact in (None, j) else 0.0, omega) for j in range(1, count + 1))


def _positive(value: Any, key: str) -> float:
    number = float(rational(value, key))
    if number <= 0:
        raise InputError(key, f"is {number:g}, not above 0: give a length in m")
    return number
