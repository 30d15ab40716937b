"""Independent pieces of work in several processes: the results in order, whatever the number of processes."""

from __future__ import annotations

import os
from collections.abc import Callable, Sequence
from concurrent.futures import ProcessPoolExecutor, as_completed
from concurrent.futures.process import BrokenProcessPool
from multiprocessing import get_context, parent_process
from signal import SIG_DFL, SIG_IGN, SIGINT, getsignal, signal
from threading import Thread
from typing import TypeVar

from mpsolve.errors import InputError, MpsolveError
from mpsolve.progress import Progress

Job = TypeVar("Job")
Result = TypeVar("Result")

WORKER_ENDED = (
    "a worker process ended before its work was done: allow fewer workers, and in a script call this under "
    'if __name__ == "__main__":'
)


def checked_workers(workers: int | None) -> int:
    """The number of processes, all processors if None; InputError for a number that cannot be."""
    if workers is None:
        return os.cpu_count() or 1
    if isinstance(workers, bool) or not isinstance(workers, int) or workers < 1:
        raise InputError("workers", f"is {workers!r}: give a whole number from 1")
    return workers


def process_pool(workers: int) -> ProcessPoolExecutor:
    """Spawned processes that end when this one does, even if it is killed, and without a word on Ctrl-C."""
    return ProcessPoolExecutor(workers, mp_context=get_context("spawn"), initializer=_end_with_parent)


def _end_with_parent() -> None:
    """Each worker holds both ends of the queue of jobs, so that it would wait for ever after a killed parent."""
    if getsignal(SIGINT) is not SIG_IGN:  # where it is ignored, as in a shell's background, this process does so too
        signal(SIGINT, SIG_DFL)
    parent = parent_process()
    if parent is None:  # a process that nobody started ends by itself
        return

    def watch() -> None:
        parent.join()
        os._exit(1)

    Thread(target=watch, daemon=True).start()


def run(
    work: Callable[[Job], Result],
    jobs: Sequence[Job],
    workers: int | None = None,
    tell: Progress | None = None,
    stage: str = "working",
) -> list[Result]:
    """[work(job) for job in jobs], in `workers` processes (all processors if None; 1: in this one).

    work: a function of a module, and jobs and results that can be pickled. tell(stage, fraction) hears of every
    piece that is done. Processes are spawned, so that a script must call this under `if __name__ == "__main__":`.
    InputError for a number of workers that cannot be; MpsolveError if a process dies.
    """
    workers = min(checked_workers(workers), len(jobs))
    if workers <= 1:
        return _here(work, jobs, tell, stage)
    results: dict[int, Result] = {}
    with process_pool(workers) as pool:
        try:
            places = {pool.submit(work, job): place for place, job in enumerate(jobs)}
            for future in as_completed(places):
                results[places[future]] = future.result()
                if tell is not None:
                    tell(stage, len(results) / len(jobs))
        except BrokenProcessPool:
            raise MpsolveError(WORKER_ENDED) from None
        except BaseException:
            pool.shutdown(wait=False, cancel_futures=True)
            raise
    return [results[place] for place in range(len(jobs))]


def _here(work: Callable[[Job], Result], jobs: Sequence[Job], tell: Progress | None, stage: str) -> list[Result]:
    results = []
    for done, job in enumerate(jobs, 1):
        results.append(work(job))
        if tell is not None:
            tell(stage, done / len(jobs))
    return results
