"""Pictures of a response, by matplotlib: each function draws on the Axes it is given.

Ids in `displacements` and `contact_forces`: w-K, envelope-K (of the K-th contact point from 1), force-K, loss-K (of
the K-th mass).
"""

from __future__ import annotations

from collections.abc import Mapping
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from mpsolve.errors import InputError
from mpsolve.report.figures import COLOUR, Look, require_matplotlib, save_panels
from mpsolve.vibration.case_motion import Response
from mpsolve.vibration.case_units import Scale

if TYPE_CHECKING:
    from matplotlib.animation import FuncAnimation
    from matplotlib.axes import Axes


MOST_PANELS = 24
_PARTS = {"w": "complete", "harmonic": "unsteady harmonic", "steady": "steady", "transient": "truly transient"}
_PALETTE = ("#000000", "#0072B2", "#D55E00", "#009E73", "#CC79A7")  # Okabe and Ito's
_COLOURS = {"w": "#000000", "harmonic": "#0072B2", "steady": "#009E73", "transient": "#D55E00"}


def draw_history(
    found: Response,
    ax: Axes,
    index: int = 0,
    parts: tuple[str, ...] = ("w", "steady", "harmonic", "transient"),
    scale: Scale | None = None,
) -> Axes:
    """The displacement at xi[index] over time, whole and in parts; the axis points down, as displacements do."""
    scale, order = scale or Scale(), np.argsort(found.tau)
    for part in parts:
        curve = getattr(found, part)[index, order] * scale.length
        ax.plot(found.tau[order] * scale.time, curve, color=_COLOURS[part], linewidth=1.0, label=_PARTS[part])
    if found.lift_off is not None:
        _beyond(found, ax, found.lift_off.time, [getattr(found, part)[index] * scale.length for part in parts], scale)
    return _over_time(ax, scale, f"at $ξ = {found.xi[index]:g}$")


def _beyond(found: Response, ax: Axes, lost: float, curves: list[Any], scale: Scale) -> None:
    """Pale what comes after contact is lost, beyond the model, and no axis is stretched for it."""
    within = found.tau <= lost
    if within.any() and not within.all():
        low, high = (f([f(curve[within]) for curve in curves]) for f in (min, max))
        room = 0.06 * (high - low) or 1.0
        ax.set_ylim(low - room, high + room)
    ax.axvspan(lost * scale.time, found.tau.max() * scale.time, color="white", alpha=0.7, zorder=3)
    ax.axvline(lost * scale.time, color="#D55E00", linewidth=0.8, linestyle="--")
    said = "contact is lost at the dashed line: pale what is beyond the model"
    ax.set_title(said, fontsize=8, color="#D55E00")


def _over_time(ax: Axes, scale: Scale, where: str) -> Axes:
    shown = "$w$ [mm]" if scale.physical else "$w/w_{st}$"
    ax.set(xlabel="$t$ [s]" if scale.physical else "$τ$", ylabel=f"{shown} {where}")
    ax.invert_yaxis()
    ax.legend(fontsize=8, frameon=False)
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


def draw_curves(found: Response, curves: Mapping[str, Any], ax: Axes, scale: Scale | None = None) -> Axes:
    """Displacements of the rear contact point by name over ascending times, the first one in black."""
    scale, tau = scale or Scale(), found.tau
    for k, (name, curve) in enumerate(curves.items()):
        colour = _PALETTE[k % len(_PALETTE)]
        ax.plot(tau * scale.time, curve * scale.length, color=colour, linewidth=1.0, label=name)
    if found.lift_off is not None:
        _beyond(found, ax, found.lift_off.time, [curve * scale.length for curve in curves.values()], scale)
    return _over_time(ax, scale, "of the rear contact point")


def save_history(found: Response, path: Path, title: str = "", scale: Scale | None = None) -> Path:
    """One panel a position, as .png, .svg or .pdf, written whole or not at all; InputError for too many panels."""
    rows = len(found.xi)
    if not 1 <= rows <= MOST_PANELS:
        raise InputError(
            "xi", f"has {rows} positions: a picture takes 1 to {MOST_PANELS}; write .csv or .npz for more"
        )
    panels = [partial(draw_history, found, index=k, scale=scale) for k in range(rows)]
    return save_panels(panels, path, title, 2.8, 0.6)


def save_curves(
    found: Response, curves: Mapping[str, Any], path: Path, title: str = "", scale: Scale | None = None
) -> Path:
    """One panel with all curves, as .png, .svg or .pdf, written whole or not at all."""
    return save_panels([partial(draw_curves, found, curves, scale=scale)], path, title, 2.8, 0.6)


def displacements(response: Response, ax: Axes, scale: Scale | None = None, look: Look = COLOUR) -> Axes:
    """w at each ξ over time, downward on the page too; dotted: the steady part ± the envelope; returns `ax`."""
    scale = scale or Scale()
    order = np.argsort(response.tau)
    t, bounds = response.tau[order] * scale.time, response.envelope
    for k in range(len(response.xi)):
        style = look.line(k)
        ax.plot(t, response.w[k, order] * scale.length, **style, label=f"contact point {k + 1}", gid=f"w-{k + 1}")
        for sign in (1, -1):
            edge = (response.steady[k] + sign * bounds[k])[order] * scale.length
            name: dict[str, Any] = {"gid": f"envelope-{k + 1}"} if sign > 0 else {}
            ax.plot(t, edge, color=style["color"], linestyle=":", linewidth=1, **name)
    ax.plot([], [], color=look.ink, linestyle=":", linewidth=1, label="steady part ± envelope")
    ax.axhline(0, color=look.faint, linewidth=0.6)
    ax.invert_yaxis()
    unit = f"[{scale.length_name}]" if scale.physical else "w in units of $w_{st}$"
    return _timed(ax, t, scale, f"displacement, downward\n{unit}")


def contact_forces(response: Response, ax: Axes, scale: Scale | None = None, look: Look = COLOUR) -> Axes:
    """The force of each mass on the beam over time; a cross where it first falls to zero; returns `ax`."""
    scale = scale or Scale()
    order = np.argsort(response.tau)
    t = response.tau[order] * scale.time
    for k, force in enumerate(response.contact_forces):
        ax.plot(t, force[order] * scale.force, **look.line(k), label=f"mass {k + 1}", gid=f"force-{k + 1}")
        loss = response.contact_loss[k]
        if loss is not None:
            mark: dict[str, Any] = {"color": look.ink, "markersize": 9, "markeredgewidth": 2, "zorder": 5}
            ax.plot(loss * scale.time, 0, "x", **mark, gid=f"loss-{k + 1}", label=f"mass {k + 1} would lift off")
    low, high = ax.get_ylim()
    if low < 0:
        ax.axhspan(low, 0, color=look.shade, linewidth=0, zorder=0)
        ax.set_ylim(low, high)
    ax.axhline(0, color=look.ink, linewidth=0.8)
    unit = f"[{scale.force_name}]" if scale.physical else "in unit forces"
    return _timed(ax, t, scale, f"contact force, pressing\n{unit}")


def _timed(ax: Axes, t: Any, scale: Scale, label: str) -> Axes:
    time = "time t [s]" if scale.physical else "time τ"
    ax.set(xlabel=time, ylabel=label)
    if len(t) and t[0] < t[-1]:
        ax.set_xlim(float(t[0]), float(t[-1]))
    ax.legend(loc="lower center", bbox_to_anchor=(0.5, 1.0), ncols=3, columnspacing=1.2, handlelength=1.8)
    return ax
