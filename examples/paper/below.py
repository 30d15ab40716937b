"""One root that is unstable all over a range, whatever the others do: on an undamped track, too."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import replace
from typing import Any

import numpy as np

from mpsolve.characteristic.free_matrix import FreeMatrix
from mpsolve.errors import EffortError
from mpsolve.loci.chain import Chain, follow
from mpsolve.loci.room import Room
from mpsolve.loci.tube import Tubes
from mpsolve.numbers.balls import acb, precision
from mpsolve.numbers.plain import disc_of
from mpsolve.problem.family import Interval, family_of
from mpsolve.problem.problem import Problem
from mpsolve.proof.effort import Effort

_BOXES = 100_000
_SMALLEST = 2.0**-40


def stays_below(problem: Problem, over: Mapping[str, Interval], q: Any, effort: Effort | None = None) -> bool:
    """Whether the root in the ball q at the start of the range is proved to go on with Im q < 0 up to its end.

    The discs in which its tubes hold it lie below the real axis; what is continued beyond the axis plays no part.
    """
    family = family_of(problem, over)
    ((low, high),) = family.box
    ends = math.nextafter(float(low), -math.inf), math.nextafter(float(high), math.inf)
    with precision(64):
        scaled = acb(q) / family.frequency_unit.numerator * family.frequency_unit.denominator
    at, radius = disc_of(scaled)
    matrix, room = FreeMatrix(family), Room(*ends, -(2.0**-40))
    chain = Chain(ends[0], at, radius, 1, ahead=math.nextafter(float(low), math.inf))
    kept, budget = [replace(chain, tubes=[])], effort or Effort(evaluations=_BOXES)

    def stop(chain: Chain) -> str | None:
        if not _below(chain.tubes[-1]):
            return "above"
        kept[0] = replace(chain, tubes=[])
        return None

    try:
        follow(matrix, [chain], room, budget, stop, lambda _: None)
        while chain.end == "above" and kept[0].size > _SMALLEST:
            kept[0].size, kept[0].step = kept[0].size / 4, kept[0].step / 4
            chain = replace(kept[0], tubes=[])
            follow(matrix, [chain], room, budget, stop, lambda _: None)
    except EffortError:
        return False
    return bool(chain.end == "range")


def _below(tube: Tubes) -> bool:
    """Whether the root is proved to have Im q < 0 all along a tube."""
    top = np.maximum(tube.centre(tube.low).imag, tube.centre(tube.high).imag) + tube.inner
    return bool((top < 0).all())
