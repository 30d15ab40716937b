"""Frequency lines over the velocity ratio, real and imaginary parts apart, as is usual in the field.

Ids in the pictures: line-K, the K-th of the lines from 1, and here-K, the K-th root of the case that is marked.
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import replace
from typing import TYPE_CHECKING, Any

import numpy as np

from mpsolve.certificate.on_sheet import AnySpectrum, sheet_of
from mpsolve.certificate.sheet import SheetSpectrum
from mpsolve.fields import Float64
from mpsolve.model.limits import limiting_frequency
from mpsolve.numbers.exact import Exact
from mpsolve.problem.case import Case
from mpsolve.problem.physical import PhysicalCase
from mpsolve.report.figures import COLOUR, Look, scaling, velocity_axis
from mpsolve.stability.lines import FrequencyLines

if TYPE_CHECKING:
    from matplotlib.axes import Axes

_SAMPLES = 200


def line_frequencies(
    lines: FrequencyLines, ax: Axes, spectrum: AnySpectrum | None = None, physical: PhysicalCase | None = None,
    look: Look = COLOUR,
) -> Axes:  # fmt: skip
    """Re q of each line over α, with q_lm dotted; `spectrum`: the case that is marked; `ax`.

    physical: for scales in km/h and Hz.
    """
    _lines(lines, ax, look, lambda q: float(q.real.mid()))
    if spectrum is not None:
        spectrum = sheet_of(spectrum)
        _limit(spectrum.case, lines, ax, look)
        _here(spectrum, ax, look, lambda q: float(q.real.mid()))
    ax.set(ylabel="Re q", ylim=(0, None))
    if physical is not None:
        unit = float(physical.time_scale) / (2 * np.pi)
        side: Any = ax.secondary_yaxis("right", functions=scaling(unit))
        side.set_ylabel("frequency [Hz]")
    return _across(lines, ax, physical)


def line_growth(
    lines: FrequencyLines, ax: Axes, spectrum: AnySpectrum | None = None, physical: PhysicalCase | None = None,
    look: Look = COLOUR,
) -> Axes:  # fmt: skip
    """Im q of each line over α, with the level η_b of the cuts dotted and the unstable half shaded; `ax`."""
    _lines(lines, ax, look, lambda q: float(q.imag.mid()))
    ax.axhline(0, color=look.ink, linewidth=0.8)
    if spectrum is not None:
        spectrum = sheet_of(spectrum)
        if spectrum.case.cuts_on_line:
            ax.axhline(
                float(spectrum.case.eta_b), color=look.ink, linestyle=":", linewidth=1, label="$η_b$, the cuts"
            )
        _here(spectrum, ax, look, lambda q: float(q.imag.mid()))
    low, high = ax.get_ylim()
    if low < 0:
        ax.axhspan(low, 0, color=look.shade, linewidth=0, zorder=0, label="Im q < 0: unstable")
        ax.set_ylim(low, high)
    ax.set_ylabel("Im q")
    return _across(lines, ax, physical)


def _lines(lines: FrequencyLines, ax: Axes, look: Look, part: Any) -> None:
    """Every line with a mark at each proved root; a ring where it is proved to end at a cut."""
    for k, line in enumerate(lines):
        x, y = [float(alpha) for alpha in line.alpha], [part(q) for q in line.q]
        ax.plot(x, y, **look.line(k), marker=".", markersize=3.5, gid=f"line-{k + 1}")
        for end, at in zip(line.ends, (0, -1), strict=True):
            if end.kind == "cut":
                ax.plot(x[at], y[at], "o", color=look.cut, markerfacecolor="white", markersize=5, zorder=4)


def _limit(case: Case, lines: FrequencyLines, ax: Axes, look: Look) -> None:
    """q_lm, where it is positive, in float64."""
    if not case.cuts_on_line:
        return
    grid = np.linspace(float(lines.alpha[0]), float(lines.alpha[-1]), _SAMPLES).tolist()
    q = [float(limiting_frequency(replace(case, alpha=Exact.parse(round(alpha, 9))), Float64())) for alpha in grid]
    shown = [(alpha, value) for alpha, value in zip(grid, q, strict=True) if value > 0]
    if shown:
        ax.plot(*zip(*shown, strict=True), color=look.ink, linestyle=":", linewidth=1, label="$q_{lm}$")


def _here(spectrum: SheetSpectrum, ax: Axes, look: Look, part: Any) -> None:
    """The case itself: its velocity, and its roots with Re q ≥ 0."""
    alpha = float(spectrum.case.alpha)
    ax.axvline(alpha, color=look.faint, linewidth=0.8, linestyle=(0, (4, 3)))
    for k, root in enumerate(_half(spectrum), 1):
        style = look.root(root.q.imag < 0) | {"label": "this case" if k == 1 else None}
        ax.plot(alpha, part(root.q), **style, markersize=8, zorder=5, gid=f"here-{k}")


def _half(spectrum: SheetSpectrum) -> Iterable[Any]:
    return (root for root in spectrum.roots if not root.q.real < 0)


def _across(lines: FrequencyLines, ax: Axes, physical: PhysicalCase | None) -> Axes:
    low, high = float(lines.alpha[0]), float(lines.alpha[-1])
    ax.set(xlim=(low - 0.02 * (high - low), high + 0.02 * (high - low)), xlabel="velocity ratio α")
    velocity_axis(ax, physical)
    if ax.get_legend_handles_labels()[0]:
        # on a ground of its own, so that no line runs through its words
        ax.legend(loc="best", frameon=True, facecolor="white", edgecolor="none", framealpha=1)
    return ax
