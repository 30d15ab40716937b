"""Figure 3: the unsteady harmonic part of the vibrations of the rear contact point, without damping, η_M = 70.

d = 0.5, 1, 1.5 (rows), a) α = 0.5, b) α = 0.8, c) α = 0.9 (columns); black dotted: envelopes. Where the
higher pair of frequencies is missing (d = 0.5, α = 0.9) the amplitude is constant.
"""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
from induced import end_of_line
from style import run
from vibration import TAU, checked_vibration, harmonic_figure, pair_of_masses

ETA_M = 70
DISTANCES = ("0.5", "1", "1.5")
ALPHAS = ("0.5", "0.8", "0.9")

CASES = [[pair_of_masses(alpha, ETA_M, d) for alpha in ALPHAS] for d in DISTANCES]


def check() -> None:
    """One pair where the higher line has ended, else two; the share of the higher one grows with d, mostly with α."""
    found = [[checked_vibration(case) for case in row] for row in CASES]
    assert [[len(panel.q) for panel in row] for row in found] == [[2, 2, 1], [2, 2, 2], [2, 2, 2]]
    assert 0.8 < end_of_line(ETA_M, "0.5") < 0.9
    sizes = np.array([[(*panel.envelope.amplitudes, 0)[:2] for panel in row] for row in found])
    share = sizes[..., 1] / sizes[..., 0]
    # Section 4.2 says that it grows with d and α; it does but for the panel with one pair
    assert np.all(np.diff(share, axis=0) > 0)
    assert np.all(np.diff(share[:, :2], axis=1) > 0)
    assert np.all(np.diff(share[1:], axis=1) > 0)
    assert share[2, 2] > 1  # conclusion (vii)


def visualize(path: Path | str = "figure_03.svg", tau: Any = TAU) -> Path:
    """Writes the picture and returns its path."""
    return harmonic_figure(path, CASES, tau)


if __name__ == "__main__":
    run(check, visualize, "figure_03")
