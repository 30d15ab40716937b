"""The roots of a line at given values of the parameter, to any number of digits."""

from __future__ import annotations

import math
from collections.abc import Iterator
from fractions import Fraction
from typing import Any

from mpsolve.characteristic.proved import Proved
from mpsolve.errors import PrecisionError
from mpsolve.loci.grow import Strand
from mpsolve.numbers.balls import acb, arb, precision
from mpsolve.numbers.plain import outward
from mpsolve.problem.family import Family
from mpsolve.problem.reduced import reduce_problem
from mpsolve.spectrum.enclose import enclose


def roots_at(
    family: Family, strand: Strand, values: tuple[Fraction, ...], digits: int
) -> Iterator[tuple[Fraction, Any | None]]:
    """(value, ball) at each value at which the line is there; None for the ball where it is not enclosed."""
    unit = family.units[0]
    first, last = strand.low[1], strand.high[0]
    for value in values:
        x = value / unit
        if Fraction(first) <= x <= Fraction(last):
            yield value, _root(family, strand, value, x, digits)


def _root(family: Family, strand: Strand, value: Fraction, x: Fraction, digits: int) -> Any | None:
    """The only root near the tube at x̂, if it lies in the tube."""
    tube = strand.tube_at(min(max(float(x), float(strand.tubes.low[0])), float(strand.tubes.high[-1])))
    if tube is None:
        return None
    centre = complex(tube.guess(float(x))[0])
    if strand.on_axis:
        centre = complex(0, centre.imag)
    unit = float(family.frequency_unit)
    reduced = reduce_problem(family.problem.changed(family.paths[0], value))
    try:
        q = enclose(Proved(reduced), 1j * centre * unit / float(reduced.frequency_unit), digits).q
    except PrecisionError:
        return None
    with precision(64):
        scaled = q / unit
        at = acb(scaled.mid())
        away = outward(arb((scaled - at).abs_upper()), up=True)
    reach = math.nextafter(float(x), -math.inf), math.nextafter(float(x), math.inf)
    middle = complex(at)
    inside = all(bool(tube.holds(middle, away + 2.0**-50 * abs(middle), y)[0]) for y in reach)
    return q if inside else None
