"""Figure 5: the unsteady harmonic part of the vibrations of the rear contact point, without damping, α = 0.8.

η_M = 40, d = 2, 2.5, …, 4.5; black dotted: envelopes. At every distance there are two pairs
of frequencies.
"""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
from style import run
from vibration import TAU, alone, beat, checked_vibration, harmonic_figure, pair_of_masses, vibration

ETA_M = 40
ALPHA = "0.8"
DISTANCES = ("2", "2.5", "3", "3.5", "4", "4.5")

CASES = [[pair_of_masses(ALPHA, ETA_M, d) for d in row] for row in (DISTANCES[:3], DISTANCES[3:])]


def check() -> None:
    """Two pairs about that of one mass; the higher one has the larger amplitude up to d = 3.5; beats by distance."""
    found = [checked_vibration(case) for row in CASES for case in row]
    single = alone(CASES[0][0])
    for panel in found:
        lower, higher = (q.real for q in panel.q)
        assert lower < single < higher  # Section 4.2
    sizes = np.array([panel.envelope.amplitudes for panel in found])
    assert (sizes[:, 0] > sizes[:, 1]).tolist() == [False] * 4 + [True] * 2
    # so at d = 4 the least amplitude, positive in Figure 4, is 0 at some α between 0.5 and 0.8
    first, second = vibration(pair_of_masses("0.5", ETA_M, "4"), [0]).envelope.amplitudes
    assert first < second
    beats = [beat(panel.q) for panel in found]
    assert beats[1] == min(beats)
    assert np.all(np.diff(beats[1:]) > 0)  # slower with the distance


def visualize(path: Path | str = "figure_05.svg", tau: Any = TAU) -> Path:
    """Writes the picture and returns its path."""
    return harmonic_figure(path, CASES, tau)


if __name__ == "__main__":
    run(check, visualize, "figure_05")
