"""Frequency lines over one parameter, real and imaginary parts apart, as is usual in the field.

Ids in the pictures: line-K, the K-th of the lines from 1, and here-K, the K-th root of the problem that is marked.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING, Any

import numpy as np

from mpsolve.loci.answer import FrequencyLine, FrequencyLines
from mpsolve.numbers.balls import acb
from mpsolve.problem.case import Case
from mpsolve.problem.cases import as_problem
from mpsolve.report.figures import COLOUR, Look, scaling
from mpsolve.report.figures_ranges import SYMBOLS
from mpsolve.spectrum.regions import Below
from mpsolve.spectrum.spectrum import Spectrum

if TYPE_CHECKING:
    from matplotlib.axes import Axes

_KMH = 3.6
Part = Callable[[Any], float]


def line_frequencies(lines: FrequencyLines, ax: Axes, spectrum: Spectrum | None = None, look: Look = COLOUR) -> Axes:
    """Re q of each line over the parameter, in Hz too for SI; `spectrum`: of the problem that is marked; `ax`."""
    _lines(lines, ax, look, _real)
    if spectrum is not None:
        _here(lines, spectrum, ax, look, _real)
    ax.set(ylabel=f"Re q{_rate(lines)}", ylim=(0, None))
    if _rate(lines):
        side: Any = ax.secondary_yaxis("right", functions=scaling(1 / (2 * np.pi)))
        side.set_ylabel("frequency [Hz]")
    return _across(lines, ax)


def line_growth(lines: FrequencyLines, ax: Axes, spectrum: Spectrum | None = None, look: Look = COLOUR) -> Axes:
    """Im q of each line over the parameter, the upper side of the region dotted, the unstable half shaded; `ax`."""
    _lines(lines, ax, look, _imaginary)
    ax.axhline(0, color=look.ink, linewidth=0.8)
    if isinstance(lines.region, Below):
        label = "the lines end here"
        ax.axhline(float(lines.region.height), color=look.ink, linestyle=":", linewidth=1, label=label)
    if spectrum is not None:
        _here(lines, spectrum, ax, look, _imaginary)
    low, high = ax.get_ylim()
    if low < 0:
        ax.axhspan(low, 0, color=look.shade, linewidth=0, zorder=0, label="Im q < 0: unstable")
        ax.set_ylim(low, high)
    ax.set_ylabel(f"Im q{_rate(lines)}")
    return _across(lines, ax)


def drawn(line: FrequencyLine) -> tuple[list[float], list[Any]]:
    """(values, q) of the points of a line, with its ends where these are known, in order."""
    first, last = ([] if end.value is None else [(float(end.value.mid()), acb(end.q))] for end in line.ends)
    inner = [(float(value), q) for value, q in zip(line.values, line.q, strict=True)]
    points = [*first, *inner, *last]
    return [x for x, _ in points], [q for _, q in points]


def _real(q: Any) -> float:
    return float(q.real.mid())


def _imaginary(q: Any) -> float:
    return float(q.imag.mid())


def _rate(lines: FrequencyLines) -> str:
    return "" if isinstance(lines.problem, Case) else " [rad/s]"


def _lines(lines: FrequencyLines, ax: Axes, look: Look, part: Part) -> None:
    """Every line with a mark at each proved root; a ring where it leaves the region."""
    for k, line in enumerate(lines.lines):
        x, q = drawn(line)
        ax.plot(x, [part(one) for one in q], **look.line(k), marker=".", markersize=3.5, gid=f"line-{k + 1}")
        for end in line.ends:
            if end.kind == "region":
                at = float(end.value.mid()), part(end.q)  # type: ignore[union-attr]
                ax.plot(*at, "o", color=look.cut, markerfacecolor="white", markersize=5, zorder=4)


def _here(lines: FrequencyLines, spectrum: Spectrum, ax: Axes, look: Look, part: Part) -> None:
    """The problem itself: its value of the parameter, and its roots with Re q ≥ 0."""
    own = as_problem(spectrum.problem).parameters[next(iter(lines.over))]
    ax.axvline(float(own), color=look.faint, linewidth=0.8, linestyle=(0, (4, 3)))
    for k, root in enumerate((root for root in spectrum.roots if not root.q.real < 0), 1):
        style = look.root(root.q.imag < 0) | {"label": "this case" if k == 1 else None}
        ax.plot(float(own), part(root.q), **style, markersize=8, zorder=5, gid=f"here-{k}")


def _across(lines: FrequencyLines, ax: Axes) -> Axes:
    (path, ends), *_ = lines.over.items()
    low, high = map(float, ends)
    unit = "" if isinstance(lines.problem, Case) else as_problem(lines.problem).quantity(path).unit
    name = SYMBOLS["alpha"] if path == "v" and not unit else SYMBOLS.get(path, path)
    ax.set(xlim=(low - 0.02 * (high - low), high + 0.02 * (high - low)), xlabel=f"{name} [{unit}]" if unit else name)
    if unit == "m/s":
        top: Any = ax.secondary_xaxis("top", functions=scaling(_KMH))
        top.set_xlabel("velocity [km/h]")
        ax.spines["top"].set_visible(True)
    if ax.get_legend_handles_labels()[0]:
        # on a ground of its own, so that no line runs through its words
        ax.legend(loc="best", frameon=True, facecolor="white", edgecolor="none", framealpha=1)
    return ax
