"""Pictures of a response, by matplotlib: each function draws on the Axes it is given."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from mpsolve.certificate.format import write_whole
from mpsolve.motion.solve import Response
from mpsolve.report.figures import rendered, require_matplotlib

if TYPE_CHECKING:
    from matplotlib.animation import FuncAnimation
    from matplotlib.axes import Axes

_PARTS = {"w": "complete", "harmonic": "unsteady harmonic", "steady": "steady", "transient": "truly transient"}
_PALETTE = ("#000000", "#0072B2", "#D55E00", "#009E73", "#CC79A7")  # Okabe and Ito's
_COLOURS = {"w": "#000000", "harmonic": "#0072B2", "steady": "#009E73", "transient": "#D55E00"}


def draw_history(
    found: Response, ax: Axes, index: int = 0, parts: tuple[str, ...] = ("w", "steady", "harmonic", "transient")
) -> Axes:
    """The displacement at xi[index] over τ, whole and in parts; the axis points down, as displacements do."""
    for part in parts:
        ax.plot(found.tau, getattr(found, part)[index], color=_COLOURS[part], linewidth=1.0, label=_PARTS[part])
    ax.set(xlabel="$τ$", ylabel=f"$\\hat w$ at $ξ = {found.xi[index]:g}$")
    ax.invert_yaxis()
    ax.legend(fontsize=8, frameon=False)
    return ax


def draw_envelope(found: Response, modulus: Any, ax: Axes, index: int = 0) -> Axes:
    """The unsteady harmonic part at xi[index] between its envelopes (Figures 3–8)."""
    ax.plot(found.tau, found.harmonic[index], color=_COLOURS["harmonic"], linewidth=1.0)
    for sign in (1, -1):
        ax.plot(found.tau, sign * np.asarray(modulus), color="black", linestyle=":", linewidth=0.9)
    ax.set(xlabel="$τ$", ylabel=f"unsteady harmonic part at $ξ = {found.xi[index]:g}$")
    ax.invert_yaxis()
    return ax


def draw_shape(found: Response, ax: Axes, time: int = -1) -> Axes:
    """The deflection over ξ at tau[time], with the contact points."""
    order = np.argsort(found.xi)
    ax.plot(found.xi[order], found.w[order, time], color="black", linewidth=1.0)
    for place in found.case.positions:
        ax.axvline(float(place), color="#D55E00", linewidth=0.8, linestyle="--")
    ax.set(xlabel="$ξ$", ylabel="$\\hat w$", title=f"$τ = {found.tau[time]:g}$")
    ax.invert_yaxis()
    return ax


def animation(found: Response, milliseconds: int = 40) -> FuncAnimation:
    """The shape as it moves, one picture for each time; `animation.save(path, writer="pillow")` makes a GIF."""
    require_matplotlib()
    from matplotlib.animation import FuncAnimation
    from matplotlib.backends.backend_agg import FigureCanvasAgg
    from matplotlib.figure import Figure

    figure = Figure(figsize=(7.2, 3.6), layout="constrained")
    FigureCanvasAgg(figure)
    ax = draw_shape(found, figure.add_subplot(), 0)
    order, line = np.argsort(found.xi), ax.lines[0]
    low, high = float(found.w.min()), float(found.w.max())
    margin = 0.05 * (high - low) + 1e-12
    ax.set_ylim(high + margin, low - margin)

    def show(frame: int) -> list[Any]:
        line.set_ydata(found.w[order, frame])
        ax.set_title(f"$τ = {found.tau[frame]:g}$")
        return [line]

    return FuncAnimation(figure, show, frames=len(found.tau), interval=milliseconds)


def draw_curves(curves: Mapping[str, Any], tau: Any, ax: Axes) -> Axes:
    """Curves by name over τ, the first one in black."""
    for k, (name, curve) in enumerate(curves.items()):
        ax.plot(tau, curve, color=_PALETTE[k % len(_PALETTE)], linewidth=1.0, label=name)
    ax.set(xlabel="$τ$", ylabel="$\\hat w$ of the rear contact point")
    ax.invert_yaxis()
    ax.legend(fontsize=8, frameon=False)
    return ax


def save_history(found: Response, path: Path, title: str = "") -> Path:
    """One panel a position, as .png, .svg or .pdf, written whole or not at all."""
    rows = len(found.xi)
    panels = [lambda ax, k=k: draw_history(found, ax, k) for k in range(rows)]
    return _save(panels, path, title)


def save_curves(curves: Mapping[str, Any], tau: Any, path: Path, title: str = "") -> Path:
    """One panel with all curves, as .png, .svg or .pdf, written whole or not at all."""
    return _save([lambda ax: draw_curves(curves, tau, ax)], path, title)


def _save(panels: Sequence[Callable[[Any], Any]], path: Path, title: str) -> Path:
    require_matplotlib()
    from matplotlib.figure import Figure

    figure = Figure(figsize=(8.0, 2.8 * len(panels) + 0.6), layout="constrained")
    for k, panel in enumerate(panels):
        panel(figure.add_subplot(len(panels), 1, k + 1))
    if title:
        figure.suptitle(title, fontsize=11)
    return write_whole(path, rendered(figure, path.suffix.lower()[1:]))
