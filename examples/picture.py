"""The q-plane of the rail example: its cuts, its unstable half, and its certified induced frequencies.

Run as a program, it writes rail_60e1.svg beside itself. `draw` puts the same picture on any matplotlib axes.
"""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np

from mpsolve import PhysicalCase, Spectrum, certify
from mpsolve.numbers.decimals import proved_digits
from mpsolve.problem.casefile import read_input
from mpsolve.problem.cases import Given, as_problem
from mpsolve.problem.line import on_line
from mpsolve.problem.reduced import reduce_problem
from mpsolve.report.figures import COLOUR, save_figure
from mpsolve.report.spectrum_words import SI, units_of
from mpsolve.report.vibration import Trend, Vibration, vibrations
from mpsolve.spectrum.branch_loops import edge_points

HERE = Path(__file__).parent
INPUT = HERE / "rail_60e1.toml"
PICTURE = HERE / "rail_60e1.svg"
_PARTS = {"x": "Re", "y": "Im"}
_GAP = 0.018  # of the height: how far the contour is drawn from the cut on which it runs
_GUARD = 0.12  # of the extent, around what is shown
_CLOSE = 0.25  # of the half width: below it the labels of both branch points would meet
INSET_PLACE = (0.41, 0.40, 0.33, 0.52)  # in units of the axes


def centre(root: Any) -> tuple[float, float]:
    """The midpoint of the ball, in float64."""
    return float(root.q.real.mid()), float(root.q.imag.mid())


def cut_line(given: Given) -> tuple[float, float] | None:
    """(height of the cuts, Re q where they begin, 0 if joined) of a beam, in float64; None for other cuts."""
    line = on_line(reduce_problem(as_problem(given)))
    if line is None:
        return None
    unit = float(line.lower.frequency_unit)
    begin = edge_points(line)[0].z if line.joined is False else 0.0
    return float(line.height) * unit, begin * unit


def q_plane(spectrum: Spectrum, ax: Any) -> Any:
    """The roots with the cuts, their branch points, the contour along them and the unstable half-plane; `ax`."""
    height, start = cut_line(spectrum.problem) or (0.0, None)
    places = [centre(root) for root in spectrum.roots]
    reach = 1.5 * (max([abs(x) for x, _ in places] + [start or 0.0, 2 * height]) or 1.0)
    low, high = (f([y for _, y in places] + [0.0, height if start is not None else 0.0]) for f in (min, max))
    extent = (high - low) or 0.1
    limits = low - 2 * _GUARD * extent, high + 2 * _GUARD * extent
    ax.set(xlim=(-reach, reach), ylim=limits, **_labels(spectrum))
    _halves(ax)
    if start is not None:
        _cuts(ax, start, height, units_of(spectrum) is not SI)
        _contour_at_cuts(ax, start, height)
    draw_roots(spectrum, ax, 7)
    return ax


def _labels(spectrum: Spectrum) -> dict[str, str]:
    unit = units_of(spectrum)
    return {f"{axis}label": f"{part} q [{unit.q}]" if unit is SI else f"{part} q" for axis, part in _PARTS.items()}


def draw_roots(spectrum: Spectrum, ax: Any, size: float = 7) -> Any:
    """A mark at the midpoint of each certified ball; a diamond where Im q < 0 is proved."""
    for k, root in enumerate(spectrum.roots, 1):
        x, y = centre(root)
        ax.plot(x, y, **COLOUR.root(root.q.imag < 0), markersize=size, markeredgewidth=0.8, zorder=5, gid=f"root-{k}")
    return ax


def roots_zoom(motions: tuple[Vibration, ...], seconds: bool, ax: Any) -> Any:
    """The roots with Re q ≥ 0 enlarged, each with its frequency and the time in which it doubles or halves; `ax`.

    motions: of `vibrations`; seconds: whether in Hz and s, or else in units of τ. Ids: zoom-K.
    """
    places = [centre(motion.root) for motion in motions]
    (left, right), (low, high) = _window([x for x, _ in places]), _window([y for _, y in places] + [0.0])
    ax.set(xlim=(left, right), ylim=(low, high + 0.25 * (high - low)), xlabel="Re q", ylabel="Im q")
    _halves(ax, said=False)
    for k, (motion, (x, y)) in enumerate(zip(motions, places, strict=True), 1):
        ax.plot(x, y, **COLOUR.root(motion.trend is Trend.GROWS), markersize=9, zorder=5, gid=f"zoom-{k}")
        ax.annotate(
            _told(motion, seconds), (x, y), xytext=(0, 9), textcoords="offset points", ha="center", fontsize=9
        )
    return ax


def _halves(ax: Any, said: bool = True) -> None:
    """The real axis and the half-plane below it, in which e^{iqτ} grows."""
    (left, _), (low, high) = ax.get_xlim(), ax.get_ylim()
    if low < 0:
        ax.axhspan(low, 0, color=COLOUR.shade, linewidth=0, zorder=0)
    ax.axhline(0, color=COLOUR.ink, linewidth=0.8)
    if said:
        ax.text(left * 0.97, low + 0.02 * (high - low), "Im q < 0: grows, unstable", va="bottom", fontsize=9)


def _cuts(ax: Any, start: float, height: float, in_ratios: bool) -> None:
    """The rays Im q = η_b, |Re q| ≥ q_lm, from their branch points outward."""
    reach = ax.get_xlim()[1]
    for side, name in ((-1, "left"), (1, "right")):
        ax.plot([side * start, side * reach], [height, height], color=COLOUR.cut, linewidth=2.4, gid=f"cut-{name}")
        if not start:
            continue
        end: dict[str, Any] = {"markerfacecolor": "white", "markeredgewidth": 1.5, "markersize": 6, "zorder": 4}
        ax.plot(side * start, height, "o", color=COLOUR.cut, **end, gid=f"branch-point-{name}")
    if start:
        both = [(-start, "−"), (start, "")] if start > _CLOSE * reach else [(0.0, "±")]
        for x, sign in both:
            said = f"{sign}$q_{{lm}}$ + i$η_b$" if in_ratios else "branch point"
            ax.annotate(said, (x, height), (0, 9), textcoords="offset points", ha="center", fontsize=9)
    place = (reach + start) / 2
    ax.annotate("branch cut", (place, height), (0, -14), textcoords="offset points", ha="center", fontsize=9)


def _contour_at_cuts(ax: Any, start: float, height: float) -> None:
    """The contour of the count along both edges of each cut, drawn a little apart from it, and round its end."""
    (_, reach), (low, high) = ax.get_xlim(), ax.get_ylim()
    apart = _GAP * (high - low)
    round_end = _GAP * reach
    style: dict[str, Any] = {"color": COLOUR.faint, "linewidth": 0.9, "linestyle": (0, (3, 2))}
    for side in (-1, 1):
        if start:
            turn = np.linspace(np.pi / 2, 3 * np.pi / 2, 31)
            x = np.concatenate([[reach], start + round_end * np.cos(turn) * 1.6, [reach]])
            y = np.concatenate([[height + apart], height + apart * np.sin(turn), [height - apart]])
            ax.plot(side * x, y, **style)
        else:
            for edge in (-1, 1):
                ax.plot([0, side * reach], [height + edge * apart] * 2, **style)


def _window(values: list[float]) -> tuple[float, float]:
    """The range of the values, and some room on both sides."""
    low, high = min(values), max(values)
    room = 0.35 * (high - low) or 0.25 * abs(high) or 0.1
    return low - room, high + room


def _told(motion: Vibration, seconds: bool) -> str:
    hertz, unit = (" Hz", " s") if seconds else ("/τ", " τ")
    said = f"{float(motion.frequency):.4g}{hertz}"
    if motion.time is None:
        return f"{said}\n{motion.trend.value}"
    verb = "doubles" if motion.trend is Trend.GROWS else "halves"
    return f"{said}\n{verb} in {proved_digits(motion.time, 3)}{unit}"


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
