"""Two velocities of a row: from the first on disturbances grow along it, from the second on long trains themselves.

The first is proved over the whole range of velocities below it, and enclosed. The second is computed.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass, replace
from fractions import Fraction
from typing import Any

from mpsolve.endless.axis import closest, gains
from mpsolve.endless.bloch import Bloch
from mpsolve.endless.growing import find_growing
from mpsolve.endless.infinite_train import EVALUATIONS, InfiniteTrain, decide, long_trains_grow, reach_of
from mpsolve.endless.long_trains import LongTrains, prove_long
from mpsolve.endless.row import Row, row_of
from mpsolve.endless.row_scope import Covered, cover_row, row_scope
from mpsolve.endless.seek import first_where, threshold_of
from mpsolve.errors import PrecisionError
from mpsolve.numbers.balls import arb, precision, rational_ball
from mpsolve.numbers.model import checked_range, shown
from mpsolve.numbers.result import Result
from mpsolve.outcome import Reason, Status
from mpsolve.problem.case import Case
from mpsolve.problem.cases import Given
from mpsolve.progress import Progress, silent
from mpsolve.proof.effort import Effort, begun
from mpsolve.proof.stopping import stoppable
from mpsolve.ranges.scope import from_above_rest
from mpsolve.spectrum.premises import require_premises
from mpsolve.spectrum.regions import HalfPlane

_GRID = 13
_ABOVE = (2.0**-28, 2.0**-20, 1e-4, 1e-3, 1e-2)  # how far above it a growing motion is enclosed, relative, about
_LONG = (1e-6, 1e-5, 1e-4, 1e-3, 1e-2)  # how far above the limit long trains are proved to grow, relative, about
_ROOM = Fraction(65, 64)  # of the range of the family, over the threshold
_BOXES = 1_000_000  # that the proof over the range may take unless effort says otherwise


@dataclass(frozen=True)
class TrainVelocities(Result):
    """Where an endless row changes between the velocities `low` and `high`.

    threshold: a ball of the least velocity of the range above which a motion grows: proved that none does from `low`
    to the ball's lower end, at any velocity, for any real κ, and that one does at its upper end. None where none
    grows in the whole range, where one grows at `low` already, and where it is not proved (`reason`). stable_to:
    the velocity up to which none is proved to grow from `low` on. calm: the count at one velocity below. grows: a
    motion enclosed at one above.
    convective: the computed velocity. limit: the computed velocity from which on long finite trains grow by
    themselves, to which the onsets of finite trains fall as they get longer; None where that is not met. long: a
    velocity above it at which all trains that are long enough are proved to grow; None where that is not proved.
    The limit itself stays computed: that long trains come to rest below it is not proved.
    A range from v = 0 begins a little above it where the equations lose waves at rest.
    """

    low: Fraction
    high: Fraction
    status: Status
    convective: float | None
    limit: float | None
    long: LongTrains | None = None
    threshold: Any | None = None
    stable_to: Fraction | None = None
    calm: InfiniteTrain | None = None
    grows: InfiniteTrain | None = None
    reason: Reason | None = None
    boxes: int = 0

    @property
    def words(self) -> str:
        """What is known, in one sentence."""
        if self.reason is not None:
            part = "" if self.stable_to is None else f" from v = {float(self.stable_to):.6g} on, stable up to there"
            return f"undecided{part}: {self.reason}"
        if self.threshold is not None:
            stable = f"no motion grows along the row from v = {shown(self.low)} on"
            return f"{stable} to the threshold, {self.threshold.str(12)}, above which one does"
        if self.grows is not None:
            return f"a motion grows along the row at v = {shown(self.low)} already"
        return f"no motion grows along the row from v = {shown(self.low)} to {shown(self.high)}"


@stoppable
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
    (low, high) that is searched, low ≥ 0. effort bounds each of the proofs, progress hears of the work. An undecided
    answer keeps what is computed and what is proved at single velocities.
    Raises InputError as `infinite_train` does, for a range that is none, and for one that holds a wave speed.
    """
    low, high = checked_range(v, "v", None if isinstance(problem, Case) else "m/s", 0)
    row, tell = row_of(problem, spacing), progress or silent
    require_premises(row.reduced, HalfPlane())
    low = from_above_rest(row.problem, {"v": (low, high)})["v"][0]
    tell("looking", 0.0)
    grid = [low + (high - low) * k / (_GRID - 1) for k in range(_GRID)]
    convective = threshold_of(grid, lambda x: _factor(row, x))
    tell("limit", 0.3)
    after = [x for x in grid if convective is not None and x > convective]
    limit = first_where([low, *after], lambda x: _meets(row, x))
    long = None if limit is None else next((x for x in (_long(row, limit, w) for w in _LONG) if x is not None), None)
    known = TrainVelocities(low, high, Status.UNDECIDED, convective, limit, long)
    tell("proving", 0.5)
    if convective is not None and convective <= low:
        return _from_the_start(row, known, effort)
    found = _covered(row, known, effort, lambda share: tell("boxes", 0.5 + 0.5 * share))
    calm, grows = _beside(row, known, found.top, effort)
    known = replace(known, calm=calm, grows=grows, boxes=found.boxes)
    tell("done", 1.0)
    return _concluded(known, found)


def _concluded(known: TrainVelocities, found: Covered) -> TrainVelocities:
    """What the proofs say together."""
    calm, grows, top = known.calm, known.grows, found.top
    reason = found.reason or (None if calm is None else calm.reason)
    if calm is not None and calm.stable is True and top is not None:
        known = replace(known, stable_to=min(top, known.high))
        if (
            found.reason is None
            and known.convective is not None
            and grows is not None
            and grows.problem.v is not None
        ):
            return replace(known, status=Status.UNVERIFIED, threshold=_ball(top, grows.problem.v))
        if known.convective is None and found.reason is None:
            return replace(known, status=Status.UNVERIFIED)
    default = Reason("row", "the row is not proved to change where it is computed to", {}, "give another range")
    return replace(known, reason=reason or default)


def _ball(low: Fraction, high: Fraction) -> Any:
    with precision(106):
        a, b = rational_ball(low), rational_ball(high)
        return (a + b) / 2 + arb(0, ((b - a) / 2).upper())


def _from_the_start(row: Row, known: TrainVelocities, effort: Effort | None) -> TrainVelocities:
    grows = _proof(row, known.low, effort)
    if grows.stable is False:
        return replace(known, status=Status.UNVERIFIED, grows=grows)
    reason = grows.reason or Reason(
        "row", "floats find a motion that grows where none does", {}, "give a lower start"
    )
    return replace(known, reason=reason)


def _beside(
    row: Row, known: TrainVelocities, top: Fraction | None, effort: Effort | None
) -> tuple[InfiniteTrain, InfiniteTrain | None]:
    """The count at one velocity below the threshold, and a growing motion at one above, where it is found."""
    end = top if top is not None else known.high if known.convective is None else Fraction(known.convective)
    calm = _proof(row, known.low if not known.low else _between(known.low, end), effort)
    for width in _ABOVE if known.convective is not None else ():
        v = _short(known.convective or 0.0, width)
        at = row.at_velocity(v)
        if find_growing(at, reach_of(at)) is not None:
            return calm, _proof(row, v, effort)
    return calm, None


def _covered(row: Row, known: TrainVelocities, effort: Effort | None, tell: Callable[[float], None]) -> Covered:
    budget = begun(effort, _BOXES)
    found = None if known.convective is None else Fraction(known.convective)
    top = known.high if found is None else min(known.high, found * _ROOM)
    try:
        return cover_row(row_scope(row, known.low, top), found, budget, tell)
    except PrecisionError as error:
        return Covered(None, 0, Reason("row", str(error), {}, "give a smaller range of velocities"))


def _short(v: float, width: float) -> Fraction:
    """A decimal of few digits above v, one or two times `width` away from it."""
    unit = Fraction(10) ** math.floor(math.log10(v * width))
    return (math.floor(Fraction(v) / unit) + 2) * unit


def _long(row: Row, limit: float, width: float) -> LongTrains | None:
    here = row.at_velocity(_short(limit, width))
    return prove_long(here, closest(Bloch(here), reach_of(here))[1])


def _between(low: Fraction, high: Fraction) -> Fraction:
    """A decimal of few digits about in the middle."""
    unit = Fraction(10) ** math.floor(math.log10((high - low) / 4))
    return round((low + high) / 2 / unit) * unit


def _proof(row: Row, v: Fraction, effort: Effort | None) -> InfiniteTrain:
    budget = begun(effort, EVALUATIONS)
    return decide(row.at_velocity(v), budget, silent)


def _factor(row: Row, v: Fraction) -> float:
    """In floats: the largest factor from a vehicle to the next, for any real frequency; above 1 a motion grows."""
    if not v:
        return 0.0
    here = row.at_velocity(v)
    return max(gain.factor for gain in gains(Bloch(here), reach_of(here)))


def _meets(row: Row, v: Fraction) -> bool:
    """In floats: long trains grow by themselves."""
    here = row.at_velocity(v)
    return long_trains_grow(Bloch(here), reach_of(here))
