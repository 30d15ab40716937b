"""Figure A.5: vibrations of the rear contact point compared, η_M = 70, α = 0.9, η_b = 0.05, d = 0.5, 1, 1.5.

Grey: the full solution (lines: infinite beam, circles: finite beam); dotted: steady and harmonic part; black:
superposition; dashed: one doubled mass, for d = 0.5 and 1 only. The last is unstable: it is above the
onset at α = 0.6669.
"""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
from comparison import check_late_beam, checked_comparison, comparison_figure, missed
from style import run
from vibration import pair_of_masses, vibration

ETA_M = 70
ETA_B = "0.05"
ALPHA = "0.9"
DISTANCES = ("0.5", "1", "1.5")
TAU: Any = np.linspace(0.0, 400.0, 801)

CASES = [pair_of_masses(ALPHA, ETA_M, d, ETA_B) for d in DISTANCES]


def check() -> None:
    """The finite beam grows as certified at d = 1.5, and only there; 'excellent agreement'; no superposition."""
    found = checked_comparison(CASES[2], TAU)  # d = 1.5
    check_late_beam(found)
    assert [min(q.imag for q in vibration(case, [0]).q) < 0 for case in CASES] == [False, False, True]
    assert max(missed(case) for case in CASES) < 0.05
    assert np.abs(found.full - found.added).max() > 1


def visualize(path: Path | str = "figure_a5.svg", tau: Any = TAU) -> Path:
    """Writes the picture and returns its path."""
    return comparison_figure(path, CASES, tau)


if __name__ == "__main__":
    run(check, visualize, "figure_a5")
