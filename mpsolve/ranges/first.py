"""An onset asks for a range up to itself only: as far as floats see the first crossing, and a little beyond."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from fractions import Fraction

from mpsolve.errors import InputError, PrecisionError
from mpsolve.numbers.realroots import short_between
from mpsolve.parallel.threads import one_thread
from mpsolve.problem.family import family_of
from mpsolve.problem.problem import Problem
from mpsolve.ranges.answer import Interval
from mpsolve.ranges.first_seen import first_seen
from mpsolve.ranges.scope import from_above_rest, one_path

BEYOND = "nothing is said of larger values"
_MORE = 32
"""A part of what lies between the start of the range and the crossing: so much more is proved."""


@dataclass(frozen=True)
class Shorter:
    """A part of a range, and the point (q, value) of the crossing seen in it, floats; in the problem's units."""

    over: dict[str, Interval]
    near: tuple[float, float]


def up_to_first(problem: Problem, over: Mapping[str, Interval]) -> Shorter | None:
    """The range up to a little beyond the first crossing; None where none is seen, or the range has no upper end."""
    path = one_path(over)
    if over[path][1] is None:
        return None
    over = from_above_rest(problem, over)
    low, high = over[path]
    try:
        with one_thread():
            family = family_of(problem, over)
            seen = first_seen(family)
    except (InputError, PrecisionError):
        return None
    if seen is None:
        return None
    at = Fraction(seen[1]) * family.units[0]
    far = min(high, at + (at - low) / _MORE)
    if not low < at < far:
        return None
    q = seen[0] * float(family.frequency_unit)
    return Shorter({path: (low, short_between(at + (far - at) / 2, far))}, (q, float(at)))
