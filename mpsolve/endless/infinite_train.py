"""The verb: whether a motion of an endless row of equal vehicles grows, for any real Bloch number, with proof."""

from __future__ import annotations

from dataclasses import dataclass, field, replace
from time import process_time

from mpsolve.endless.axis import Gain, closest, gains
from mpsolve.endless.bloch import Bloch
from mpsolve.endless.decide import count_growing
from mpsolve.endless.doubling import growing_in_floats
from mpsolve.endless.growing import Growing, find_growing
from mpsolve.endless.row import Row, row_of
from mpsolve.errors import EffortError, PrecisionError
from mpsolve.numbers.result import Cost, Result
from mpsolve.outcome import Reason, Status
from mpsolve.passivity.far import prove_tail
from mpsolve.problem.cases import Given
from mpsolve.problem.problem import Problem
from mpsolve.progress import Progress, silent
from mpsolve.proof.effort import Effort, begun
from mpsolve.proof.stopping import stoppable
from mpsolve.spectrum.premises import require_premises
from mpsolve.spectrum.regions import HalfPlane

EVALUATIONS = 1_500_000
"""About half a minute; a row far from its threshold takes some 50 thousand."""
_LEAST_REACH = 1.0  # scaled: frequencies are looked at up to here, or to the tail's X
_MEET = 1e-8  # what float64 tells of two moduli that are the same
_LONG = 16  # vehicles of a train that is counted, where roots of long trains do not come over the real axis


@dataclass(frozen=True)
class InfiniteTrain(Result):
    """What is known of an endless row of vehicles; frequencies and velocities in the units of the problem.

    stable: True if proved that for every real κ all motions decay, False if proved that one grows, None where open.
    growing: for stable rows 0; where every κ is proved to have the same number of growing motions, that number.
    motion: a proved growing motion, or None. reason: why the answer is open.
    ahead, back: the largest factors that a harmonic motion gains from a vehicle to the next in that direction, with
    their frequencies; computed. separation: the least |z_{n₊+1}/z_{n₊}| over real frequencies; computed. Where it is
    1 the frequencies of long finite trains gather on the real axis. long_trains: whether long finite trains grow by
    themselves; computed.
    """

    problem: Problem
    spacing: str
    status: Status
    stable: bool | None
    ahead: Gain
    back: Gain
    separation: float
    long_trains: bool
    growing: int | None = None
    motion: Growing | None = None
    reason: Reason | None = None
    cost: Cost = field(default_factory=lambda: Cost(0.0))

    @property
    def words(self) -> str:
        """What it means for finite trains, in one sentence, which says what of it is computed, not proved."""
        if self.stable is None:
            return f"undecided: {self.reason}"
        if self.stable:
            return "no motion grows: what is shaken dies out along the train in both directions"
        if not self.long_trains:
            way = "back" if self.back.factor > self.ahead.factor else "ahead"
            rest = "and long finite trains come to rest again"
            return f"a motion grows; as computed, it grows as it runs {way} from vehicle to vehicle, {rest}"
        return "a motion grows; as computed, long finite trains grow by themselves"


@stoppable
def infinite_train(
    problem: Given, spacing: object, *, effort: Effort | None = None, progress: Progress | None = None
) -> InfiniteTrain:
    """Whether any motion of equal vehicles in an endless row grows: proved for all real Bloch numbers κ at once.

    problem: one vehicle on its track at its velocity; spacing: from each vehicle to the next, above the distance of
    its outer contacts, in the problem's unit of length. effort bounds the work, progress hears of it. Undecided
    answers carry a `Reason`; what is computed (`ahead`, `back`, `separation`) is there all the same.
    Raises InputError for a track that is unstable or undamped, and for a spacing at which vehicles would overlap.
    The mathematics is in docs/theory/infinite-train.md.

    >>> from mpsolve import Problem, infinite_train, tracks, vehicles
    >>> beam = tracks.EulerBernoulli(EI="0.25", m=1, k=1, c="0.1")
    >>> infinite_train(Problem(beam, vehicles.Mass(40), v="0.1"), "1.5").stable
    True
    """
    budget = begun(effort, EVALUATIONS)
    row = row_of(problem, spacing)
    require_premises(row.reduced, HalfPlane())
    return decide(row, budget, progress or silent)


def decide(row: Row, effort: Effort, tell: Progress) -> InfiniteTrain:
    """The answer for a row; the effort is used as it is."""
    started = process_time()
    tell("looking", 0.0)
    reach = reach_of(row, effort)
    bloch, unit = Bloch(row), float(row.reduced.frequency_unit)
    ahead, back = (replace(gain, q=gain.q * unit) for gain in gains(bloch, reach))
    separation, long_trains = closest(bloch, reach)[0], long_trains_grow(bloch, reach)
    known = InfiniteTrain(row.problem, str(row.spacing), Status.UNDECIDED, None, ahead, back, separation, long_trains)
    motion = None
    if row.reduced.guide.v and max(ahead.factor, back.factor) > 1:
        tell("growing", 0.3)
        motion = find_growing(row, reach)
    if motion is not None:
        found = replace(known, status=Status.UNVERIFIED, stable=False, motion=motion)
    else:
        tell("proving", 0.5)
        found = _stable(row, known, effort)
    tell("done", 1.0)
    return replace(found, cost=Cost(process_time() - started, 0.0, effort.spent))


def reach_of(row: Row, effort: Effort | None = None) -> float:
    """The scaled frequency up to which floats look: beyond it the row only takes energy, where that is proved."""
    try:
        tail = prove_tail(row.reduced.guide, row.gap, effort) if row.reduced.guide.v else None
    except EffortError:  # what is proved next ends by it, too, and says so
        tail = None
    return max(_LEAST_REACH, 4.0 if tail is None else tail.X)


def long_trains_grow(bloch: Bloch, reach: float) -> bool:
    """In floats: the middle roots meet in modulus on the real axis, or a train of some length grows already."""
    if not bloch.row.reduced.guide.v:
        return False
    return closest(bloch, reach)[0] < 1 + _MEET or growing_in_floats(bloch, _LONG, reach, reach) > 0


def _stable(row: Row, known: InfiniteTrain, effort: Effort) -> InfiniteTrain:
    try:
        count = count_growing(row, effort)
    except EffortError as error:
        return replace(known, reason=error.reason)
    except PrecisionError as error:
        remedy = "change the velocity a little: it may be next to where a motion begins to grow"
        return replace(known, reason=Reason("row", str(error), {}, remedy))
    return replace(known, status=Status.UNVERIFIED, stable=not count.growing, growing=count.growing)
