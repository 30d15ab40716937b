"""The q-plane of the rail example: its cuts, its unstable half, and its certified induced frequencies.

Run as a program, it writes rail_60e1.svg beside itself. `draw` puts the same picture on any matplotlib axes.
"""

from __future__ import annotations

from pathlib import Path
from typing import Any

from mpsolve import Case, PhysicalCase, Spectrum, certify
from mpsolve.fields import Float64
from mpsolve.model.inputfile import read_input
from mpsolve.model.limits import limiting_frequency
from mpsolve.report.vibration import Trend, Vibration, vibrations

HERE = Path(__file__).parent
INPUT = HERE / "rail_60e1.toml"
PICTURE = HERE / "rail_60e1.svg"

# Okabe and Ito's palette, which the colour-blind tell apart
STABLE, UNSTABLE, CUT, SHADE = "#0072B2", "#D55E00", "#444444", "#D55E00"
RE_LIMIT, IM_MIN, IM_MAX = 1.15, -0.014, 0.068
INSET = (0.12, 0.20, -0.0005, 0.0019)
INSET_PLACE = (0.41, 0.40, 0.33, 0.52)  # in units of the axes

SOURCE = read_input(INPUT)
assert isinstance(SOURCE.case, PhysicalCase)
PHYSICAL: PhysicalCase = SOURCE.case
CASE: Case = PHYSICAL.dimensionless
SPECTRUM: Spectrum = certify(CASE)
VIBRATIONS: tuple[Vibration, ...] = vibrations(SPECTRUM, PHYSICAL)
Q_LM = float(limiting_frequency(CASE, Float64()))


def draw(ax: Any) -> Any:
    """The q-plane on `ax`, with an inset around the roots of Re q > 0; returns `ax`."""
    _plane(ax)
    _cuts(ax)
    _roots(ax, 7)
    ax.annotate(
        f"{SPECTRUM.count} induced frequencies,\nproved to be all there are",
        (-0.16, 0.0025),
        xytext=(-0.62, 0.0225),
        ha="center",
        arrowprops={"arrowstyle": "-", "color": "gray", "linewidth": 0.8},
    )
    _inset(ax)
    ax.set(xlim=(-RE_LIMIT, RE_LIMIT), ylim=(IM_MIN, IM_MAX), xlabel="Re q", ylabel="Im q")
    verdict = "stable" if SPECTRUM.stable else "unstable"
    ax.set_title(f"{SOURCE.title}: {verdict}", loc="left", fontsize=11)
    return ax


def visualize(path: Path = PICTURE) -> Path:
    """Writes the picture as SVG, the same bytes each time, and returns its path."""
    import matplotlib as mpl
    from matplotlib.figure import Figure

    style: Any = {"svg.hashsalt": "mpsolve", "svg.fonttype": "path", "font.size": 10, "axes.linewidth": 0.8}
    with mpl.rc_context(style):
        figure = Figure(figsize=(8.4, 4.6), layout="constrained")
        draw(figure.add_subplot())
        figure.savefig(path, metadata={"Date": None, "Creator": None}, facecolor="white")
    return path


def _plane(ax: Any) -> None:
    """The real axis and the half-plane below it, in which e^{iqτ} grows."""
    ax.axhspan(IM_MIN, 0, color=SHADE, alpha=0.10, linewidth=0)
    ax.axhline(0, color="black", linewidth=0.8)
    ax.spines[["top", "right"]].set_visible(False)
    ax.text(-RE_LIMIT * 0.97, IM_MIN / 2, "Im q < 0: growing, unstable", color="#A04000", va="center")
    ax.text(-RE_LIMIT * 0.97, -IM_MIN / 2, "Im q > 0: decaying, stable", color=STABLE, va="center")


def _cuts(ax: Any) -> None:
    """The rays Im q = η_b, |Re q| ≥ q_lm, from their branch points outward."""
    height = float(CASE.eta_b)
    for side in (-1, 1):
        ax.plot([side * Q_LM, side * 2 * RE_LIMIT], [height, height], color=CUT, linewidth=2.5)
        ax.plot(side * Q_LM, height, "o", color=CUT, markersize=6, markerfacecolor="white", markeredgewidth=1.5)
        ax.annotate(
            f"{'−' if side < 0 else ''}$q_{{lm}}$ + i$η_b$",
            (side * Q_LM, height),
            xytext=(0, 9),
            textcoords="offset points",
            ha="center",
        )
        ax.text(side * (Q_LM + RE_LIMIT) / 2, height - 0.002, "branch cut", ha="center", va="top", color=CUT)


def _roots(ax: Any, size: float) -> None:
    """Every certified root; an unstable one is a diamond."""
    for root in SPECTRUM.roots:
        grows = root.q.imag < 0
        ax.plot(
            float(root.q.real.mid()),
            float(root.q.imag.mid()),
            "D" if grows else "o",
            color=UNSTABLE if grows else STABLE,
            markersize=size,
            markeredgecolor="white",
            markeredgewidth=0.8,
            zorder=5,
        )


def _inset(ax: Any) -> None:
    """The roots with Re q > 0, enlarged, each with its frequency and its time."""
    inset = ax.inset_axes(INSET_PLACE)
    inset.set(xlim=INSET[:2], ylim=INSET[2:])
    inset.axhspan(INSET[2], 0, color=SHADE, alpha=0.10, linewidth=0)
    inset.axhline(0, color="black", linewidth=0.8)
    _roots(inset, 9)
    for motion in VIBRATIONS:
        verb = "doubles" if motion.trend is Trend.GROWS else "halves"
        inset.annotate(
            f"{float(motion.frequency):.2f} Hz\n{verb} in {float(motion.time):.1f} s",
            (float(motion.root.q.real.mid()), float(motion.root.q.imag.mid())),
            xytext=(0, 9),
            textcoords="offset points",
            ha="center",
            fontsize=9,
        )
    inset.set(xticks=(0.14, 0.16, 0.18), yticks=(0, 0.001))
    inset.tick_params(labelsize=8)
    inset.patch.set_facecolor("white")
    ax.indicate_inset_zoom(inset, edgecolor="gray")


if __name__ == "__main__":
    print(visualize())
