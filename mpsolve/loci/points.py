"""The roots of a line at given values of the parameter, to any number of digits."""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import replace
from fractions import Fraction
from typing import Any

import numpy as np

from mpsolve.characteristic.free_matrix import FreeMatrix
from mpsolve.characteristic.proved import Proved
from mpsolve.errors import PrecisionError
from mpsolve.loci.grow import Strand
from mpsolve.loci.room import GAP, Room
from mpsolve.loci.tube import Tubes, tubes
from mpsolve.numbers.balls import precision
from mpsolve.numbers.plain import disc_of
from mpsolve.problem.family import Family
from mpsolve.problem.reduced import reduce_problem
from mpsolve.spectrum.enclose import enclose


def roots_at(
    family: Family, matrix: FreeMatrix, room: Room, strand: Strand, values: tuple[Fraction, ...], digits: int
) -> Iterator[tuple[Fraction, Any | None]]:
    """(value, ball) at each value at which the line is there; None for the ball where it is not enclosed."""
    unit = family.units[0]
    first, last = strand.low[1], strand.high[0]
    for value in values:
        x = value / unit
        if Fraction(first) <= x <= Fraction(last):
            tube = _tube(matrix, room, strand, float(x))
            yield value, None if tube is None else _root(family, tube, strand.on_axis, room, value, digits)


def _tube(matrix: FreeMatrix, room: Room, strand: Strand, x: float) -> Tubes | None:
    """One that holds the line's root at x̂ and next to it."""
    low, high = float(strand.tubes.low[0]), float(strand.tubes.high[-1])
    gate = strand.gates[0] if x < low else strand.gates[1] if x > high else None
    if gate is None:
        return strand.tube_at(min(max(x, low), high))
    ends = math.nextafter(x, -math.inf), math.nextafter(x, math.inf)
    gate = gate.at(*ends)
    if gate is None:
        return None
    sizes = 2.0 ** -np.arange(4.0, 20.0, 2.0) * max(room.gap(ends) - abs(gate.q.real), 0.0)
    each = np.ones(len(sizes))
    found = tubes(matrix, ends[0] * each, ends[1] * each, gate.q * each, sizes)
    fits = [room.fits(gate.q, rho, ends, GAP) for rho in sizes.tolist()]
    rows = np.flatnonzero(found.good & fits & found.holds(gate.q, gate.radius, ends[0]))
    return replace(found.take(rows[:1]), kind=np.array([GAP])) if len(rows) else None


def _root(family: Family, tube: Tubes, on_axis: bool, room: Room, value: Fraction, digits: int) -> Any | None:
    """The only root near the tube at x̂, if it lies in the tube."""
    x = float(value / family.units[0])
    centre = complex(tube.guess(x)[0])
    if on_axis:
        centre = complex(0, centre.imag)
    unit = float(family.frequency_unit)
    reduced = reduce_problem(family.problem.changed(family.paths[0], value))
    try:
        q = enclose(Proved(reduced), 1j * centre * unit / float(reduced.frequency_unit), digits).q
    except PrecisionError:
        return None
    with precision(64):
        scaled = q / unit
    middle, away = disc_of(scaled)
    reach = math.nextafter(x, -math.inf), math.nextafter(x, math.inf)
    inside = all(bool(tube.holds(middle, away + 2.0**-50 * abs(middle), y)[0]) for y in reach)
    return q if inside and all(room.holds(scaled, int(tube.kind[0]), y) for y in reach) else None
