"""One entry of a table: its question, and its answer rounded."""

from __future__ import annotations

from dataclasses import dataclass, field
from fractions import Fraction
from typing import Any

from mpsolve.errors import InputError, PrecisionError
from mpsolve.numbers.balls import precision
from mpsolve.numbers.decimals import fixed_digits, working_bits
from mpsolve.numbers.packed import Portable
from mpsolve.outcome import Reason
from mpsolve.problem.over import Over
from mpsolve.problem.problem import Problem
from mpsolve.proof.effort import Effort
from mpsolve.ranges.left_out import not_whole
from mpsolve.ranges.onset import Kind, Onset, onset
from mpsolve.ranges.unstable import UnstableRanges, unstable_ranges

_GUARD = 5  # digits beyond those that are printed
_LEAST = 15


@dataclass(frozen=True)
class Entry(Portable):
    """One entry. status: "proved" (`text` is the number, correctly rounded in the unit of the table, or the ranges),
    "stable" (nothing grows in the range), "unstable" (from its start on) or "undecided", with the reason.

    balls: the onset, or the ends of the ranges, in the model's unit. over: the range of which the entry speaks.
    """

    status: str
    text: str
    over: tuple[Fraction, Fraction]
    reason: Reason | None = None
    balls: tuple[Any, ...] = field(default=(), repr=False)


@dataclass(frozen=True)
class Job:
    problem: Problem
    quantity: str
    over: Over
    digits: int
    seconds: float | None

    @property
    def proved_digits(self) -> int:
        """To how many a number is proved that is printed."""
        return max(_LEAST, self.digits + _GUARD)


def solve(job: Job) -> Entry:
    ends: Any = (job.over.low, job.over.high)
    effort = None if job.seconds is None else Effort(seconds=job.seconds)
    options: dict[str, Any] = {"digits": job.proved_digits, "effort": effort, "check": False}
    prove = onset if job.quantity == "onset" else unstable_ranges
    try:
        found: Onset | UnstableRanges = prove(job.problem, over={job.over.path: ends}, **options)
        ends = found.over[job.over.path]
        reason = not_whole(found.left_out) if found.proved else found.reason
        if not found.proved or reason is not None:
            return Entry("undecided", "undecided", ends, reason)
        return _onset(job, found, ends) if isinstance(found, Onset) else _ranges(job, found, ends)
    except (InputError, PrecisionError) as error:
        return Entry("undecided", "undecided", ends, Reason("entry", str(error), {}, ""))


def _onset(job: Job, found: Onset, ends: tuple[Fraction, Fraction]) -> Entry:
    if found.kind is Kind.CROSSES:
        return Entry("proved", number(found.value, job), ends, balls=(found.value,))
    status = "stable" if found.kind is Kind.STABLE else "unstable"
    return Entry(status, status, ends)


def _ranges(job: Job, found: UnstableRanges, ends: tuple[Fraction, Fraction]) -> Entry:
    if not found.intervals:
        return Entry("stable", "stable", ends)
    texts = [f"{number(one.start, job)}..{number(one.end, job)}" for one in found.intervals]
    balls = tuple(ball for one in found.intervals for ball in (one.start, one.end))
    return Entry("proved", " ".join(texts), ends, balls=balls)


def number(ball: Any, job: Job) -> str:
    """In the unit of the table."""
    with precision(working_bits(job.digits + _GUARD)):
        return fixed_digits(job.over.shown(ball), job.digits)
