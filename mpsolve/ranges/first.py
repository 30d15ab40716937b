"""An onset asks for a range up to itself only: a second try where the rest of the range stays open."""

from __future__ import annotations

from collections.abc import Mapping
from fractions import Fraction

from mpsolve.proof.effort import Effort
from mpsolve.ranges.answer import Interval
from mpsolve.ranges.crossings import Crossings, short_between

BEYOND = "nothing is said of larger values"


def up_to_first(found: Crossings) -> Mapping[str, Interval] | None:
    """Of a range whose end is open: up to a little beyond the first crossing that was found; None where none was."""
    ((path, (low, high)),) = found.over.items()
    if found.counts is not None or found.parts or not found.crossings or high is None:
        return None
    first, beyond = found.crossings[0], (*found.crossings[1:2],)
    near = Fraction(first.upper)
    far = min(high, Fraction(beyond[0].lower)) if beyond else high
    return {path: (low, short_between(near, near + (far - near) / 8))} if low < near < far else None


def quarter(effort: Effort | None) -> Effort | None:
    """A quarter of it."""
    if effort is None:
        return None
    seconds = None if effort.seconds is None else effort.seconds / 4
    return Effort(seconds, None if effort.evaluations is None else max(effort.evaluations // 4, 1))
