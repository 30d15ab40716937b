"""Figure 9: induced frequencies over the velocity ratio, with damping η_b = 0.05.

a) η_M = 70, d = 0.5, 1, 1.5; b) η_M = 10, d = 1.5, 3, 4.5; real and imaginary part. Black dotted: q_lm, and the level
Im q = η_b of the branch cut, at which lines end; dashed: one mass; dash-dot: one doubled mass; light grey to black:
two masses by growing distance; thin: lines above the cut. Below Im q = 0 the vibration grows: from α = 0.962 for
η_M = 70, d = 1, and from α = 0.667 for d = 1.5, far below the critical velocity.
"""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
from induced import ALPHA, check_lines, draw_lines, drawn, groups, limiting, lines
from style import page, run
from vibration import pair_of_masses

from mpsolve import cut_points

ETA_B = "0.05"
GROUPS = ((70, ("0.5", "1", "1.5")), (10, ("1.5", "3", "4.5")))


def check() -> None:
    """Onsets of Section 4.3, certified frequencies on both sides; a line ends at Im q = η_b, another passes q_lm."""
    alpha = np.arange(50, 100) / 100
    found = {d: lines(70, d, ETA_B, alpha) for d in GROUPS[0][1]}
    unstable = {d: [a for a in alpha if np.any(drawn(found[d], a).imag < 0)] for d in found}
    # as printed for d = 1 and 1.5; at d = 0.5 the onset is not below α = 1
    assert [unstable["1"][0], unstable["1.5"][0], unstable["0.5"]] == [0.97, 0.67, []]
    for place in ("0.66", "0.67", "0.99"):
        check_lines(found["1.5"], pair_of_masses(place, 70, "1.5", ETA_B))
    (end,) = cut_points(pair_of_masses("0.95", 70, "1.5", ETA_B), over={"v": ("0.9", "0.99")}).points
    ended = min(found["1.5"], key=lambda line: line.alpha[-1])
    assert ended.alpha[-1] < end.value < ended.alpha[-1] + 0.01
    assert ended.q[-1].imag < float(ETA_B)  # where it is cut (conclusion (iv))
    past = [drawn(found["1"], a)[-1].real - limiting(ETA_B, np.array([a]))[0] for a in (0.5, 0.97)]
    assert past[0] < 0 < past[1]  # Section 4.3: the real part can cross q_lm
    # η_M = 10 and one mass are stable below α = 1
    others = [lines(10, d, ETA_B, alpha) for d in GROUPS[1][1]] + [lines(70, None, ETA_B, alpha)]
    assert min(q.imag for pair in others for line in pair for q in line.q) > 0


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
    run(check, visualize, "figure_09")
