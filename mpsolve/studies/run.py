"""Studies: results over as many entries as one likes, by any executor, in a file that a second run completes."""

from __future__ import annotations

import os
from collections.abc import Callable, Iterable, Iterator, Mapping
from concurrent.futures import FIRST_COMPLETED, Executor, Future, wait
from concurrent.futures.process import BrokenProcessPool
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from mpsolve.errors import InputError, StudyError
from mpsolve.parallel.pool import WORKER_ENDED, checked_workers, process_pool
from mpsolve.problem.problem import Problem
from mpsolve.studies.arrays import stored_results
from mpsolve.studies.blocks import GOOD, Block, Result, work
from mpsolve.studies.design import Value
from mpsolve.studies.export import export
from mpsolve.studies.spec import Spec, read_spec
from mpsolve.studies.store import Store, store_path

Progress = Callable[[int, int], None]
AHEAD = 64  # blocks that are handed to an executor at a time; it bounds the memory


@dataclass(frozen=True)
class Study:
    """What a store holds of a study. tally: the number of finished entries of each status."""

    path: Path
    spec: Spec
    tally: Mapping[str, int]

    @property
    def total(self) -> int:
        """The number of entries."""
        return self.spec.total

    @property
    def finished(self) -> int:
        """The number of entries that have a result, of whatever status."""
        return sum(self.tally.values())

    @property
    def complete(self) -> bool:
        """Whether every entry is finished, whatever its result."""
        return self.finished == self.total

    def problem(self, index: int) -> Problem:
        """The exact problem of one entry, to be certified, say; InputError where it cannot be."""
        return self.spec.problem(index)

    @property
    def answered(self) -> bool:
        """Whether every entry is finished and neither undecided, unresolved nor refused.

        In a certified study that is a proof of each; a float64 study proves nothing.
        """
        return sum(self.tally.get(status, 0) for status in GOOD) == self.total

    def results(self, start: int = 0) -> Iterator[tuple[int, dict[str, Value], Result]]:
        """(index, exact parameters, result) of each finished entry from the index `start` on, one block in memory.

        Raises StudyError if the file is damaged.
        """
        with Store.read(self.path) as store:
            yield from stored_results(store, start)

    def save(self, path: str | os.PathLike[str]) -> Path:
        """Writes .csv, .json, .npz or .parquet, whole or not at all; see mpsolve/studies/export.py.

        Raises InputError for another name, CertificateError if it cannot be written, StudyError if the store is
        damaged.
        """
        return export(self.path, path)


def study(
    spec: Mapping[str, Any] | str | os.PathLike[str],
    executor: Executor | None = None,
    *,
    store: str | os.PathLike[str],
    workers: int | None = None,
    progress: Progress | None = None,
    ahead: int = AHEAD,
) -> Study:
    """Computes what `spec` (a mapping, or the path of a TOML file) describes and `store` does not hold yet.

        title = "…"                      # may be left out
        problem = "rail.toml"            # a problem file, or what would stand in one: v, [track], [[vehicle]] …
        [study]
        kind = "certified"               # or "float64": quick, by `frequencies`, without proof; or "stable": an entry
                                         # is a part of a box of parameters, proved for all its values at once
        digits = 15                      # certified digits of each root, 15 to 10000
        region = "unstable"              # or {below = h}, "sheet", {re_min, re_max, im_min, im_max} (certified)
        roots = true                     # float64 only; false: counts alone
        certificates = false             # true (so if stable): keep the certificate of each entry
        boxes = 100000                   # stable only: that the proof of one entry may take
        design = { kind = "grid" }       # every combination; "list": the first values together, the second, …;
                                         # { kind = "random" or "quasi-random", count = 1000, seed = 0 }
        [parameters]                     # any paths of the problem's parameters, in its units
        v = { start = 50, stop = 90, step = 0.5 }
        "track.k_pad" = [100e6, 300e6]
        "vehicles.wheel" = 900           # { low = 800, high = 1000 } in a random design; with parts = 8 if stable

    executor: any concurrent.futures.Executor whose workers can import mpsolve; None: `workers` processes (all
    processors if None; 1: this one), spawned, so that a script must call this under `if __name__ == "__main__":`.
    Results do not depend on it. Each block of entries (one certified entry; some thousand in float64) is stored when
    it is done: after an interruption the same call goes on, and computes what is damaged anew, as parts of boxes that
    are undecided. `ahead`: blocks that are handed out at a time, at least twice the number of workers.
    progress(finished, total) hears of each block.

    Raises InputError under the key at fault, or if the store is that of another study; StudyError if it cannot be
    written or is damaged, or if a worker ends before its work is done.
    """
    plan, path = read_spec(spec), store_path(store)
    if executor is not None and not callable(getattr(executor, "submit", None)):
        stated = f"is {executor!r}, which has no submit"
        raise InputError("executor", f"{stated}: give a concurrent.futures.Executor, or None for processes")
    if isinstance(ahead, bool) or not isinstance(ahead, int) or ahead < 1:
        raise InputError("ahead", f"is {ahead!r}: give a whole number from 1")
    workers = checked_workers(workers)
    with Store.create(path, plan) as file:
        finished = sum(file.tally().values())
        missing = (number for number in range(plan.blocks) if not file.holds(number))
        for block in _computed(plan, missing, executor, workers, ahead):
            file.put(block)
            finished = min(finished + len(plan.indices(block.number)), plan.total)
            if progress is not None:
                progress(finished, plan.total)
    return open_study(path)


def open_study(path: str | os.PathLike[str]) -> Study:
    """The study in the file at `path`, complete or not. InputError if there is none, StudyError if it is damaged."""
    path = store_path(path)
    with Store.read(path) as store:
        tally = store.tally()
        others = store.other_engines()
        if others and not tally:
            stated = f"{path} holds results of another version only ({', '.join(others)})"
            raise StudyError(f"{stated}: use that one, or run the study again with this one")
        return Study(path, store.spec, tally)


def _computed(
    spec: Spec, numbers: Iterable[int], executor: Executor | None, workers: int, ahead: int
) -> Iterator[Block]:
    """The blocks with these numbers, in the order in which they are done."""
    if executor is not None:
        yield from _by(executor, spec, numbers, ahead)
    elif min(workers, spec.blocks) == 1:
        for number in numbers:
            yield work(*spec.job(number))
    else:
        pool = process_pool(min(workers, spec.blocks))
        try:
            yield from _by(pool, spec, numbers, 4 * workers)
        except BaseException as error:
            pool.shutdown(wait=False, cancel_futures=True)
            if isinstance(error, BrokenProcessPool):
                raise StudyError(f"{WORKER_ENDED}; what is finished is stored, and the same call goes on") from None
            raise
        pool.shutdown()


def _by(executor: Executor, spec: Spec, numbers: Iterable[int], ahead: int) -> Iterator[Block]:
    """At most `ahead` blocks are under way at a time."""
    waiting: set[Future[Block]] = set()
    try:
        for number in numbers:
            waiting.add(executor.submit(work, *spec.job(number)))
            if len(waiting) >= ahead:
                yield from _next(waiting)
        while waiting:
            yield from _next(waiting)
    finally:
        for future in waiting:
            future.cancel()


def _next(waiting: set[Future[Block]]) -> Iterator[Block]:
    """Waits for a block, and takes all that are done."""
    done, _ = wait(waiting, return_when=FIRST_COMPLETED)
    waiting -= done
    for future in done:
        yield future.result()
