"""Root loci: every induced frequency of a region followed along one parameter, proved continuous and complete."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import replace
from fractions import Fraction
from time import process_time
from typing import Any

from mpsolve.certificate.solve import checked_digits
from mpsolve.cuts.points import from_above_rest as above_rest
from mpsolve.errors import InputError
from mpsolve.loci.answer import Event, FrequencyLines
from mpsolve.loci.assembly import Assembly
from mpsolve.loci.on_sheet import on_sheet
from mpsolve.loci.region import region_of
from mpsolve.numbers.model import rational, shown
from mpsolve.outcome import Status
from mpsolve.parallel.threads import one_thread
from mpsolve.problem.case import Case
from mpsolve.problem.cases import Given, as_problem
from mpsolve.problem.line import line_height
from mpsolve.problem.physical import PhysicalCase
from mpsolve.problem.problem import Problem
from mpsolve.progress import Progress, silent
from mpsolve.proof.effort import Effort, begun
from mpsolve.proof.stopping import stoppable
from mpsolve.ranges.answer import Interval, Spent
from mpsolve.ranges.scope import OpenError, checked_over, from_above_rest, one_path, scope_of
from mpsolve.spectrum.regions import Below, checked_region

NOTE = "no certificate states lines yet"
_BOXES = 1_000_000  # that an answer may take unless effort says otherwise
_MOST_POINTS = 100_000


@stoppable
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
    the lines have their roots to `digits` digits. region: "unstable", Im q < 0; ("below", h), Im q < h as far as the
    answer's region says; "sheet", the whole sheet of masses on a beam, below its cuts and above: a line that comes to
    a cut ends there, with a `LineEnd` that is one of `cut_points`; None, "sheet" for a `Case` with damping below the
    critical one, else all below a height near the lowest cut. check: have the standalone verifier pass the spectrum
    from which the roots are counted. `Status.UNDECIDED`, with a reason and the lines as far as they are proved, where
    some root could not be followed. Raises InputError for a path that there is not, for ranges and points that cannot
    be, for heights at the cuts, and for "sheet" on other tracks.
    """
    given = as_problem(problem)
    ranges = checked_over(problem, over)
    path = one_path(ranges)
    values = _values(points, path, ranges[path])
    tell = progress or silent
    if isinstance(region, tuple):
        below = checked_region(region, problem)
        region = ("below", below.height) if isinstance(below, Below) else region
    asked = "sheet" if region is None and _on_paper(problem, given, path, ranges[path]) else region
    with one_thread():
        found = _find(given, ranges, values, asked, checked_digits(digits), effort, tell, check)
    return replace(found, problem=problem)


def _on_paper(given: Given, problem: Problem, path: str, ends: Interval) -> bool:
    """Whether it is a case of the paper, whose cuts lie on one line at both ends of the range."""
    paper = isinstance(given, (Case, PhysicalCase))
    tracks = [problem.changed(path, end).track for end in ends] if paper else []
    return bool(tracks) and all(line_height(track) is not None for track in tracks)


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
    budget = begun(effort, _BOXES)
    whole = asked == "sheet"
    over = dict(above_rest(problem, over)) if whole else from_above_rest(problem, over)
    common: dict[str, Any] = {"digits": digits, "values": values}
    try:
        region = on_sheet(problem, over) if whole else region_of(scope_of(problem, over), asked)
    except OpenError as error:
        cost = Spent.since(started)
        return FrequencyLines(problem, over, Status.UNDECIDED, error.reason, cost=cost, **common)
    search = Assembly(problem, over, region, digits, budget, progress, check)
    lines = search.lines(values)
    proof = search.proof()
    cost = Spent.since(started, search.base, boxes=budget.spent)
    reason = search.reason
    status = Status.UNVERIFIED if reason is None else Status.UNDECIDED
    events = tuple(Event(*search.in_units(one), one.gained or 0, one.side or None) for one in search.events)
    counts = search.counts if reason is None else None
    return FrequencyLines(
        problem, over, status, reason, {"lines": len(lines)}, proof, cost, note="" if reason else NOTE,
        region=region.answered, lines=lines, events=events, counts=counts, **common,
    )  # fmt: skip
