"""The q-plane of the rail example: its cuts, its unstable half, and its certified induced frequencies.

Run as a program, it writes rail_60e1.svg beside itself. `draw` puts the same picture on any matplotlib axes.
"""

from __future__ import annotations

from pathlib import Path
from typing import Any

from mpsolve import PhysicalCase, Spectrum, certify
from mpsolve.problem.casefile import read_input
from mpsolve.report.figures import save_figure
from mpsolve.report.figures_plane import cut_line, q_plane, roots_zoom
from mpsolve.report.vibration import Vibration, vibrations

HERE = Path(__file__).parent
INPUT = HERE / "rail_60e1.toml"
PICTURE = HERE / "rail_60e1.svg"
INSET_PLACE = (0.41, 0.40, 0.33, 0.52)  # in units of the axes

SOURCE = read_input(INPUT)
assert isinstance(SOURCE.case, PhysicalCase)
PHYSICAL: PhysicalCase = SOURCE.case
SPECTRUM: Spectrum = certify(PHYSICAL)
VIBRATIONS: tuple[Vibration, ...] = vibrations(SPECTRUM)
CUTS = cut_line(PHYSICAL)


def draw(ax: Any) -> Any:
    """The q-plane on `ax`, with an inset around the roots of Re q > 0; returns `ax`."""
    q_plane(SPECTRUM, ax)
    ax.annotate(
        f"{SPECTRUM.count} induced frequencies,\nproved to be all there are",
        (-20.7, 0.32),
        xytext=(-93, 2.9),
        ha="center",
        arrowprops={"arrowstyle": "-", "color": "gray", "linewidth": 0.8},
    )
    inset = roots_zoom(VIBRATIONS, True, ax.inset_axes(INSET_PLACE))
    inset.set(xlabel="", ylabel="", xlim=(15.5, 25.8))
    inset.tick_params(labelsize=8)
    ax.indicate_inset_zoom(inset, edgecolor="gray")
    verdict = "stable" if SPECTRUM.stable else "unstable"
    ax.set_title(f"{SOURCE.title}: {verdict}", loc="left", fontsize=11)
    return ax


def visualize(path: Path = PICTURE) -> Path:
    """Writes the picture as SVG, the same bytes each time, and returns its path."""
    return save_figure(draw, path, (8.4, 4.6))


if __name__ == "__main__":
    print(visualize())
