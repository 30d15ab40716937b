"""Ranges of two parameters, the second of which is left to its worst value: asked, and what came of it."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from time import process_time
from typing import Any

from mpsolve.errors import EffortError, InputError, PrecisionError
from mpsolve.outcome import Reason
from mpsolve.parallel.threads import one_thread
from mpsolve.problem.cases import Given, as_problem
from mpsolve.progress import Progress
from mpsolve.proof.effort import Effort, begun
from mpsolve.ranges.answer import Interval, Spent
from mpsolve.ranges.least_onset import Least, Question
from mpsolve.ranges.never import never_unstable
from mpsolve.ranges.scope import OpenError, checked_over, from_above_rest, one_path, scope_of

_BOXES = 1_000_000


@dataclass(frozen=True)
class AtWorst:
    """over: both ranges; found: None where it stays open, for a reason."""

    over: dict[str, Interval]
    found: Least | None
    reason: Reason | None
    cost: Spent


def at_worst(
    given: Given,
    over: Mapping[str, Any],
    worst: Mapping[str, Any],
    digits: int,
    effort: Effort | None,
    progress: Progress,
    check: bool,
) -> AtWorst:
    """The least onset; InputError where the ranges cannot be, or are not two."""
    started = process_time()
    problem = as_problem(given)
    first, second = checked_over(given, over), checked_over(given, worst)
    one_path(first)
    if len(second) != 1 or first.keys() & second.keys():
        stated = f"names {', '.join(second)}, and over {', '.join(first)}"
        raise InputError("worst", f"{stated}: give a range of one parameter each, of two different ones")
    if never_unstable(problem, first | second):
        return AtWorst(first | second, Least(None, None, None, "", ()), None, Spent(process_time() - started))
    both = from_above_rest(problem, first | second)
    budget = begun(effort, _BOXES)
    reason, found = None, None
    with one_thread():
        question = Question(problem, both, scope_of(problem, both), digits, budget, progress, check)
        try:
            found = question.answer()
        except (OpenError, EffortError) as error:
            reason = error.reason
        except PrecisionError as error:
            reason = Reason("worst", str(error), {}, "give shorter ranges")
    checked = question.base.cost.verification if question.base is not None else 0.0
    return AtWorst(both, found, reason, Spent(process_time() - started - checked, checked, budget.spent))
