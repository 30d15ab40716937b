"""Figure 2: induced frequencies over the velocity ratio, without damping.

a) η_M = 70, d = 0.5, 1, 1.5, real and imaginary part; b) the same for η_M = 40; c), d) η_M = 40, d = 2, 2.5, …, 4.5
(the caption says the same of both: here d) enlarges the ends of the lines of c)); e) η_M = 10, d = 0.5, 1, 1.5.
c) to e) show velocities below the critical one only. Black dotted: q_lm; dashed: one mass; dash-dot: one doubled
mass; light grey to black: two masses by growing distance. The line of the higher pair ends at q_lm: the last
velocities of the grid 0.01 with both pairs are 0.74, 0.86, 0.87 in b), 0.37, 0.66, 0.72 in e) (Section 4.2).
"""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
from induced import ALPHA, LAST, check_lines, draw_lines, drawn, groups, lines, on_sheet
from style import agree, page, run
from vibration import pair_of_masses

CLOSE = ("0.5", "1", "1.5")
FAR = ("2", "2.5", "3", "3.5", "4", "4.5")
SUBCRITICAL = 0.99
DETAIL = {"xlim": (0.8, 0.96), "xticks": (0.8, 0.85, 0.9, 0.95), "ylim": (0.08, 0.2), "title": "d) detail of c)"}


def check() -> None:
    """Where both pairs end, on q_lm; the order of the lines; certified frequencies; complex ones from α = 1 on."""
    ends = [(eta_m, d, last) for eta_m in LAST for d, last in LAST[eta_m].items()]
    masses, places, last = np.array([[float(x) for x in end] for end in ends]).T
    assert np.all(on_sheet(np.array([last, last + 0.01]), 0, masses, places).count.T == [4, 2])
    p = np.linspace(0, 3, 300_001)
    for eta_m, d in ((40, "0.5"), (40, "1.5"), (10, "1")):
        higher = max(lines(eta_m, d, alpha=np.arange(60, 92) / 100), key=lambda line: line.q[0].real)
        assert LAST[eta_m][d] < higher.alpha[-1] < LAST[eta_m][d] + 0.01
        # q_lm as the minimum of (18) over real wavenumbers
        agree(higher.q[-1], np.min(np.sqrt(p**4 + 4) / 2 - higher.alpha[-1] * p), 1e-9)
    low = np.arange(10, 13) / 100
    for eta_m in (10, 70):
        single, doubled = (drawn(lines(m, None, alpha=low), 0.11)[0].real for m in (eta_m, 2 * eta_m))
        lower, higher = np.transpose([drawn(lines(eta_m, d, alpha=low), 0.11).real for d in CLOSE])
        # the closer the masses, the nearer to the doubled one (Section 4.2)
        assert doubled < lower[0] < lower[1] < lower[2] < single < min(higher)
    through = lines(70, "1.5", alpha=np.arange(85, 141) / 100)
    for alpha in ("0.9", "1.4"):
        check_lines(through, pair_of_masses(alpha, 70, "1.5"))
    assert np.all(drawn(through, 0.99).imag == 0)
    assert np.any(drawn(through, 1.01).imag > 0)  # and so −q̄, q̄ and −q, below zero: from α = 1 it is unstable


def visualize(path: Path | str = "figure_02.svg", alpha: Any = ALPHA) -> Path:
    """Writes the picture and returns its path; `alpha`: the velocity ratios, ascending."""
    below = alpha[alpha <= SUBCRITICAL]
    with page(path, 4, 2, (3.4, 2.3)) as axes:
        for letter, row, eta_m, top in (("a", axes[0], 70, 0.45), ("b", axes[1], 40, 0.55)):
            found = groups(eta_m, CLOSE, alpha=alpha)
            for ax, part in zip(row, ("real", "imag"), strict=True):
                draw_lines(ax, part, found, alpha=alpha).set_title(f"{letter}) $η_M = {eta_m}$")
            row[0].set_ylim(0, top)
            row[1].set_ylim(bottom=0)
        far = groups(40, FAR, alpha=below)
        draw_lines(axes[2, 0], "real", far, alpha=below).set(title="c) $η_M = 40$", ylim=(0, 0.35))
        draw_lines(axes[2, 1], "real", far, alpha=below).set(**DETAIL)
        light = groups(10, CLOSE, alpha=below)
        draw_lines(axes[3, 0], "real", light, alpha=below).set(title="e) $η_M = 10$", ylim=(0, 1))
        for ax in axes[:2, 1]:
            ax.legend(*axes[0, 0].get_legend_handles_labels(), loc="upper left")
        axes[3, 1].legend(*axes[2, 0].get_legend_handles_labels(), title="c), d)", ncols=2, loc="center")
        axes[3, 1].set_axis_off()
    return Path(path)


if __name__ == "__main__":
    run(check, visualize, "figure_02")
