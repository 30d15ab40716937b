"""Figure 9: induced frequencies over the velocity ratio, with damping η_b = 0.05.

a) η_M = 70, d = 0.5, 1, 1.5; b) η_M = 10, d = 1.5, 3, 4.5; real and imaginary part. Black dotted: q_lm, and the level
Im q = η_b of the branch cut, at which lines end; dashed: one mass; dash-dot: one doubled mass; light grey to black:
two masses by growing distance; thin: lines above the cut. Below Im q = 0 the vibration grows: from α = 0.962 for
η_M = 70, d = 1, and from α = 0.667 for d = 1.5, far below the critical velocity.
"""

from __future__ import annotations

from pathlib import Path
from typing import Any

from induced import ALPHA, draw_lines, groups
from style import page, run

ETA_B = "0.05"
GROUPS = ((70, ("0.5", "1", "1.5")), (10, ("1.5", "3", "4.5")))


def visualize(path: Path | str = "figure_09.svg", alpha: Any = ALPHA) -> Path:
    """Writes the picture and returns its path; `alpha`: the velocity ratios."""
    with page(path, 2, 2, (3.4, 2.5)) as axes:
        for letter, row, (eta_m, distances) in zip("ab", axes, GROUPS, strict=True):
            found = groups(eta_m, distances, ETA_B, alpha)
            for ax, part in zip(row, ("real", "imag"), strict=True):
                draw_lines(ax, part, found, ETA_B, alpha).set_title(f"{letter}) $η_M = {eta_m}$")
            row[0].set_ylim(0, 1)
            row[1].axhline(0, color="black", linewidth=0.5)
            row[1].legend(loc="upper left")
    return Path(path)


if __name__ == "__main__":
    run(visualize, "figure_09")
