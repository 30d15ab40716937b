"""Pictures of a motion, by matplotlib: of a problem in SI, or of a case of the paper in the units of a `Scale`.

What comes after the first lift-off is beyond the model: it is drawn pale, and no axis is stretched for it.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from mpsolve.errors import InputError
from mpsolve.numbers.arrays import Reals, Truths
from mpsolve.report.figures import require_matplotlib, save_panels
from mpsolve.vibration.case_motion import Response, Scale
from mpsolve.vibration.motion import Vibration

if TYPE_CHECKING:
    from matplotlib.animation import FuncAnimation
    from matplotlib.axes import Axes

MOST_PANELS = 24
_PARTS = {"complete": "#000000", "harmonic": "#0072B2", "steady": "#009E73", "transient": "#D55E00"}
_PALETTE = ("#000000", "#0072B2", "#D55E00", "#009E73", "#CC79A7", "#56B4E9", "#E69F00")  # Okabe and Ito's


@dataclass(frozen=True)
class Scene:
    """A motion as pictures show it. length: what one of its deflections is in the units that are shown.

    parts: (places, times) each, forces (contacts, times), both as they are shown; places: where each panel is.
    """

    times: Reals
    within: Truths
    places: Sequence[str]
    parts: Mapping[str, Reals]
    forces: Reals
    length: float
    time_label: str
    length_label: str
    force_label: str
    lost: tuple[float, str] | None


def scene(found: Vibration | Response, scale: Scale | None = None) -> Scene:
    """In s, mm and kN, or in the units of `scale` where it is a case of the paper."""
    scale, event = scale or Scale(), found.lift_off
    rows: dict[str, Any] = {name: getattr(found, name) for name in ("steady", "harmonic", "transient")}
    if isinstance(found, Response):
        times, length, force, seconds = found.tau * scale.time, scale.length, scale.force, scale.physical
        places, rows["complete"] = [f"$ξ = {x:g}$" for x in found.xi], found.w
        words = "$w$ [mm]" if seconds else "$w/w_{st}$", f"[{scale.force_name}]" if seconds else "in unit forces"
        forces, lost = found.contact_forces, None if event is None else event.time * scale.time
    else:
        times, length, force, seconds = found.times, 1e3, 1e-3, True
        places, rows["complete"] = [f"$x$ = {x:g} m" for x in found.places], found.rail
        words = "$w$ [mm]", "[kN]"
        forces, lost = found.contact_force, None if event is None else event.time
    when = "" if lost is None else f"{lost:.4g} s" if seconds else f"τ = {lost:.4g}"
    return Scene(
        times=times,
        within=found.within,
        places=places,
        parts={name: length * rows[name] for name in _PARTS},
        forces=force * forces,
        length=length,
        time_label="$t$ [s]" if seconds else "$τ$",
        length_label=words[0],
        force_label=f"contact force {words[1]}",
        lost=None if event is None or lost is None else (lost, f"contact {event.contact} lifts off at {when}"),
    )


def draw_curves(
    shown: Scene, curves: Mapping[str, Reals], ax: Axes, label: str, colours: Sequence[str] = _PALETTE
) -> Axes:
    """Curves over the times; pale after the first lift-off, which a line marks."""
    order = np.argsort(shown.times)
    times, within = shown.times[order], shown.within[order]
    count = max(1, int(within.sum()))
    low, high = np.inf, -np.inf
    for k, (name, row) in enumerate(curves.items()):
        ordered, colour = row[order], colours[k % len(colours)]
        ax.plot(times[:count], ordered[:count], color=colour, linewidth=1.0, label=name)
        ax.plot(times[count - 1 :], ordered[count - 1 :], color=colour, linewidth=0.7, alpha=0.25)
        low, high = min(low, ordered[:count].min()), max(high, ordered[:count].max())
    room = 0.06 * (high - low) or 1.0
    ax.set(xlabel=shown.time_label, ylabel=label, ylim=(low - room, high + room))
    if shown.lost is not None:
        time, said = shown.lost
        ax.axvline(time, color="#D55E00", linewidth=0.8, linestyle="--")
        ax.set_title(f"{said}: pale what is beyond the model", fontsize=8, color="#D55E00")
    ax.legend(fontsize=8, frameon=False)
    return ax


def draw_place(shown: Scene, k: int, ax: Axes) -> Axes:
    """The deflection at one place, whole and in parts; the axis points down, as deflections do."""
    curves = {name: rows[k] for name, rows in shown.parts.items()}
    draw_curves(shown, curves, ax, f"{shown.length_label} at {shown.places[k]}", list(_PARTS.values()))
    ax.invert_yaxis()
    return ax


def draw_forces(shown: Scene, ax: Axes) -> Axes:
    """The contact forces, from rear to front."""
    draw_curves(shown, {f"contact {j}": row for j, row in enumerate(shown.forces, 1)}, ax, shown.force_label)
    ax.axhline(0, color="black", linewidth=0.6)
    return ax


def save_motion(found: Vibration | Response, path: Path, title: str = "", scale: Scale | None = None) -> Path:
    """A panel for each place and one of the contact forces, as .png, .svg or .pdf, written whole or not at all."""
    shown = scene(found, scale)
    rows = len(shown.places)
    if not 1 <= rows < MOST_PANELS:
        raise InputError("xi", f"has {rows} places: a picture takes 1 to {MOST_PANELS - 1}; write .csv or .npz")
    panels = [partial(draw_place, shown, k) for k in range(rows)]
    return save_panels([*panels, partial(draw_forces, shown)], path, title, 2.8, 0.6)


def save_comparison(
    found: Vibration | Response, curves: Mapping[str, Reals], path: Path, title: str = "", scale: Scale | None = None
) -> Path:
    """Deflections under the rear contact by their names, in the units of `found`, in one panel."""
    shown = scene(found, scale)

    def panel(ax: Axes) -> None:
        own = {name: shown.length * row for name, row in curves.items()}
        draw_curves(shown, own, ax, f"{shown.length_label} under the rear contact")
        ax.invert_yaxis()

    return save_panels([panel], path, title, 3.6)


def draw_shape(found: Response, ax: Axes, time: int = -1) -> Axes:
    """The deflection over ξ at tau[time], with the contact points."""
    order = np.argsort(found.xi)
    ax.plot(found.xi[order], found.w[order, time], color="black", linewidth=1.0)
    for place in found.case.positions:
        ax.axvline(float(place), color="#D55E00", linewidth=0.8, linestyle="--")
    ax.set(xlabel="$ξ$", ylabel="$\\hat w$", title=f"$τ = {found.tau[time]:g}$")
    ax.invert_yaxis()
    return ax


def animation(found: Response) -> FuncAnimation:
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

    return FuncAnimation(figure, show, frames=len(found.tau), interval=40)
