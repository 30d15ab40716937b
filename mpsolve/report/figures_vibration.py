"""Pictures of the motion of a problem in SI, by matplotlib, and a film of the rail's shape as one animated SVG.

What comes after the first lift-off is beyond the model: it is drawn pale, and no axis is stretched for it.
"""

from __future__ import annotations

from collections.abc import Mapping
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from mpsolve.errors import InputError
from mpsolve.files import write_whole
from mpsolve.report.figures import save_panels
from mpsolve.vibration.motion import Vibration

if TYPE_CHECKING:
    from matplotlib.axes import Axes

MOST_PANELS = 24
_PARTS = {"rail": "complete", "harmonic": "harmonic", "steady": "steady", "transient": "transient"}
_COLOURS = {"rail": "#000000", "harmonic": "#0072B2", "steady": "#009E73", "transient": "#D55E00"}
_PALETTE = ("#000000", "#0072B2", "#D55E00", "#009E73", "#CC79A7", "#56B4E9", "#E69F00")


def save_motion(found: Vibration, path: Path, title: str = "") -> Path:
    """A panel for each place and one of the contact forces, as .png, .svg or .pdf, written whole or not at all."""
    rows = len(found.places)
    if not 1 <= rows < MOST_PANELS:
        raise InputError("xi", f"has {rows} places: a picture takes 1 to {MOST_PANELS - 1}; write .csv or .npz")

    def forces(ax: Axes) -> None:
        pressing = {f"contact {j}": row / 1e3 for j, row in enumerate(found.contact_force, 1)}
        draw_curves(found, pressing, ax, "contact force [kN]", list(_PALETTE))
        ax.axhline(0, color="black", linewidth=0.6)

    panels = [partial(_place, found, k) for k in range(rows)]
    return save_panels([*panels, forces], path, title, 2.8, 0.6)


def _place(found: Vibration, k: int, ax: Axes) -> None:
    curves = {name: 1e3 * getattr(found, part)[k] for part, name in _PARTS.items()}
    draw_curves(found, curves, ax, f"$w$ [mm] at $x$ = {found.places[k]:g} m", list(_COLOURS.values()))
    ax.invert_yaxis()


def save_comparison(found: Vibration, curves: Mapping[str, Any], path: Path, title: str = "") -> Path:
    """Deflections [m] at one place by their names, in one panel."""

    def panel(ax: Axes) -> None:
        shown = {name: 1e3 * row for name, row in curves.items()}
        draw_curves(found, shown, ax, "$w$ [mm] under the rear contact", list(_PALETTE))
        ax.invert_yaxis()

    return save_panels([panel], path, title, 3.6)


def draw_curves(found: Vibration, curves: Mapping[str, Any], ax: Axes, label: str, colours: list[str]) -> Axes:
    """Curves over the times of `found`; pale after the first lift-off, which a line marks."""
    order = np.argsort(found.times)
    times, within = found.times[order], found.within[order]
    count = max(1, int(within.sum()))
    low, high = np.inf, -np.inf
    for k, (name, row) in enumerate(curves.items()):
        ordered, colour = row[order], colours[k % len(colours)]
        ax.plot(times[:count], ordered[:count], color=colour, linewidth=1.0, label=name)
        ax.plot(times[count - 1 :], ordered[count - 1 :], color=colour, linewidth=0.7, alpha=0.25)
        low, high = min(low, ordered[:count].min()), max(high, ordered[:count].max())
    room = 0.06 * (high - low) or 1.0
    ax.set(xlabel="$t$ [s]", ylabel=label, ylim=(low - room, high + room))
    event = found.lift_off
    if event is not None:
        ax.axvline(event.time, color="#D55E00", linewidth=0.8, linestyle="--")
        said = f"contact {event.contact} lifts off at {event.time:.4g} s: pale what is beyond the model"
        ax.set_title(said, fontsize=8, color="#D55E00")
    ax.legend(fontsize=8, frameon=False)
    return ax


_WIDTH, _HEIGHT, _EDGE = 760, 300, 40


def save_film(found: Vibration, path: Path, title: str = "", seconds: float = 12.0) -> Path:
    """The rail's shape over the places and the wheels on it, as an SVG that a browser plays, over and over.

    The bar below runs with the time. After the first lift-off everything is pale. InputError for fewer than 2 places.
    """
    if path.suffix.lower() != ".svg":
        raise InputError(
            "--animate", f"{path} does not end in .svg: give a name that does, the film is an animated SVG"
        )
    if len(found.places) < 2 or len(found.times) < 2:
        raise InputError("--animate", "needs two places and two times at least: give more")
    order, times = np.argsort(found.places), found.times
    x, w = found.places[order], found.rail[order]
    shown = w[:, found.within] if found.within.any() else w[:, :1]
    size = float(np.abs(shown).max()) or 1.0
    to_x = _EDGE + (x - x[0]) / (x[-1] - x[0]) * (_WIDTH - 2 * _EDGE)
    middle = _HEIGHT / 2
    to_y = middle + np.clip(w / size, -1.6, 1.6) * (_HEIGHT / 4)
    shapes = ["M" + "L".join(f"{a:.1f},{b:.1f}" for a, b in zip(to_x, column, strict=True)) for column in to_y.T]
    pale = ["#000000" if one else "#c8c8c8" for one in found.within]
    contacts = [float(place) for place in found.problem.pencil.places]
    wheels = []
    for place in contacts:
        at = _EDGE + (place - x[0]) / (x[-1] - x[0]) * (_WIDTH - 2 * _EDGE)
        rows = [f"{np.interp(place, x, column) - 9:.1f}" for column in to_y.T]
        wheels.append(f'<circle cx="{at:.1f}" cy="{rows[0]}" r="9" fill="none" stroke="#0072B2" stroke-width="2">'
                      f"{_animated('cy', rows, seconds)}</circle>")  # fmt: skip
    event = found.lift_off
    said = (
        "" if event is None else f"; contact {event.contact} lifts off at {event.time:.4g} s, then beyond the model"
    )
    text = f"largest deflection {size * 1e3:.4g} mm, {times[0]:g} s to {times[-1]:g} s{said}"
    bar = [f"{_EDGE + (t - times[0]) / (times[-1] - times[0]) * (_WIDTH - 2 * _EDGE):.1f}" for t in times]
    lines = [
        f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {_WIDTH} {_HEIGHT}" font-family="sans-serif">',
        f'<rect width="{_WIDTH}" height="{_HEIGHT}" fill="white"/>',
        f'<text x="{_EDGE}" y="22" font-size="12">{_escaped(title)}</text>',
        f'<text x="{_EDGE}" y="40" font-size="12">{text}</text>',
        f'<path d="M{_EDGE},{middle}H{_WIDTH - _EDGE}" stroke="#999" stroke-dasharray="3 3" fill="none"/>',
        f'<path d="{shapes[0]}" fill="none" stroke="#000000" stroke-width="1.6">',
        f"{_animated('d', shapes, seconds)}{_animated('stroke', pale, seconds, discrete=True)}</path>",
        *wheels,
        f'<path d="M{_EDGE},{_HEIGHT - 20}H{_WIDTH - _EDGE}" stroke="#999" fill="none"/>',
        f'<circle cx="{_EDGE}" cy="{_HEIGHT - 20}" r="4" fill="#D55E00">{_animated("cx", bar, seconds)}</circle>',
        "</svg>",
    ]
    return write_whole(path, "\n".join(lines) + "\n")


def _animated(key: str, values: list[str], seconds: float, discrete: bool = False) -> str:
    mode = ' calcMode="discrete"' if discrete else ""
    return (f'<animate attributeName="{key}" dur="{seconds:g}s" repeatCount="indefinite"{mode} '
            f'values="{";".join(values)}"/>')  # fmt: skip


def _escaped(text: str) -> str:
    return text.replace("&", "&amp;").replace("<", "&lt;").replace(">", "&gt;")
