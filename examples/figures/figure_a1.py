"""Figure A.1: vibrations of the rear contact point compared, η_M = 40, α = 0.5, d = 0.5, 1, …, 4.5, no damping.

Grey: the full solution (lines: infinite beam, circles: finite beam); dotted: steady and harmonic part; black:
superposition; dashed: one doubled mass, for d = 0.5 and 1 only. The truly transient part hardly shows.
"""

from __future__ import annotations

from pathlib import Path
from typing import Any

from comparison import TAU, comparison_figure
from style import run
from vibration import pair_of_masses

ETA_M = 40
ETA_B = "0"
ALPHA = "0.5"
DISTANCES = ("0.5", "1", "1.5", "2", "2.5", "3", "3.5", "4", "4.5")

CASES = [pair_of_masses(ALPHA, ETA_M, d, ETA_B) for d in DISTANCES]


def visualize(path: Path | str = "figure_a1.svg", tau: Any = TAU) -> Path:
    """Writes the picture and returns its path."""
    return comparison_figure(path, CASES, tau)


if __name__ == "__main__":
    run(visualize, "figure_a1")
