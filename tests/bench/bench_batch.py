"""Float64 counts of batches: problems a second in one process, and how many times as fast as `certify` in a loop.

Goals: 200 problems a second for 16 contacts on the paper's beam, 60 on a two-layer track; pairs much faster.
"""

from __future__ import annotations

import time
from typing import Any

import numpy as np

from mpsolve import Problem, certify, frequencies, tracks, vehicles
from mpsolve.parallel.threads import one_thread

BEAM = tracks.EulerBernoulli(EI="0.25", m=1, k=1, c="0.1")
TWO_LAYER = tracks.TwoLayer(
    EI="6.38e6", m="60.2", k_pad="300e6", c_pad="3e4", m_sleeper="250", k_ballast="100e6", c_ballast="8e4"
)
BOGIE = vehicles.Bogie(wheel=900, frame=1500, inertia=800, wheelbase="2.5", k="1.2e6", c="1e4", k_contact="1e9")
COACH = vehicles.Coach(body=30000, inertia="1e6", bogie=BOGIE, pivots=17, k2="0.4e6", c2="2e4")
CASES: dict[str, tuple[Any, Any, tuple[float, float], int, float]] = {
    "2 masses, paper's beam": (BEAM, vehicles.train(vehicles.Mass(40), 2, "1.5"), (0.1, 1.2), 2000, 0),
    "16 masses, paper's beam": (BEAM, vehicles.train(vehicles.Mass(40), 16, "1.5"), (0.3, 0.9), 300, 200),
    "2 masses, two layers": (TWO_LAYER, vehicles.train(vehicles.Mass(900), 2, "2.5"), (50, 1500), 1000, 0),
    "16 masses, two layers": (TWO_LAYER, vehicles.train(vehicles.Mass(900), 16, "2.5"), (50, 1400), 200, 60),
    "a coach, two layers": (TWO_LAYER, vehicles.train(COACH, 1, 25), (50, 1400), 300, 0),
}


def line(name: str, proofs: int = 3) -> float:
    """Prints what a batch costs, counts and roots, beside a few proofs; problems a second of the counts."""
    track, formation, (low, high), size, goal = CASES[name]
    problem = Problem(track, formation, v=low)
    v = np.linspace(low, high, size)
    frequencies(problem, {"v": v[:2]})  # what is loaded and decided once
    times = []
    for roots in (False, True):
        start = time.process_time()
        found = frequencies(problem, {"v": v}, roots=roots)
        times.append((time.process_time() - start) / size)
    start = time.process_time()
    for k in np.linspace(0, size - 1, proofs).astype(int).tolist():
        proved = certify(problem.changed("v", float(v[k])), region="unstable", digits=15, check=False)
        assert found.count[k] in (-1, proved.count), (name, v[k])
    proof = (time.process_time() - start) / proofs
    open_ = int((found.count < 0).sum())
    print(
        f"{name:25} counts {1 / times[0]:7.0f}/s, with roots {1 / times[1]:7.0f}/s"
        f"{f'  (goal {goal:.0f})' if goal else ''}   {proof / times[1]:6.0f} times as fast as certify; "
        f"{int((found.count > 0).sum())} of {size} unstable, {open_} unresolved",
        flush=True,
    )
    return 1 / times[0]


def main() -> None:
    with one_thread():
        for name in CASES:
            line(name)


def test_batches_are_counted() -> None:
    assert line("2 masses, paper's beam", 1) > 0


if __name__ == "__main__":
    main()
