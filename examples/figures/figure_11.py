"""Figure 11: the unsteady harmonic part of the vibrations of the rear contact point with damping.

η_M = 70, η_b = 0.05, d = 0.5, 1, 1.5 (rows), a) α = 0.5, b) α = 0.8, c) α = 0.9 (columns); black dotted: envelopes.
At d = 1.5 the onset of instability is at α = 0.6669: in b) and c) that vibration grows.
"""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
from style import agree, run
from vibration import DIGITS, TAU, checked_vibration, harmonic_figure, pair_of_masses, vibration

from mpsolve import certify

ETA_M = 70
ETA_B = "0.05"
DISTANCES = ("0.5", "1", "1.5")
ALPHAS = ("0.5", "0.8", "0.9")

CASES = [[pair_of_masses(alpha, ETA_M, d, ETA_B) for alpha in ALPHAS] for d in DISTANCES]


def check() -> None:
    """Only d = 1.5 in b) and c) grows (Section 4.3), as fast as certified; its onset; heavier masses decay slower."""
    found = [[checked_vibration(case) for case in row] for row in CASES]
    grows = [[min(q.imag for q in panel.q) < 0 for panel in row] for row in found]
    assert grows == [[False] * 3, [False] * 3, [False, True, True]]
    for case, panel in zip(CASES[2][1:], found[2][1:], strict=True):
        q = min(panel.q, key=lambda q: q.imag)
        swing = 2 * np.pi / q.real
        late = vibration(case, 800 + swing * np.arange(1600) / 200)  # eight swings after the other pair has died out
        crests = np.abs(late.w).reshape(8, 200).max(axis=1)
        agree(np.log(crests[-1] / crests[0]) / (7 * swing), -q.imag, 1e-5)
    onset = [
        certify(pair_of_masses(alpha, ETA_M, "1.5", ETA_B), digits=DIGITS).unstable for alpha in ("0.6669", "0.667")
    ]
    assert onset == [0, 2]
    for d, (heavy, *_) in zip(DISTANCES, found, strict=True):  # after Figure 11, at α = 0.5
        light = vibration(pair_of_masses("0.5", 10, d, ETA_B), [0])
        assert min(q.imag for q in heavy.q) < min(q.imag for q in light.q)


def visualize(path: Path | str = "figure_11.svg", tau: Any = TAU) -> Path:
    """Writes the picture and returns its path."""
    return harmonic_figure(path, CASES, tau)


if __name__ == "__main__":
    run(check, visualize, "figure_11")
