"""The crossings of a range over which a beam has no damping, by the theorem of one mass; else they stay open."""

from __future__ import annotations

from collections.abc import Mapping
from time import process_time
from typing import Any

from mpsolve.numbers.balls import arb, precision
from mpsolve.numbers.decimals import working_bits
from mpsolve.numbers.realroots import short_between
from mpsolve.outcome import Status
from mpsolve.problem.problem import Problem
from mpsolve.progress import Progress
from mpsolve.proof.effort import Effort
from mpsolve.ranges import lone_mass, undamped
from mpsolve.ranges.answer import Interval, Spent
from mpsolve.ranges.base import base_at, growing, uncounted
from mpsolve.ranges.crossed import Crossing, Crossings


def without_damping(
    problem: Problem,
    over: Mapping[str, Interval],
    digits: int,
    effort: Effort | None,
    progress: Progress,
    check: bool,
) -> Crossings:
    """`crossings` of checked arguments, where `undamped.no_damping` and something may grow."""
    started = process_time()
    part = lone_mass.faster(problem, over)
    if part is None:
        return Crossings(problem, over, Status.UNDECIDED, *undamped.left_open(problem, over), digits=digits)
    progress("base", 0.0)
    path, at = next(iter(over)), short_between(part.low, part.high)
    base = base_at(problem.changed(path, at), effort, check)
    number = growing(base)
    cost = Spent(process_time() - started - base.cost.verification, base.cost.verification)
    if number is None:
        why = uncounted(base, f"at {path} = {float(at):.6g}")
        return Crossings(problem, over, Status.UNDECIDED, why, digits=digits, cost=cost)
    if part.joins is None or not number:
        return Crossings(
            problem, over, Status.UNVERIFIED, digits=digits, counts=(number,), note=lone_mass.NOTE, cost=cost
        )
    with precision(working_bits(digits)):
        first = Crossing(undamped.cuts_join(problem, path), arb(0), number)
    known: dict[str, Any] = {"crossings": (first,), "counts": (0, number), "note": lone_mass.NOTE}
    return Crossings(problem, over, Status.UNVERIFIED, digits=digits, cost=cost, **known)
