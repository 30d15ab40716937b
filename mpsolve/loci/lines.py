"""Root loci: every induced frequency of a region followed along one parameter, proved continuous and complete."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import replace
from fractions import Fraction
from time import process_time
from typing import Any

from mpsolve.certificate.solve import checked_digits
from mpsolve.errors import InputError
from mpsolve.loci.answer import Event, FrequencyLines
from mpsolve.loci.assembly import Assembly
from mpsolve.loci.region import region_of
from mpsolve.numbers.model import rational, shown
from mpsolve.outcome import Status
from mpsolve.parallel.threads import one_thread
from mpsolve.problem.cases import Given, as_problem
from mpsolve.problem.problem import Problem
from mpsolve.progress import Progress, silent
from mpsolve.proof.effort import Effort
from mpsolve.ranges.answer import Interval, Spent
from mpsolve.ranges.scope import OpenError, checked_over, from_above_rest, one_path, scope_of

NOTE = "no certificate states lines; the roots at one point, from which they are counted, are certified"
_BOXES = 1_000_000  # that an answer may take unless effort says otherwise
_MOST_POINTS = 100_000


def frequency_lines(
    problem: Given,
    *,
    over: Mapping[str, Any],
    points: int | Iterable[Any] = 33,
    region: object = None,
    digits: int = 15,
    effort: Effort | None = None,
    progress: Progress | None = None,
    check: bool = True,
) -> FrequencyLines:
    """Every root of a region as a continuous function of one parameter over a closed range.

    over: {path: (low, high)}, in the problem's units. points: how many values, evenly spaced, or which ones: at them
    the lines have their roots to `digits` digits. region: None, all below a height near the lowest cut; "unstable",
    Im q < 0; ("below", h), Im q < h as far as the answer's region says. check: have the standalone verifier pass the
    spectrum from which the roots are counted. `Status.UNDECIDED`, with a reason and the lines as far as they are
    proved, where some root could not be followed. Raises InputError for a path that there is not, for ranges and
    points that cannot be, and for heights at the cuts.
    """
    given = as_problem(problem)
    ranges = checked_over(given, over)
    path = one_path(ranges)
    values = _values(points, path, ranges[path])
    tell = progress or silent
    with one_thread():
        found = _find(given, ranges, values, region, checked_digits(digits), effort, tell, check)
    return replace(found, problem=problem)


def _values(points: int | Iterable[Any], path: str, interval: Interval) -> tuple[Fraction, ...]:
    low, high = interval
    if isinstance(points, int):
        if not 2 <= points <= _MOST_POINTS:
            raise InputError("points", f"is {points}: give a whole number from 2 to {_MOST_POINTS}, or the values")
        return tuple(low + (high - low) * Fraction(k, points - 1) for k in range(points))
    values = sorted({rational(value, "points") for value in points})
    for value in values:
        if not low <= value <= high:
            stated = f"holds {shown(value)}, outside the range of {path} from {shown(low)} to {shown(high)}"
            raise InputError("points", f"{stated}: leave it out, or widen the range")
    return tuple(values)


def _find(
    problem: Problem,
    over: Mapping[str, Interval],
    values: tuple[Fraction, ...],
    asked: object,
    digits: int,
    effort: Effort | None,
    progress: Progress,
    check: bool,
) -> FrequencyLines:
    started = process_time()
    budget = effort.anew() if effort is not None else Effort(evaluations=_BOXES)
    over = from_above_rest(problem, over)
    scope = scope_of(problem, over)
    common: dict[str, Any] = {"digits": digits, "values": values}
    try:
        region = region_of(scope, asked)
    except OpenError as error:
        cost = Spent(process_time() - started)
        return FrequencyLines(problem, over, Status.UNDECIDED, error.reason, cost=cost, **common)
    search = Assembly(problem, over, region, digits, budget, progress, check)
    lines = search.lines(values)
    proof = search.proof()
    checked = search.base.cost.verification if search.base is not None else 0.0
    cost = Spent(process_time() - started - checked, checked, budget.spent)
    reason = search.reason
    status = Status.UNVERIFIED if reason is None else Status.UNDECIDED
    events = tuple(Event(*search.in_units(one), one.gained or 0) for one in search.events)
    counts = search.counts if reason is None else None
    return FrequencyLines(
        problem, over, status, reason, {"lines": len(lines)}, proof, cost, note="" if reason else NOTE,
        region=search.answered, lines=lines, events=events, counts=counts, **common,
    )  # fmt: skip
