"""Figure 3: the unsteady harmonic part of the vibrations of the rear contact point, without damping, η_M = 70.

d = 0.5, 1, 1.5 (rows), a) α = 0.5, b) α = 0.8, c) α = 0.9 (columns); black dotted: envelopes. Where the
higher pair of frequencies is missing (d = 0.5, α = 0.9) the amplitude is constant.
"""

from __future__ import annotations

from pathlib import Path
from typing import Any

from style import run
from vibration import TAU, harmonic_figure, pair_of_masses

ETA_M = 70
DISTANCES = ("0.5", "1", "1.5")
ALPHAS = ("0.5", "0.8", "0.9")

CASES = [[pair_of_masses(alpha, ETA_M, d) for alpha in ALPHAS] for d in DISTANCES]


def visualize(path: Path | str = "figure_03.svg", tau: Any = TAU) -> Path:
    """Writes the picture and returns its path."""
    return harmonic_figure(path, CASES, tau)


if __name__ == "__main__":
    run(visualize, "figure_03")
