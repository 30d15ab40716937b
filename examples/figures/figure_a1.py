"""Figure A.1: vibrations of the rear contact point compared, η_M = 40, α = 0.5, d = 0.5, 1, …, 4.5, no damping.

Grey: the full solution (lines: infinite beam, circles: finite beam); dotted: steady and harmonic part; black:
superposition; dashed: one doubled mass, for d = 0.5 and 1 only. The truly transient part hardly shows.
"""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
from comparison import TAU, checked_comparison, comparison_figure, missed, moving_forces
from style import agree, run
from vibration import pair_of_masses, vibration

ETA_M = 40
ETA_B = "0"
ALPHA = "0.5"
DISTANCES = ("0.5", "1", "1.5", "2", "2.5", "3", "3.5", "4", "4.5")

CASES = [pair_of_masses(ALPHA, ETA_M, d, ETA_B) for d in DISTANCES]


def check() -> None:
    """The finite beam, the classic steady state, 'excellent agreement', and what cannot replace two masses."""
    found = checked_comparison(CASES[1])  # d = 1
    harmonic = vibration(CASES[1], found.tau).w
    agree(found.harmonic - harmonic, moving_forces(found.case), 1e-9)
    assert max(missed(case) for case in CASES) < 0.01
    assert np.abs(found.full - found.harmonic).max() < 0.01 * np.abs(harmonic).max()
    assert min(np.abs(found.full - other).max() for other in (found.added, found.doubled)) > 1
    assert found.doubled.max() > 1.2 * found.full.max()  # "noticeably higher"


def visualize(path: Path | str = "figure_a1.svg", tau: Any = TAU) -> Path:
    """Writes the picture and returns its path."""
    return comparison_figure(path, CASES, tau)


if __name__ == "__main__":
    run(check, visualize, "figure_a1")
