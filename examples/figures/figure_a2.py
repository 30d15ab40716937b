"""Figure A.2: vibrations of the rear contact point compared, η_M = 40, α = 0.9, d = 0.5, 1, …, 4.5, no damping.

Grey: the full solution (lines: infinite beam, circles: finite beam); dotted: steady and harmonic part; black:
superposition; dashed: one doubled mass, for d = 0.5 and 1 only. From d = 1.5 to 3 the truly transient part
shows most; up to d = 3 the higher pair of frequencies has met the branch cut.
"""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
from comparison import TAU, checked_comparison, comparison_figure, missed, moving_forces
from induced import end_of_line
from style import agree, run
from vibration import pair_of_masses, vibration

ETA_M = 40
ETA_B = "0"
ALPHA = "0.9"
DISTANCES = ("0.5", "1", "1.5", "2", "2.5", "3", "3.5", "4", "4.5")

CASES = [pair_of_masses(ALPHA, ETA_M, d, ETA_B) for d in DISTANCES]


def check() -> None:
    """The finite beam, the classic steady state, and where the truly transient part counts (Appendix)."""
    found = checked_comparison(CASES[2])  # d = 1.5
    agree(found.harmonic - vibration(CASES[2], found.tau).w, moving_forces(found.case), 1e-9)
    share = [missed(case) for case in CASES]
    assert min(share[2:6]) > max(share[:2] + share[6:])  # from d = 1.5, recovered from 3.5 on
    assert np.abs(found.full - found.harmonic).max() > 1
    assert np.abs(found.full - found.added).max() > 1
    assert [end_of_line(ETA_M, d) < 0.9 for d in DISTANCES] == [True] * 6 + [False] * 3  # Section 4.2


def visualize(path: Path | str = "figure_a2.svg", tau: Any = TAU) -> Path:
    """Writes the picture and returns its path."""
    return comparison_figure(path, CASES, tau)


if __name__ == "__main__":
    run(check, visualize, "figure_a2")
