"""From which value of a parameter on roots grow, and in which ranges of it; both from all crossings.

Of two ranges the second is left to its worst value (`least_onset`).
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace
from enum import Enum
from time import process_time
from typing import Any

from flint import arb

from mpsolve.certificate.solve import checked_digits
from mpsolve.errors import InputError
from mpsolve.numbers.balls import rational_ball
from mpsolve.outcome import Reason, Status
from mpsolve.parallel.threads import one_thread
from mpsolve.problem.cases import Given, as_problem
from mpsolve.progress import Progress, silent
from mpsolve.proof.effort import Effort, begun
from mpsolve.proof.stopping import stoppable
from mpsolve.ranges.answer import Answer, Interval, Spent, Valued
from mpsolve.ranges.crossed import Crossings, LeftOut
from mpsolve.ranges.least_onset import NEXT, Least, LeastOnset
from mpsolve.ranges.never import never_unstable
from mpsolve.ranges.scope import checked_over, from_above_rest, one_path, scope_of
from mpsolve.ranges.seen import BEYOND, up_to_first
from mpsolve.ranges.unstable import found_in, intervals_of, near, shared

_BOXES = 1_000_000  # at the worst value of a second parameter
_QUICK = 40_000  # boxes of a first try, if nothing else is asked: an onset needs the range up to itself only


class Kind(Enum):
    """How stability ends in a range."""

    CROSSES = "crosses"
    STABLE = "stable"
    UNSTABLE_FROM_START = "unstable_from_start"
    UNDECIDED = "undecided"


@dataclass(frozen=True)
class Onset(Valued, Answer):
    """The least value of a range from which on some root grows.

    kind: crosses (`value` is that value, `q` the frequency there), stable (nowhere in the range),
    unstable_from_start, or undecided. value, q: balls in the problem's units; lower, upper: floats that hold `value`
    between them, so that the problem is stable from the start of the range to `lower`; None without a value.
    left_out: single speeds of which nothing is said: the onset may lie there, without a q.
    worst: where a second parameter was left to its worst value, that value, a ball, and where it lies in its range:
    "inside", "start" or "end". The problem is then stable up to `lower` for all values of the second parameter.
    """

    digits: int = 15
    kind: Kind = Kind.UNDECIDED
    value: arb | None = None
    q: Any | None = None
    worst: arb | None = None
    where: str = ""
    left_out: tuple[LeftOut, ...] = ()

    def rows(self) -> list[Mapping[str, Any]]:
        """The answer as a table, numbers as floats: one mapping for each row."""
        return [{"kind": self.kind.value, "value": near(self.value), "q": near(self.q)}]


@stoppable
def onset(
    problem: Given,
    *,
    over: Mapping[str, Any],
    worst: Mapping[str, Any] | None = None,
    digits: int = 15,
    effort: Effort | None = None,
    progress: Progress | None = None,
    check: bool = True,
) -> Onset:
    """From which value of one parameter on the problem is unstable: see `crossings` for arguments and errors.

    worst: {path: (low, high)} of a second parameter, which is left to its worst value in this range, its ends
    included: a limiting mass at the worst distance, say. Below the answer all is stable, whatever that parameter is.
    """
    if worst is not None:
        return _at_worst(problem, over, worst, checked_digits(digits), effort, progress or silent, check)
    given = as_problem(problem)
    ranges = checked_over(problem, over, endless=True)

    def ask(
        over: Mapping[str, Interval], effort: Effort | None, near: tuple[tuple[float, float], ...] = ()
    ) -> Crossings:
        return found_in(given, over, digits, effort, progress, check, near)

    quick = begun(effort, _QUICK)
    first = _up_to_first(problem, ranges, quick, ask)
    if first is not None:
        return first
    found = ask(ranges, quick.left())
    if effort is None and found.reason is not None and found.reason.code == "effort":
        found = ask(ranges, None)
    return _read(found, Onset(problem, found.over, digits=found.digits, **shared(found)))


def _up_to_first(problem: Given, over: Mapping[str, Interval], effort: Effort, ask: Any) -> Onset | None:
    """The onset by a proof of the range up to the first crossing that floats see; None where that does not tell."""
    shorter = up_to_first(as_problem(problem), over)
    if shorter is None:
        return None
    found = ask(shorter.over, effort, (shorter.near,))
    if not found.proved or found.parts or not found.crossings:
        return None
    note = "; ".join(filter(None, (found.note, BEYOND)))
    ((path, (low, _)),) = found.over.items()
    return replace(
        _read(found, Onset(problem, {path: (low, over[path][1])}, digits=found.digits, **shared(found))), note=note
    )


def _read(found: Crossings, answer: Onset) -> Onset:
    if found.parts:
        return _read_in_parts(found, answer)
    if found.counts is None:
        return answer
    parts = intervals_of(found)
    if not parts:
        return replace(answer, kind=Kind.STABLE)
    if found.counts[0]:
        return replace(answer, kind=Kind.UNSTABLE_FROM_START)
    return replace(answer, kind=Kind.CROSSES, value=parts[0].start, q=parts[0].q)


def _read_in_parts(found: Crossings, answer: Onset) -> Onset:
    """The first part that is not stable decides, if no more than single speeds are left out before it."""
    before, stable = None, []
    for part in found.parts:
        begins = rational_ball(part.over["v"][0])
        if not part.proved or any(begins > one.value and not one.is_point for one in found.left_out):
            break
        first = _read(part, replace(answer, **shared(part)))
        skipped = before is None and found.left_out and begins > found.left_out[0].value
        if skipped and first.kind is Kind.UNSTABLE_FROM_START:
            value = found.left_out[0].start.union(begins)
            return replace(answer, status=Status.UNDECIDED, reason=_from_where(value))
        if skipped:
            first = _noting(first, found)
        if first.kind is Kind.UNSTABLE_FROM_START and before is not None:
            start, end = (rational_ball(x) for x in (before.over["v"][1], part.over["v"][0]))
            return replace(first, kind=Kind.CROSSES, value=start.union(end), note=found.note, left_out=found.left_out)
        if first.kind is not Kind.STABLE:
            return replace(first if before is None else _noting(first, found), cost=found.cost)
        before = part
        stable.append(list(part.over["v"]))
    if found.proved:
        return replace(answer, kind=Kind.STABLE)
    return replace(answer, known=dict(answer.known) | {"stable": stable}) if stable else answer


def _noting(first: Onset, found: Crossings) -> Onset:
    """The answer of a part, with what is left out before it."""
    return replace(first, note="; ".join(filter(None, (first.note, found.note))), left_out=found.left_out)


def _from_where(value: Any) -> Reason:
    low, high = (float(x) for x in (value.lower(), value.upper()))
    stated = f"roots grow from v = {high:.9g} on, but the range begins with what is left out, from {low:.9g}"
    return Reason("left-out", stated, {}, "begin the range farther below the speed of short waves, or above it")


def _at_worst(
    given: Given,
    over: Mapping[str, Any],
    worst: Mapping[str, Any],
    digits: int,
    effort: Effort | None,
    progress: Progress,
    check: bool,
) -> Onset:
    """The least onset; InputError where the ranges cannot be, or are not two."""
    started, problem = process_time(), as_problem(given)
    first, second = checked_over(given, over), checked_over(given, worst)
    one_path(first)
    if len(second) != 1 or first.keys() & second.keys():
        stated = f"names {', '.join(second)}, and over {', '.join(first)}"
        raise InputError("worst", f"{stated}: give a range of one parameter each, of two different ones")
    if never_unstable(problem, first | second):
        nothing = Least(None, None, None, "", ())
        return _told_at_worst(given, first | second, digits, nothing, None, Spent.since(started))
    both = from_above_rest(problem, first | second)
    budget = begun(effort, _BOXES)
    with one_thread():
        question = LeastOnset(problem, both, scope_of(problem, both), digits, budget, progress, check)
        found, reason, cost = question.told(started, "worst", NEXT)
    return _told_at_worst(given, both, digits, found, reason, cost)


def _told_at_worst(
    given: Given, over: Mapping[str, Interval], digits: int, found: Least | None, reason: Reason | None, cost: Spent
) -> Onset:
    if found is None:
        return Onset(given, over, Status.UNDECIDED, reason, cost=cost, digits=digits)
    nowhere = Kind.STABLE if found.worst is None else Kind.UNSTABLE_FROM_START
    note = "no certificate states an onset at the worst value of a second parameter yet"
    kind = nowhere if found.value is None else Kind.CROSSES
    return Onset(given, over, Status.UNVERIFIED, cost=cost, note=note, digits=digits, kind=kind, **vars(found))
