"""Stable for all parameters of a box: at once, or part by part in the store of a study, which goes on when killed."""

from __future__ import annotations

import os
from collections.abc import Mapping
from concurrent.futures import Executor
from dataclasses import replace
from time import process_time
from typing import Any

from mpsolve.errors import InputError
from mpsolve.outcome import Reason, Status
from mpsolve.problem.cases import Given, as_problem
from mpsolve.problem.outputfile import problem_toml
from mpsolve.problem.problem import Problem
from mpsolve.problem.toml import parsed
from mpsolve.progress import Progress, silent
from mpsolve.proof.effort import Effort, begun
from mpsolve.ranges.answer import Interval, Spent
from mpsolve.ranges.robust import at_first_sight, prove_box
from mpsolve.ranges.robust_answer import Robust
from mpsolve.ranges.scope import checked_over, from_above_rest
from mpsolve.studies.plan import BOXES
from mpsolve.studies.run import Study, study

_PARTS = 64  # of the whole, at least


def prove_stable(
    problem: Given,
    *,
    over: Mapping[str, Any],
    store: str | os.PathLike[str] | None = None,
    executor: Executor | None = None,
    effort: Effort | None = None,
    progress: Progress | None = None,
    workers: int | None = 1,
    check: bool = True,
) -> Robust:
    """Whether no root grows, for all values of several parameters in closed ranges at once.

    over: {path: (low, high)} in the problem's units, as many as wanted. A point of the box at which a root grows is
    sought first, and certified; else the box is covered. check: have the standalone verifier pass the certificate.
    workers: processes that share the boxes, all processors if None; a script then calls this under
    `if __name__ == "__main__":`. Raises InputError for paths and ranges that cannot be.

    store: the path of a file for proofs that take long. The box is cut into 64 parts or more, which are the entries
    of a study (kind "stable"): each is kept when it is proved, with a certificate of its own, and the same call goes
    on where an earlier one was killed. executor: any concurrent.futures.Executor in place of processes, such as
    `client.get_executor()` of Dask. effort: of each part, in evaluations; with more of it the parts that were left
    undecided are tried again. InputError if the store is that of another question, StudyError if it cannot be used.
    """
    if store is None:
        if executor is not None:
            raise InputError("executor", 'is given without a store: give store="….sqlite" too, or workers alone')
        return prove_box(problem, over=over, effort=effort, progress=progress, workers=workers, check=check)
    started = process_time()
    given = as_problem(problem)
    ranges = from_above_rest(given, checked_over(problem, over))
    seen = at_first_sight(given, ranges, effort, check)
    if seen is not None:
        return replace(seen, problem=problem)
    spec = _spec(given, ranges, effort, check)
    tell = progress or silent
    made = study(
        spec, executor, store=store, workers=workers, progress=lambda done, total: tell("parts", done / total)
    )
    return replace(_read(given, ranges, made, check), problem=problem, cost=Spent.since(started))


def _spec(problem: Problem, over: Mapping[str, Interval], effort: Effort | None, check: bool) -> dict[str, Any]:
    limits = begun(effort)
    if limits.seconds is not None:
        stated = "has seconds, but what a store keeps may not depend on the machine"
        raise InputError("effort", f"{stated}: give Effort(evaluations=…), the boxes of each part")
    count = next(n for n in range(2, _PARTS + 1) if n ** len(over) >= _PARTS)
    return {
        **parsed(problem_toml(problem), "problem"),
        "study": {"kind": "stable", "certificates": check, "boxes": limits.evaluations or BOXES},
        "parameters": {path: {"low": str(a), "high": str(b), "parts": count} for path, (a, b) in over.items()},
    }


def _read(problem: Problem, over: Mapping[str, Interval], made: Study, check: bool) -> Robust:
    """What the entries say of the whole."""
    still, verified, reasons = [], 0, []
    for index, _, result in made.results():
        if result.unstable:
            found = prove_box(problem, over=made.spec.part(index), check=check)
            if found.stable is False:
                return replace(found, over=over)
        if result.unstable != 0:
            still.append(made.spec.part(index))
            reasons.append(result.reason)
        verified += result.status == Status.PROVED.value
    known = {"parts": made.total, "proved": made.total - len(still), "store": str(made.path)}
    if still:
        stated = f"{len(still)} of {made.total} parts are open: {reasons[0]}"
        reason = Reason("parts", stated, {"parts": str(len(still))}, "")
        return Robust(problem, over, Status.UNDECIDED, reason, known, open=tuple(still))
    note = f"no one certificate states the whole: {verified} of its {made.total} parts have one each, in {made.path}"
    return Robust(problem, over, Status.UNVERIFIED, None, known, stable=True, note=note)
