"""Figure 6: the unsteady harmonic part of the vibrations of the rear contact point, without damping, α = 0.9.

η_M = 40, d = 2, 2.5, …, 4.5; black dotted: envelopes. For d = 2, 2.5, 3 the higher pair has
met the branch cut, and the amplitude is constant.
"""

from __future__ import annotations

from pathlib import Path
from typing import Any

from style import run
from vibration import TAU, harmonic_figure, pair_of_masses

ETA_M = 40
ALPHA = "0.9"
DISTANCES = ("2", "2.5", "3", "3.5", "4", "4.5")

CASES = [[pair_of_masses(ALPHA, ETA_M, d) for d in row] for row in (DISTANCES[:3], DISTANCES[3:])]


def visualize(path: Path | str = "figure_06.svg", tau: Any = TAU) -> Path:
    """Writes the picture and returns its path."""
    return harmonic_figure(path, CASES, tau)


if __name__ == "__main__":
    run(visualize, "figure_06")
