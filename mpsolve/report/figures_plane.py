"""The complex q-plane of a spectrum: cuts, branch points, contour, certified roots; in the units of its problem.

Ids in the pictures: root-K (the K-th of spectrum.roots, from 1), branch-point-left and -right, cut-left and -right.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from mpsolve.numbers.decimals import proved_digits
from mpsolve.problem.cases import Given, as_problem
from mpsolve.problem.line import on_line
from mpsolve.problem.reduced import reduce_problem
from mpsolve.report.figures import COLOUR, Look
from mpsolve.report.spectrum_words import SI, units_of
from mpsolve.report.vibration import Trend, Vibration
from mpsolve.spectrum.branch_loops import edge_points
from mpsolve.spectrum.spectrum import Spectrum

if TYPE_CHECKING:
    from matplotlib.axes import Axes

_PARTS = {"x": "Re", "y": "Im"}
_GAP = 0.018  # of the height: how far the contour is drawn from the cut on which it runs
_GUARD = 0.12  # of the extent, around what is shown
_CLOSE = 0.25  # of the half width: below it the labels of both branch points would meet


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


def q_plane(spectrum: Spectrum, ax: Axes, look: Look = COLOUR) -> Axes:
    """The roots with the cuts, their branch points, the contour along them and the unstable half-plane; `ax`."""
    height, start = cut_line(spectrum.problem) or (0.0, None)
    places = [centre(root) for root in spectrum.roots]
    reach = 1.5 * (max([abs(x) for x, _ in places] + [start or 0.0, 2 * height]) or 1.0)
    low, high = (f([y for _, y in places] + [0.0, height if start is not None else 0.0]) for f in (min, max))
    extent = (high - low) or 0.1
    limits = low - 2 * _GUARD * extent, high + 2 * _GUARD * extent
    ax.set(xlim=(-reach, reach), ylim=limits, **_labels(spectrum))
    _halves(ax, look)
    if start is not None:
        _cuts(ax, start, height, look, units_of(spectrum) is not SI)
        _contour_at_cuts(ax, start, height, look)
    draw_roots(spectrum, ax, look, 7)
    return ax


def _labels(spectrum: Spectrum) -> dict[str, str]:
    unit = units_of(spectrum)
    return {f"{axis}label": f"{part} q [{unit.q}]" if unit is SI else f"{part} q" for axis, part in _PARTS.items()}


def draw_roots(spectrum: Spectrum, ax: Axes, look: Look = COLOUR, size: float = 7) -> Axes:
    """A mark at the midpoint of each certified ball; a diamond where Im q < 0 is proved."""
    for k, root in enumerate(spectrum.roots, 1):
        x, y = centre(root)
        ax.plot(x, y, **look.root(root.q.imag < 0), markersize=size, markeredgewidth=0.8, zorder=5, gid=f"root-{k}")
    return ax


def roots_zoom(motions: tuple[Vibration, ...], seconds: bool, ax: Axes, look: Look = COLOUR) -> Axes:
    """The roots with Re q ≥ 0 enlarged, each with its frequency and the time in which it doubles or halves; `ax`.

    motions: of `vibrations`; seconds: whether in Hz and s, or else in units of τ. Ids: zoom-K.
    """
    places = [centre(motion.root) for motion in motions]
    (left, right), (low, high) = _window([x for x, _ in places]), _window([y for _, y in places] + [0.0])
    ax.set(xlim=(left, right), ylim=(low, high + 0.25 * (high - low)), xlabel="Re q", ylabel="Im q")
    _halves(ax, look, said=False)
    for k, (motion, (x, y)) in enumerate(zip(motions, places, strict=True), 1):
        ax.plot(x, y, **look.root(motion.trend is Trend.GROWS), markersize=9, zorder=5, gid=f"zoom-{k}")
        ax.annotate(
            _told(motion, seconds), (x, y), xytext=(0, 9), textcoords="offset points", ha="center", fontsize=9
        )
    return ax


def _halves(ax: Axes, look: Look, said: bool = True) -> None:
    """The real axis and the half-plane below it, in which e^{iqτ} grows."""
    (left, _), (low, high) = ax.get_xlim(), ax.get_ylim()
    if low < 0:
        ax.axhspan(low, 0, color=look.shade, linewidth=0, zorder=0)
    ax.axhline(0, color=look.ink, linewidth=0.8)
    if said:
        ax.text(left * 0.97, low + 0.02 * (high - low), "Im q < 0: grows, unstable", va="bottom", fontsize=9)


def _cuts(ax: Axes, start: float, height: float, look: Look, in_ratios: bool) -> None:
    """The rays Im q = η_b, |Re q| ≥ q_lm, from their branch points outward."""
    reach = ax.get_xlim()[1]
    for side, name in ((-1, "left"), (1, "right")):
        ax.plot([side * start, side * reach], [height, height], color=look.cut, linewidth=2.4, gid=f"cut-{name}")
        if not start:
            continue
        end: dict[str, Any] = {"markerfacecolor": "white", "markeredgewidth": 1.5, "markersize": 6, "zorder": 4}
        ax.plot(side * start, height, "o", color=look.cut, **end, gid=f"branch-point-{name}")
    if start:
        both = [(-start, "−"), (start, "")] if start > _CLOSE * reach else [(0.0, "±")]
        for x, sign in both:
            said = f"{sign}$q_{{lm}}$ + i$η_b$" if in_ratios else "branch point"
            ax.annotate(said, (x, height), (0, 9), textcoords="offset points", ha="center", fontsize=9)
    place = (reach + start) / 2
    ax.annotate("branch cut", (place, height), (0, -14), textcoords="offset points", ha="center", fontsize=9)


def _contour_at_cuts(ax: Axes, start: float, height: float, look: Look) -> None:
    """The contour of the count along both edges of each cut, drawn a little apart from it, and round its end."""
    (_, reach), (low, high) = ax.get_xlim(), ax.get_ylim()
    apart = _GAP * (high - low)
    round_end = _GAP * reach
    style: dict[str, Any] = {"color": look.faint, "linewidth": 0.9, "linestyle": (0, (3, 2))}
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
