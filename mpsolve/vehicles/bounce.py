"""The motion of a vehicle as a whole, which carries its weights."""

from __future__ import annotations

from fractions import Fraction

from mpsolve.numbers.linear import kernel
from mpsolve.vehicles.vehicle import Pencil


def rigid_bounce(pencil: Pencil) -> tuple[Fraction, ...] | None:
    """The motion that lifts every contact by 1 and strains nothing, unique where there is one; None where not."""
    size = pencil.size
    rows = [[*row, Fraction(0)] for row in (*pencil.K, *pencil.C)]
    rows += [[*(row[j] for row in pencil.B), Fraction(-1)] for j in range(pencil.contacts)]
    found = [vector for vector in kernel(rows, size + 1) if vector[size]]
    if not found:
        return None
    return tuple(x / found[0][size] for x in found[0][:size])
