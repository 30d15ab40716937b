"""Figure 8: the unsteady harmonic part of the vibrations of the rear contact point, without damping, η_M = 10.

d = 0.5, 1, 1.5, α = 0.5; black dotted: envelopes. At d = 0.5 the higher pair of frequencies ends at
α = 0.3727 already, and the amplitude is constant.
"""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
from style import run
from vibration import harmonic_figure, pair_of_masses

ETA_M = 10
ALPHA = "0.5"
DISTANCES = ("0.5", "1", "1.5")
TAU: Any = np.linspace(0.0, 200.0, 2001)

CASES = [[pair_of_masses(ALPHA, ETA_M, d) for d in DISTANCES]]


def visualize(path: Path | str = "figure_08.svg", tau: Any = TAU) -> Path:
    """Writes the picture and returns its path."""
    return harmonic_figure(path, CASES, tau)


if __name__ == "__main__":
    run(visualize, "figure_08")
