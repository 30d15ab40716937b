"""The paper's study in float64, or a part of it: counts and roots on the whole sheet, then of Im q < 0 alone.

`python bench_frequencies.py study` runs all 366,660 cases of the paper's ranges, in two processes.
"""

from __future__ import annotations

import os
import sys
import time
from typing import Any

import numpy as np

from mpsolve import Frequencies, Problem, frequencies, tracks, vehicles

STUDY = (
    np.arange(1, 141) / 100,
    np.r_[0, np.arange(4, 100) / 100],
    np.array([10.0, 40.0, 70.0]),
    np.arange(1, 10) / 2,
)

PAIR = Problem(tracks.EulerBernoulli(EI="0.25", m=1, k=1), vehicles.train(vehicles.Mass(40), 2, 1), v="0.5")


def run_study(part: tuple[Any, ...], workers: int, region: str = "sheet") -> Frequencies:
    """The paper's study by paths: velocity, damping c = 2 η_b, masses, distance."""
    alpha, eta_b, eta_m, d = np.ix_(*part)
    over = {"v": alpha, "track.c": 2 * eta_b, "vehicles.M": eta_m, "gap[0]": d}
    start, used = time.perf_counter(), time.process_time()
    result = frequencies(PAIR, over, region, workers=workers)
    wall, used = time.perf_counter() - start, time.process_time() - used
    number = result.count.size
    labels, counts = np.unique(result.status, return_counts=True)
    outcome = ", ".join(f"{count} {label}" for label, count in zip(labels.tolist(), counts.tolist(), strict=True))
    print(
        f"{region}: {number} cases, {workers} processes: {wall:.1f} s, {number / wall:.0f} cases a second"
        f"{f', {number / used:.0f} a second of a processor' if workers == 1 else ''}; {outcome}"
    )
    return result


def test_a_part_of_the_study() -> None:
    result = run_study((STUDY[0], STUDY[1][2:4], *STUDY[2:]), 1)
    assert (result.count >= 0).all()


def main() -> None:
    whole = "study" in sys.argv[1:]
    part, workers = STUDY if whole else (STUDY[0], STUDY[1][2:8], *STUDY[2:]), min(2, os.cpu_count() or 1)
    sheet = run_study(part, workers if whole else 1)
    damped = (part[0], part[1][part[1] > 0], *part[2:])
    below = run_study(damped, workers if whole else 1, "unstable")
    proved = sheet.unstable[:, part[1] > 0]
    assert ((below.count == proved) | (below.count < 0) | (proved < 0)).all()


if __name__ == "__main__":
    main()
