"""Certified studies with one process and with two, and float64 cases a second; each in seconds of the clock.

The ratio needs two idle processors: what else runs there lowers it.
"""

from __future__ import annotations

import os
import tempfile
import time
from pathlib import Path
from resource import RUSAGE_CHILDREN, RUSAGE_SELF, getrusage
from typing import Any

from measure import seconds

from mpsolve import Study, study

GOAL = 1.8
CERTIFIED: dict[str, Any] = {
    "study": {"kind": "certified"},
    "parameters": {
        "alpha": {"start": "0.3", "stop": "0.79", "step": "0.005"},
        "eta_b": "0.05",
        "eta_m": [50, 70],
        "d": ["1", "1.5"],
    },
}
FLOAT64: dict[str, Any] = {
    "study": {"kind": "float64"},
    "parameters": {
        "alpha": {"start": "0.1", "stop": "1.09", "step": "0.01"},
        "eta_b": "0.05",
        "eta_m": {"start": 1, "stop": 100, "step": 1},
        "d": ["1", "1.5", "2"],
    },
}


def timed(spec: dict[str, Any], workers: int) -> tuple[float, float, Study, bytes]:
    """Seconds of the clock and of processors, the start of the processes included; the study and its export."""
    with tempfile.TemporaryDirectory() as folder:
        clock, used = time.perf_counter(), processors()
        made = study(spec, store=Path(folder, "study.sqlite"), workers=workers)
        clock, used = time.perf_counter() - clock, processors() - used
        return clock, used, made, made.save(Path(folder, "study.json")).read_bytes()


def processors() -> float:
    """Processor seconds of this process and of those that it has seen end."""
    return sum(usage.ru_utime + usage.ru_stime for usage in map(getrusage, (RUSAGE_SELF, RUSAGE_CHILDREN)))


def compare() -> None:
    (one, one_used, made, first), (two, two_used, _, second) = timed(CERTIFIED, 1), timed(CERTIFIED, 2)
    print(
        f"certified, {made.total} cases: 1 process {seconds(one)}, 2 processes {seconds(two)}   "
        f"1/2 = {one / two:.2f}  (goal: {GOAL} or more; {os.cpu_count()} processors, load {os.getloadavg()[0]:.1f})\n"
        f"processor time: {seconds(one_used)} and {seconds(two_used)}   2·1/2 = {2 * one_used / two_used:.2f}, the "
        "ratio on two processors that do nothing else"
    )
    assert made.answered
    assert first == second
    taken, _, made, _ = timed(FLOAT64, 1)
    print(f"float64, {made.total} cases: {seconds(taken)}, {made.total / taken:.0f} cases/s in one process")
    assert made.complete


def test_one_and_two_processes_agree() -> None:
    compare()


if __name__ == "__main__":
    compare()
