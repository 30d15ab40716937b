"""Independent pieces of work in several processes: the results in order, whatever the number of processes."""

from __future__ import annotations

import os
from collections.abc import Callable, Sequence
from concurrent.futures import ProcessPoolExecutor, as_completed
from concurrent.futures.process import BrokenProcessPool
from multiprocessing import get_context, parent_process
from signal import SIG_DFL, SIG_IGN, SIGINT, getsignal, signal
from threading import Thread
from typing import Any, TypeVar

from flint import arb

from mpsolve.errors import InputError, MpsolveError, known
from mpsolve.stability.search import Tell

Job = TypeVar("Job")
Result = TypeVar("Result")

PackedBall = tuple[tuple[int, int], tuple[int, int]]
"""(mantissa, exponent) of the midpoint and of the radius: balls do not travel between processes, these do."""


def pack(ball: Any) -> PackedBall:
    """A finite flint.arb in exact integers."""
    middle, middle_exponent = ball.mid().man_exp()
    radius, radius_exponent = ball.rad().man_exp()
    return (int(middle), int(middle_exponent)), (int(radius), int(radius_exponent))


def unpack(packed: PackedBall) -> Any:
    """The flint.arb with the same midpoint, and the same radius up to its rounding upward, at any precision."""
    return arb(*packed)


_BUNCH = 40  # pieces of work that are done side by side, where this is quicker than one by one
_BUNCHES = 8  # few pieces make at least so many bunches, so that processors have something to share


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
    parent = known(parent_process(), "the parent of a worker")

    def watch() -> None:
        parent.join()
        os._exit(1)

    Thread(target=watch, daemon=True).start()


def run_bunches(
    work: Callable[[Sequence[Job]], list[Result]],
    jobs: Sequence[Job],
    workers: int | None = None,
    tell: Tell | None = None,
    stage: str = "working",
) -> list[Result]:
    """The results of work(bunch) for bunches of jobs in order, the same for any number of workers; see `run`."""
    size = min(_BUNCH, -(-len(jobs) // _BUNCHES)) or 1
    bunches = [jobs[k : k + size] for k in range(0, len(jobs), size)]
    return [result for results in run(work, bunches, workers, tell, stage) for result in results]


def run(
    work: Callable[[Job], Result],
    jobs: Sequence[Job],
    workers: int | None = None,
    tell: Tell | None = None,
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


def _here(work: Callable[[Job], Result], jobs: Sequence[Job], tell: Tell | None, stage: str) -> list[Result]:
    results = []
    for done, job in enumerate(jobs, 1):
        results.append(work(job))
        if tell is not None:
            tell(stage, done / len(jobs))
    return results
