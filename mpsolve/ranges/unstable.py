"""In which ranges of a parameter roots grow, from all crossings."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass
from fractions import Fraction
from typing import Any, ClassVar

from mpsolve.certificate.solve import checked_digits
from mpsolve.numbers.balls import precision, rational_ball
from mpsolve.numbers.decimals import working_bits
from mpsolve.numbers.packed import Portable
from mpsolve.numbers.plain import outward
from mpsolve.parallel.threads import one_thread
from mpsolve.problem.cases import Given, as_problem
from mpsolve.problem.problem import Problem
from mpsolve.progress import Progress, silent
from mpsolve.proof.effort import Effort
from mpsolve.ranges.answer import Answer, Interval
from mpsolve.ranges.crossed import Crossings, LeftOut
from mpsolve.ranges.crossings import find
from mpsolve.ranges.scope import checked_over, one_path

SHARED = ("status", "reason", "known", "proofs", "cost", "certificate", "note", "left_out")
"""What an answer has from the crossings that it is read from: their certificate is its own."""


@dataclass(frozen=True)
class Unstable(Portable):
    """Between two neighbouring crossings or ends of the range `roots` roots grow; q: the frequency at the start.

    start, end: balls; an end of the range itself is exact, and then q is None at the start. end is None where the
    range has no upper end, and then `upper` is ∞.
    """

    start: Any
    end: Any
    q: Any | None
    roots: int

    @property
    def lower(self) -> float:
        """A float at or below `start`."""
        return outward(self.start, up=False)

    @property
    def upper(self) -> float:
        """A float at or above `end`."""
        return math.inf if self.end is None else outward(self.end, up=True)


@dataclass(frozen=True)
class UnstableRanges(Answer):
    """All parts of a range in which some root grows, in ascending order; parts with other numbers of roots meet.

    left_out: single speeds of which nothing is said.
    """

    a_list: ClassVar[bool] = True
    digits: int = 15
    intervals: tuple[Unstable, ...] = ()
    left_out: tuple[LeftOut, ...] = ()

    def rows(self) -> list[Mapping[str, float | None]]:
        """The answer as a table, numbers as floats: one mapping for each row."""
        return [
            {"start": near(i.start), "end": near(i.end), "q": near(i.q), "roots": i.roots} for i in self.intervals
        ]


def unstable_ranges(
    problem: Given,
    *,
    over: Mapping[str, Any],
    digits: int = 15,
    effort: Effort | None = None,
    progress: Progress | None = None,
    check: bool = True,
) -> UnstableRanges:
    """Where in a closed range of one parameter the problem is unstable: see `crossings` for arguments and errors."""
    given = as_problem(problem)
    found = found_in(given, checked_over(problem, over, endless=True), digits, effort, progress, check)
    intervals = intervals_of(found)
    return UnstableRanges(problem, found.over, digits=found.digits, intervals=intervals, **shared(found))


def shared(found: Crossings) -> dict[str, Any]:
    return {name: getattr(found, name) for name in SHARED}


def intervals_of(found: Crossings) -> tuple[Unstable, ...]:
    """The parts between crossings with roots that grow; none where the counts are open."""
    if found.counts is None:
        return ()
    if found.left_out:
        return tuple(one for part in found.parts for one in intervals_of(part))
    low, high = next(iter(found.over.values()))
    starts: list[tuple[Any, Any | None]] = [
        (_exact(low, found.digits), None),
        *((c.value, c.q) for c in found.crossings),
    ]
    ends = [*(c.value for c in found.crossings), None if high is None else _exact(high, found.digits)]
    return tuple(
        Unstable(start, end, q, number)
        for (start, q), end, number in zip(starts, ends, found.counts, strict=True)
        if number
    )


def _exact(x: Fraction, digits: int) -> Any:
    """An end of the range, to a few more digits than were asked for."""
    with precision(working_bits(digits)):
        return rational_ball(x)


def near(ball: Any) -> float | None:
    return None if ball is None else float(ball.mid())


def found_in(
    given: Problem,
    ranges: Mapping[str, Interval],
    digits: int,
    effort: Effort | None,
    progress: Progress | None,
    check: bool,
    near: tuple[tuple[float, float], ...] = (),
) -> Crossings:
    one_path(ranges)
    with one_thread():
        return find(given, ranges, checked_digits(digits), effort, progress or silent, check, near)
