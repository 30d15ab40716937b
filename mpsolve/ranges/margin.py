"""How far one parameter is from where stability changes: the nearest change below and above its value.

And a box of several parameters round a problem's own values, all over which it is proved stable, as wide as can be
had.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from fractions import Fraction
from time import process_time
from typing import Any

from flint import arb

from mpsolve.errors import InputError, MpsolveError
from mpsolve.numbers.balls import precision, rational_ball
from mpsolve.outcome import Reason
from mpsolve.problem.cases import Given, as_problem
from mpsolve.problem.problem import Problem
from mpsolve.problem.ratios import ratios_of
from mpsolve.progress import Progress
from mpsolve.proof.effort import Effort
from mpsolve.ranges.answer import Interval
from mpsolve.ranges.crossed import not_whole
from mpsolve.ranges.robust import prove_box
from mpsolve.ranges.unstable import UnstableRanges, unstable_ranges


@dataclass(frozen=True)
class Margin:
    """Where the problem's own value of one parameter stands among the stable and unstable parts of a range of it.

    below, above: balls round the nearest values at which stability changes; None where there is none down to the
    start, up to the end of the range, whose upper one may be None: without end. stable: at the own value and
    everywhere between these; None where that is open, and then `reason` says why.
    """

    path: str
    own: Fraction
    over: Interval
    stable: bool | None
    below: arb | None = None
    above: arb | None = None
    reason: Reason | None = None


def margin(
    problem: Given, path: str, over: Interval, *, effort: Effort | None = None, progress: Progress | None = None
) -> Margin:
    """The margin of the parameter at `path`, proved over the whole range; InputError for one that cannot be.

    No certificate is asked for: the verifier would take as long again.
    """
    own = _own(as_problem(problem), path)
    return margin_in(unstable_ranges(problem, over={path: over}, effort=effort, progress=progress, check=False), own)


def _own(problem: Problem, path: str) -> Fraction:
    problem.quantity(path)  # says which paths there are
    known = ratios_of(problem.track, problem.vehicles, problem.v) | problem.parameters
    if path not in known:
        raise InputError(path, "has several values, so that none is its own: name one of them")
    return known[path]


def margin_in(found: UnstableRanges, own: Fraction) -> Margin:
    """Where `own` stands among the unstable parts of an answer."""
    ((path, over),) = found.over.items()
    reason = not_whole(found.left_out) if found.proved else found.reason
    if not found.proved or reason is not None:
        return Margin(path, own, over, None, reason=reason)
    with precision(256):
        here = rational_ball(own)
        parts = _joined(found, over)
        inside = [(a, b) for a, b in parts if (a is None or a < here) and (b is None or here < b)]
        below = [x for part in parts for x in part if x is not None and x < here]
        above = [x for part in parts for x in part if x is not None and x > here]
        clear = len(below) + len(above) == sum(x is not None for part in parts for x in part)
        if not clear or own < over[0] or (over[1] is not None and own > over[1]):
            stated = f"{path} is its own limit, or is outside of the range"
            return Margin(path, own, over, None, reason=Reason("margin", stated, {}, "ask for more digits"))
        low, high = (below[-1] if below else None), (above[0] if above else None)
        return Margin(path, own, over, not inside, low, high)


def _joined(found: UnstableRanges, over: Interval) -> list[tuple[arb | None, arb | None]]:
    """The unstable parts in ascending order, neighbours joined; None for an end that is one of the range itself."""
    low, high = (None if end is None else rational_ball(end) for end in over)
    parts: list[tuple[Any | None, Any | None]] = []
    for one in found.intervals:
        start = None if one.q is None and one.start.overlaps(low) else one.start
        end = None if one.end is None or (high is not None and one.end.overlaps(high)) else one.end
        if parts and start is not None and parts[-1][1] is not None and parts[-1][1].overlaps(start):
            parts[-1] = (parts[-1][0], end)
        else:
            parts.append((start, end))
    return parts


_SMALLER = (Fraction(1), Fraction(2, 5), Fraction(1, 10), Fraction(1, 50))


def stable_region(problem: Given, shares: Mapping[str, Fraction], seconds: float) -> dict[str, Interval] | None:
    """The first box that is proved, of ever smaller ones; None where none is, or time is up.

    No certificate is asked for: the verifier would take as long again.
    shares: by path the part of its own value by which a parameter may change in the widest box, below 1.
    """
    own, start = as_problem(problem).parameters, process_time()
    if any(not own.get(path) for path in shares):
        return None
    for smaller in _SMALLER:
        left = seconds - (process_time() - start)
        if left <= 0:
            return None
        over = {
            path: (own[path] * (1 - smaller * share), own[path] * (1 + smaller * share))
            for path, share in shares.items()
        }
        try:
            if prove_box(problem, over=over, effort=Effort(seconds=left), check=False).stable:
                return over
        except MpsolveError:  # the widest box may reach what cannot be, such as a wave speed
            continue
    return None
