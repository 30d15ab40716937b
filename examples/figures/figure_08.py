"""Figure 8: the unsteady harmonic part of the vibrations of the rear contact point, without damping, η_M = 10.

d = 0.5, 1, 1.5, α = 0.5; black dotted: envelopes. At d = 0.5 the higher pair of frequencies ends at
α = 0.3727 already, and the amplitude is constant.
"""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
from induced import LAST, end_of_line
from style import run
from vibration import alone, checked_vibration, harmonic_figure, pair_of_masses

ETA_M = 10
ALPHA = "0.5"
DISTANCES = ("0.5", "1", "1.5")
TAU: Any = np.linspace(0.0, 200.0, 2001)

CASES = [[pair_of_masses(ALPHA, ETA_M, d) for d in DISTANCES]]


def check() -> None:
    """One pair and a constant amplitude at d = 0.5, past α = 0.37, else two (Section 4.2); the order of the lines."""
    found = [checked_vibration(case) for case in CASES[0]]
    assert [len(panel.q) for panel in found] == [1, 2, 2]
    assert [panel.envelope.least < panel.envelope.greatest for panel in found] == [False, True, True]
    assert LAST[ETA_M]["0.5"] < end_of_line(ETA_M, "0.5") < LAST[ETA_M]["0.5"] + 0.01
    single, doubled = alone(CASES[0][0]), alone(pair_of_masses(ALPHA, 2 * ETA_M, "1"))
    lower = [panel.q[0].real for panel in found]
    assert doubled < lower[0] < lower[1] < lower[2] < single < min(panel.q[1].real for panel in found[1:])


def visualize(path: Path | str = "figure_08.svg", tau: Any = TAU) -> Path:
    """Writes the picture and returns its path."""
    return harmonic_figure(path, CASES, tau)


if __name__ == "__main__":
    run(check, visualize, "figure_08")
