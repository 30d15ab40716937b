"""Searches that wait for exclusions, run side by side: each round answers the jobs of all of them in one sweep.

A search is a generator that yields a `Job`, is sent its `Cover`, and returns its result. A few boxes cost as much as
a thousand to sweep over, so that twenty searches together take little longer than five alone.
"""

from __future__ import annotations

from collections.abc import Callable, Generator, Sequence
from typing import TypeVar

from mpsolve.stability.exclude import Cover, Job, exclude_all

Result = TypeVar("Result")
Search = Generator[Job, Cover, Result]


def alone(search: Search[Result]) -> Result:
    """The result of one search."""
    return together([search])[0]


def together(searches: Sequence[Search[Result]], tell: Callable[[float], None] | None = None) -> list[Result]:
    """The results of all, in order. `tell` hears which part of them is done. An exception in one ends all."""
    results: dict[int, Result] = {}
    jobs: dict[int, Job] = {}
    for k, search in enumerate(searches):
        _advance(k, search, None, jobs, results)
    while jobs:
        waiting = _alike(jobs)
        covers = exclude_all([jobs.pop(k) for k in waiting])
        for k, cover in zip(waiting, covers, strict=True):
            _advance(k, searches[k], cover, jobs, results)
        if tell is not None:
            tell(len(results) / len(searches))
    return [results[k] for k in range(len(searches))]


def _advance(
    k: int, search: Search[Result], cover: Cover | None, jobs: dict[int, Job], results: dict[int, Result]
) -> None:
    try:
        jobs[k] = next(search) if cover is None else search.send(cover)
    except StopIteration as end:
        results[k] = end.value


def _alike(jobs: dict[int, Job]) -> list[int]:
    """The searches whose jobs may share a sweep with that of the first."""
    kind = next(iter(jobs.values())).family.kind
    return [k for k, job in jobs.items() if job.family.kind == kind]
