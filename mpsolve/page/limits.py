"""How far a case may go: in velocity step by step, in mass, in distance, and in velocity and mass at once."""

from __future__ import annotations

from dataclasses import dataclass, replace
from fractions import Fraction
from itertools import pairwise
from time import process_time
from typing import Any

from flint import arb

from mpsolve.errors import MpsolveError
from mpsolve.outcome import Reason
from mpsolve.problem.problem import Problem
from mpsolve.proof.effort import Effort
from mpsolve.ranges.answer import Interval
from mpsolve.ranges.default import velocity_ranges
from mpsolve.ranges.margin import Margin, margin, stable_region
from mpsolve.ranges.onset import Kind, onset

MASSES = (Fraction(1, 5), Fraction(4))
"""Factors on all masses between which the limits are sought."""
_FURTHER = 0.2  # of the time, for velocities far above the case's own
_WIDEST, _OF_MARGIN = Fraction(1, 2), Fraction(4, 5)


@dataclass(frozen=True)
class Reach:
    """What is proved of velocities from `low` to `high`.

    kind: stable throughout, unstable from the start, or stable up to `value`, from which on a root grows; undecided
    where nothing is proved. reason: why it is not known of higher velocities. certificate: of the last step that is
    proved, where there is one.
    """

    kind: Kind
    low: Fraction
    high: Fraction
    value: arb | None = None
    reason: Reason | None = None
    certificate: Any | None = None


def reach_of(problem: Problem, seconds: float) -> Reach:
    """Velocities from 0 on, in steps: first up to twice the own one, then further until something grows."""
    start = process_time()
    (first, *further) = velocity_ranges(problem).steps
    found = _step(problem, first, seconds)
    for low, high in further:
        if found.kind is not Kind.STABLE:
            return found
        if found.high < low:
            stated = f"a wave speed of the track lies between {float(found.high):.6g} and {float(low):.6g}"
            return replace(found, reason=Reason("wave-speed", stated, {}, "ask above it"))
        left = min(seconds - (process_time() - start), _FURTHER * seconds)
        found = _joined(found, problem, (low, high), max(left, 0.1))
        if found.reason is not None:
            return found
    return found


def _step(problem: Problem, over: Interval, seconds: float) -> Reach:
    answer = onset(problem, over={"v": over}, digits=15, effort=Effort(seconds=seconds), check=False)
    low, high = answer.over["v"]
    return Reach(answer.kind, low, high, answer.value, answer.reason, getattr(answer, "certificate", None))


def _joined(found: Reach, problem: Problem, over: Interval, seconds: float) -> Reach:
    """What is known after another step; where that one fails, what was known before it, and why no more."""
    try:
        more = _step(problem, over, seconds)
    except MpsolveError as error:
        return replace(found, reason=Reason("step", str(error), {}, ""))
    if more.kind in (Kind.UNDECIDED, Kind.UNSTABLE_FROM_START):
        return replace(found, reason=more.reason or Reason("step", "the next step is open", {}, ""))
    return replace(more, low=found.low)


def mass_margin(problem: Problem, seconds: float) -> Margin:
    """Of all masses together, from a fifth of them to four times."""
    return margin(problem, "scale.mass", MASSES, effort=Effort(seconds=seconds))


def distance_path(problem: Problem) -> str | None:
    """Between two vehicles, of all of them, or the wheelbase of one; None for one contact."""
    if len(problem.vehicles) == 2:
        return "gap[0]"
    if len(problem.vehicles) > 2:
        return "scale.gap"
    return next((path for path in problem.parameters if path.endswith("wheelbase")), None)


def distance_margin(problem: Problem, path: str, seconds: float) -> Margin:
    """Of a distance, from half of it (or from where vehicles would touch) to twice."""
    own = problem.parameters[path]
    return margin(problem, path, (own * _nearest(problem, path), 2 * own), effort=Effort(seconds=seconds))


def _nearest(problem: Problem, path: str) -> Fraction:
    """The least factor on the distances, at or above a half, at which the wheels keep their order."""
    half = Fraction(1, 2)
    if not path.startswith(("gap", "scale")):
        return half
    placed = sorted(problem.vehicles, key=lambda one: one.position)
    ends = []
    for a, b in pairwise(placed):
        taken = max(a.vehicle.pencil.places) - min(b.vehicle.pencil.places)
        ends.append(taken / (b.position - a.position))
    return max(half, (1 + max(ends)) / 2) if max(ends) > 0 else half


def stable_box(
    problem: Problem, reach: Reach | None, mass: Margin | None, seconds: float
) -> dict[str, Interval] | None:
    """Velocities and masses round the case that are proved stable all at once, as wide as the limits let hope."""
    if not problem.v:
        return None
    shares = {"v": _share(reach and reach.value, problem.v), "scale.mass": _share(mass and mass.above, Fraction(1))}
    return stable_region(problem, shares, seconds)


def _share(limit: Any | None, own: Fraction) -> Fraction:
    """The part of `own` by which it may change, of at most a half."""
    if limit is None:
        return _WIDEST
    return min(_WIDEST, _OF_MARGIN * abs(Fraction(float(limit.mid())) - own) / own).limit_denominator(1000)
