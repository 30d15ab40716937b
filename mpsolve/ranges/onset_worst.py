"""`onset` with a second parameter at its worst value, as an answer."""

from __future__ import annotations

from collections.abc import Mapping
from time import process_time
from typing import Any

from mpsolve.certificate.solve import checked_digits
from mpsolve.errors import EffortError, InputError, PrecisionError
from mpsolve.outcome import Reason, Status
from mpsolve.parallel.threads import one_thread
from mpsolve.problem.cases import Given, as_problem
from mpsolve.progress import Progress
from mpsolve.proof.effort import Effort
from mpsolve.ranges.answer import Interval, Spent
from mpsolve.ranges.least_onset import Question
from mpsolve.ranges.onset import Kind, Onset
from mpsolve.ranges.scope import OpenError, checked_over, from_above_rest, one_path, scope_of

_BOXES = 1_000_000


def onset_at_worst(
    problem: Given,
    over: Mapping[str, Any],
    worst: Mapping[str, Any],
    digits: int,
    effort: Effort | None,
    progress: Progress,
    check: bool,
) -> Onset:
    """See `onset`."""
    started = process_time()
    given, digits = as_problem(problem), checked_digits(digits)
    first, second = checked_over(given, over), checked_over(given, worst)
    one_path(first)
    if len(second) != 1 or first.keys() & second.keys():
        raise InputError("worst", 'is not one other path with its range: give one, such as {"gap[0]": (1, 2)}')
    both: dict[str, Interval] = from_above_rest(given, first | second)
    budget = effort.anew() if effort is not None else Effort(evaluations=_BOXES)
    with one_thread():
        question = Question(given, both, scope_of(given, both), digits, budget, progress, check)
        reason, found = None, None
        try:
            found = question.answer()
        except (OpenError, EffortError) as error:
            reason = error.reason
        except PrecisionError as error:
            reason = Reason("worst", str(error), {}, "give shorter ranges")
    checked = question.base.cost.verification if question.base is not None else 0.0
    cost = Spent(process_time() - started - checked, checked, budget.spent)
    if found is None:
        return Onset(problem, both, Status.UNDECIDED, reason, cost=cost, digits=digits)
    known: dict[str, Any] = {"value": found.value, "q": found.q, "worst": found.worst, "where": found.where}
    kind = Kind.STABLE if found.value is None else Kind.CROSSES
    return Onset(problem, both, Status.UNVERIFIED, proofs=found.proofs, cost=cost, digits=digits, kind=kind, **known)
