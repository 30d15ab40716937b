"""One entry of a table: its question, and its answer rounded.

Entries are asked together where parts of the rows or of the columns of a table share boxes.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field
from fractions import Fraction
from typing import Any, cast

from mpsolve.errors import InputError, PrecisionError
from mpsolve.numbers.balls import precision
from mpsolve.numbers.decimals import fixed_digits, working_bits
from mpsolve.numbers.packed import Portable
from mpsolve.outcome import Reason
from mpsolve.problem.family import factors_last
from mpsolve.problem.over import Over
from mpsolve.problem.problem import Problem
from mpsolve.proof.effort import Effort
from mpsolve.ranges.crossed import not_whole
from mpsolve.ranges.onset import Kind, Onset, onset
from mpsolve.ranges.onset_line import OnsetBall, onsets_along
from mpsolve.ranges.scope import from_above_rest
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


_TOGETHER = 40  # entries
Axis = tuple[str, tuple[Fraction, ...]]
"""A path and its values."""


@dataclass(frozen=True)
class Line:
    """Entries that are asked together: their places in the table, and the values of the parameter `along` in each.

    problem: what they have in common; None where each is asked by itself.
    """

    places: tuple[int, ...]
    jobs: tuple[Job, ...]
    problem: Problem | None
    along: str
    values: tuple[Fraction, ...]


def lines_of(problem: Problem, jobs: Sequence[Job], rows: Axis, columns: Axis) -> list[Line]:
    """Parts of the rows or of the columns of the table, whichever are longer."""
    width = len(columns[1])
    down = len(rows[1]) >= width
    along, fixed = (rows, columns) if down else (columns, rows)
    together = jobs[0].quantity == "onset" and jobs[0].over.high is not None
    n, out = len(along[1]), []
    size = -(-n // -(-n // _TOGETHER))
    for k, value in enumerate(fixed[1]):
        common = _common(problem, fixed[0], value) if together else None
        for start in range(0, n, size):
            part = range(start, min(start + size, n))
            places = tuple(i * width + k if down else k * width + i for i in part)
            asked, values = tuple(jobs[i] for i in places), tuple(along[1][i] for i in part)
            whole = common if common is not None and _is_line(common, asked, along[0], values) else None
            out.append(Line(places, asked, whole, along[0], values))
    return out


def _is_line(common: Problem, jobs: Sequence[Job], along: str, values: Sequence[Fraction]) -> bool:
    """Whether a family of what the entries have in common holds the problem of each of them.

    A parameter that is set after one that moves the same numbers undoes it: a table sets those of rows and columns
    first, a family its own in another order. All numbers of a problem are at most linear in a parameter, so that two
    of its values tell.
    """
    path, low, high = jobs[0].over.path, jobs[0].over.low, cast(Fraction, jobs[0].over.high)
    try:
        return all(
            _inside(common, [(path, None, x), (along, None, value)]) == job.problem.changed(path, x)
            for x in (low + (high - low) / 3, high - (high - low) / 3)
            for job, value in zip(jobs, values, strict=True)
        )
    except InputError:
        return False


def _inside(problem: Problem, values: list[tuple[str, None, Fraction]]) -> Problem:
    """As a family sets them."""
    for path, _, value in factors_last(values):
        problem = problem.changed(path, value)
    return problem


def _common(problem: Problem, path: str, value: Fraction) -> Problem | None:
    try:
        return problem.changed(path, value)
    except InputError:  # a value that the other one of an entry makes possible
        return None


def solve_line(line: Line) -> list[Entry]:
    """The entries in their order; those that the line does not tell are asked by themselves."""
    job = line.jobs[0]
    found: list[OnsetBall | None] = [None] * len(line.jobs)
    if line.problem is not None and job.over.high is not None:
        over = {job.over.path: (job.over.low, job.over.high)}
        effort = None if job.seconds is None else Effort(seconds=job.seconds * len(line.jobs))
        found = onsets_along(line.problem, over, line.along, line.values, job.proved_digits, effort)
    return [_crossing(job, one) or solve(job) for job, one in zip(line.jobs, found, strict=True)]


def _crossing(job: Job, one: OnsetBall | None) -> Entry | None:
    """The entry of a proved onset; None where there is none, or its digits are not told."""
    if one is None or job.over.high is None:
        return None
    ((low, high),) = from_above_rest(job.problem, {job.over.path: (job.over.low, job.over.high)}).values()
    try:
        return Entry("proved", number(one.value, job), (low, high), balls=(one.value,))
    except PrecisionError:
        return None
