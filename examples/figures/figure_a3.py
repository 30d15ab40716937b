"""Figure A.3: vibrations of the rear contact point compared, η_M = 70, α = 0.5, η_b = 0.05, d = 0.5, 1, 1.5.

Grey: the full solution (lines: infinite beam, circles: finite beam); dotted: steady and harmonic part; black:
superposition; dashed: one doubled mass, for d = 0.5 and 1 only. All three are stable.
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
ALPHA = "0.5"
DISTANCES = ("0.5", "1", "1.5")
TAU: Any = np.linspace(0.0, 400.0, 801)

CASES = [pair_of_masses(ALPHA, ETA_M, d, ETA_B) for d in DISTANCES]


def check() -> None:
    """The finite beam, early and late; 'excellent agreement'; what cannot replace two masses."""
    found = checked_comparison(CASES[1], TAU)  # d = 1
    check_late_beam(found)
    assert min(q.imag for case in CASES for q in vibration(case, [0]).q) > 0
    assert max(missed(case) for case in CASES) < 0.01
    assert min(np.abs(found.full - other).max() for other in (found.added, found.doubled)) > 1
    assert found.doubled.max() > 1.2 * found.full.max()  # "noticeably higher"


def visualize(path: Path | str = "figure_a3.svg", tau: Any = TAU) -> Path:
    """Writes the picture and returns its path."""
    return comparison_figure(path, CASES, tau)


if __name__ == "__main__":
    run(check, visualize, "figure_a3")
