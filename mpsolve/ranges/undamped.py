"""Ranges in which an undamped beam lets no passive vehicle grow: the theorem of its greatest velocity holds for all.

The bracket EI y² − (N + m v²) y + k of `spectrum.lossless` falls as v grows, and knows nothing of the masses.
"""

from __future__ import annotations

from collections.abc import Mapping

from mpsolve.errors import InputError
from mpsolve.problem.family import Interval
from mpsolve.problem.line import on_line
from mpsolve.problem.problem import Problem
from mpsolve.problem.reduced import reduce_problem
from mpsolve.spectrum.lossless import passive_everywhere

NOTE = "the undamped beam takes up power at all frequencies and velocities of the range: no boxes are needed"
_FREE = ("v", "scale.mass")  # what the theorem lets vary


def never_unstable(problem: Problem, over: Mapping[str, Interval]) -> bool:
    """Whether nothing grows at any point of the ranges; False where the theorem does not tell."""
    if not set(over) <= set(_FREE):
        return False
    fastest = max(map(abs, over.get("v", (problem.v,))))
    try:
        line = on_line(reduce_problem(problem.changed("v", fastest)))
    except InputError:
        return False
    return line is not None and passive_everywhere(line)
