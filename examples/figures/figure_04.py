"""Figure 4: the unsteady harmonic part of the vibrations of the rear contact point, without damping, α = 0.5.

η_M = 40, d = 2, 2.5, …, 4.5; black dotted: envelopes. At every distance there are two pairs
of frequencies close to each other: slow beats.
"""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
from style import run
from vibration import alone, beat, checked_vibration, harmonic_figure, pair_of_masses

ETA_M = 40
ALPHA = "0.5"
DISTANCES = ("2", "2.5", "3", "3.5", "4", "4.5")
TAU: Any = np.linspace(0.0, 800.0, 4001)

CASES = [[pair_of_masses(ALPHA, ETA_M, d) for d in row] for row in (DISTANCES[:3], DISTANCES[3:])]


def check() -> None:
    """Two pairs, above and below that of one mass; slow beats; at d = 2 the vibration almost dies in between."""
    found = [checked_vibration(case) for row in CASES for case in row]
    single = alone(CASES[0][0])
    for panel in found:
        lower, higher = (q.real for q in panel.q)
        assert lower < single < higher  # Section 4.2
        assert beat(panel.q) > 10 * 2 * np.pi / lower  # in swings
    least = [panel.envelope.least / panel.envelope.greatest for panel in found]
    assert least[0] == min(least) < 0.01  # Section 4.2: it can be practically zero
    assert least[-1] < 0.5  # with superposition it would be 1, even at d = 4.5 (conclusion (viii))


def visualize(path: Path | str = "figure_04.svg", tau: Any = TAU) -> Path:
    """Writes the picture and returns its path."""
    return harmonic_figure(path, CASES, tau)


if __name__ == "__main__":
    run(check, visualize, "figure_04")
