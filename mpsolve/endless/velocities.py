"""Two velocities of a row: from the first on disturbances grow along it, from the second on long trains themselves.

The first is enclosed by proofs at both ends; that nothing grows at any lower velocity, and the second, is computed.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass
from fractions import Fraction
from typing import Any

import numpy as np

from mpsolve.endless.axis import gains
from mpsolve.endless.bloch import Bloch
from mpsolve.endless.infinite_train import EVALUATIONS, InfiniteTrain, decide, long_trains_grow, reach_of
from mpsolve.endless.row import Row, row_of
from mpsolve.errors import InputError
from mpsolve.numbers.model import rational, shown
from mpsolve.numbers.result import Result
from mpsolve.outcome import Reason, Status
from mpsolve.problem.cases import Given
from mpsolve.progress import Progress, silent
from mpsolve.proof.effort import Effort
from mpsolve.spectrum.premises import require_premises
from mpsolve.spectrum.regions import HalfPlane

_GRID = 13
_HALVINGS = 18
_WIDTHS = (1e-4, 1e-3, 1e-2)  # of the proved bracket, relative, about, from the narrowest


@dataclass(frozen=True)
class TrainVelocities(Result):
    """Where an endless row changes between the velocities `low` and `high`.

    calm: proved that no motion grows at `calm.problem.v`. grows: proved that one does at `grows.problem.v`, a little
    above. So between the two the row changes; that it does not do so before is computed. None where nothing changes,
    or nothing is proved (`reason`).
    convective: the computed velocity between them. limit: the computed velocity from which on long finite trains grow
    by themselves, to which the onsets of finite trains fall as they get longer; None where that is not met.
    """

    low: Fraction
    high: Fraction
    status: Status
    convective: float | None
    limit: float | None
    calm: InfiniteTrain | None = None
    grows: InfiniteTrain | None = None
    reason: Reason | None = None


def train_velocities(
    problem: Given,
    spacing: object,
    v: tuple[object, object],
    *,
    effort: Effort | None = None,
    progress: Progress | None = None,
) -> TrainVelocities:
    """From which velocity on disturbances grow along an endless row, and from which on long trains grow.

    problem: one vehicle on its track; its own velocity is not used. spacing: as for `infinite_train`. v: the range
    (low, high) that is searched, low ≥ 0. effort bounds each of the proofs, progress hears of the work.
    Raises InputError as `infinite_train` does, and for a range that is none.
    """
    low, high = _range(v)
    row, tell = row_of(problem, spacing), progress or silent
    require_premises(row.reduced, HalfPlane())
    tell("looking", 0.0)
    grid = [low + (high - low) * k / (_GRID - 1) for k in range(_GRID)]
    convective = _first(grid, lambda x: _grows(row, x))
    tell("limit", 0.3)
    after = [x for x in grid if convective is not None and x > convective]
    limit = _first([low, *after], lambda x: _meets(row, x))
    if convective is None:
        reason = Reason("no-change", "no velocity in the range is found at which a motion grows", {}, "raise its end")
        return TrainVelocities(low, high, Status.UNDECIDED, None, limit, reason=reason)
    tell("proving", 0.5)
    for width in _WIDTHS:
        calm, grows = (_proof(row, _short(convective, width, up), effort) for up in (False, True))
        if calm.stable is True and grows.stable is False:
            return TrainVelocities(low, high, Status.UNVERIFIED, convective, limit, calm, grows)
    reason = calm.reason or grows.reason or Reason("row", "the row is not proved to change where it is computed to")
    return TrainVelocities(low, high, Status.UNDECIDED, convective, limit, reason=reason)


def _range(v: Any) -> tuple[Fraction, Fraction]:
    try:
        low, high = (rational(x, "v") for x in v)
    except (TypeError, ValueError) as error:
        if isinstance(error, InputError):
            raise
        raise InputError("v", "is no range: give (low, high)") from None
    if not 0 <= low < high:
        raise InputError("v", f"is ({shown(low)}, {shown(high)}): give 0 <= low < high")
    return low, high


def _short(v: float, width: float, up: bool) -> Fraction:
    """A decimal of few digits above or below v, one or two times `width` away from it."""
    unit = Fraction(10) ** math.floor(math.log10(v * width))
    return (math.floor(Fraction(v) / unit) + (2 if up else -1)) * unit


def _proof(row: Row, v: Fraction, effort: Effort | None) -> InfiniteTrain:
    budget = effort.anew() if effort is not None else Effort(evaluations=EVALUATIONS)
    return decide(row.at_velocity(v), budget, silent)


def _grows(row: Row, v: Fraction) -> bool:
    """In floats: a root z has crossed the circle for some real frequency."""
    if not v:
        return False
    here = row.at_velocity(v)
    return max(gain.factor for gain in gains(Bloch(here), reach_of(here))) > 1


def _meets(row: Row, v: Fraction) -> bool:
    """In floats: long trains grow by themselves."""
    here = row.at_velocity(v)
    return long_trains_grow(Bloch(here), reach_of(here))


def _first(grid: list[Fraction], test: Callable[[Fraction], bool]) -> float | None:
    """Where the test begins to hold, to some nine digits, if it holds at a point of the grid and not at the first."""
    at = next((k for k, x in enumerate(grid) if test(x)), None)
    if at is None:
        return None
    if at == 0:
        return float(grid[0])
    low, high = grid[at - 1], grid[at]
    for _ in range(_HALVINGS):
        middle = Fraction(float((low + high) / 2))
        low, high = (low, middle) if test(middle) else (middle, high)
    return float(np.float64((low + high) / 2))
