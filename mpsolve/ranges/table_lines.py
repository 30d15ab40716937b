"""Entries of a table that are asked together: parts of its rows or of its columns, which share boxes."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from fractions import Fraction

from mpsolve.errors import InputError, PrecisionError
from mpsolve.problem.problem import Problem
from mpsolve.proof.effort import Effort
from mpsolve.ranges.entry import Entry, Job, number, solve
from mpsolve.ranges.onset_line import OnsetBall, onsets_along
from mpsolve.ranges.scope import from_above_rest

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
    together = together and _in_order(fixed[0], along[0]) and _in_order(along[0], jobs[0].over.path)
    n, out = len(along[1]), []
    size = -(-n // -(-n // _TOGETHER))
    for k, value in enumerate(fixed[1]):
        common = _common(problem, fixed[0], value) if together else None
        for start in range(0, n, size):
            part = range(start, min(start + size, n))
            places = tuple(i * width + k if down else k * width + i for i in part)
            values = tuple(along[1][i] for i in part)
            out.append(Line(places, tuple(jobs[i] for i in places), common, along[0], values))
    return out


def _in_order(first: str, then: str) -> bool:
    """Whether the first may be applied before the other: no factor before what it is to scale, which are vehicles."""
    return not first.startswith("scale.") or then in ("v", "alpha") or then.startswith(("scale.", "track."))


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
