"""Figure 6: the unsteady harmonic part of the vibrations of the rear contact point, without damping, α = 0.9.

η_M = 40, d = 2, 2.5, …, 4.5; black dotted: envelopes. For d = 2, 2.5, 3 the higher pair has
met the branch cut, and the amplitude is constant.
"""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
from induced import LAST, end_of_line
from style import agree, run
from vibration import TAU, checked_vibration, harmonic_figure, pair_of_masses, residue

from mpsolve import certify

ETA_M = 40
ALPHA = "0.9"
DISTANCES = ("2", "2.5", "3", "3.5", "4", "4.5")

CASES = [[pair_of_masses(ALPHA, ETA_M, d) for d in row] for row in (DISTANCES[:3], DISTANCES[3:])]


def check() -> None:
    """One pair and a constant amplitude in the first three graphs (Section 4.2), then two; where the line ends."""
    found = [checked_vibration(case) for row in CASES for case in row]
    assert [len(panel.q) for panel in found] == [1, 1, 1, 2, 2, 2]
    swing = [np.ptp(panel.envelope.modulus) for panel in found]
    assert max(swing[:3]) < 1e-12 < 0.1 < min(swing[3:])
    for d in DISTANCES:
        assert LAST[ETA_M][d] < end_of_line(ETA_M, d) < LAST[ETA_M][d] + 0.01
    # the higher pair of d = 3.5, close to its end, with more digits
    close = max((root.q for root in certify(CASES[1][0], digits=25).roots), key=lambda q: float(q.real.mid()))
    agree(found[3].q[1], complex(close), 1e-14)
    agree(found[3].envelope.amplitudes[1], abs(residue(CASES[1][0], complex(close))), 1e-7)


def visualize(path: Path | str = "figure_06.svg", tau: Any = TAU) -> Path:
    """Writes the picture and returns its path."""
    return harmonic_figure(path, CASES, tau)


if __name__ == "__main__":
    run(check, visualize, "figure_06")
