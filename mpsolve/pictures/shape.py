"""The rail and the bodies, moving: through one period of a vibration, or in time."""

from __future__ import annotations

from collections.abc import Sequence
from html import escape
from typing import Any

import numpy as np

from mpsolve.numbers.arrays import Complexes, Reals
from mpsolve.pictures.axes import BOTTOM, LEFT, RIGHT, TOP, WIDE, Axes, alone, frame, label, svg, text, ticks
from mpsolve.problem.problem import Problem
from mpsolve.spectrum.shape import root_shape
from mpsolve.vibration.motion import Vibration

_FRAMES, _POINTS = 24, 121
_NAMED = 4  # more coordinates than these are numbered: their names have no room
_BOXES = 24
_PLAYED = 12.0  # s, of a film
_BEYOND = 1.5  # of the largest within the model: as far as what is beyond it is drawn


def stretch(problem: Problem, points: int) -> Reals:
    """Places under the vehicles and beside them, in m, to 0.1 mm."""
    contacts = [float(x) for x in problem.pencil.places]
    reach = max(6.0, 0.6 * (max(contacts) - min(contacts)))
    return np.linspace(min(contacts) - reach, max(contacts) + reach, points).round(4)


def shape_along(problem: Problem, q: Any, multiplicity: int = 1) -> tuple[Reals, Complexes, dict[str, complex]]:
    """The shape of a root, a ball: places, the rail there, and the bodies by their names."""
    x = stretch(problem, _POINTS)
    found = root_shape(problem, q, multiplicity, places=x.tolist())
    rail = np.array([complex(w.mid()) for w in found.rail])
    return x, rail, {name: complex(a.mid()) for name, a in found.bodies.items()}


def moving_shape(
    places: Reals, rail: Any, contacts: Any, bodies: dict[str, complex], seconds: float, x_title: str = "x, m"
) -> str:
    """The rail and the bodies in one vibration: they move through one period, in `seconds`, without growth.

    places: of the rail, in m; rail: complex amplitudes there; contacts: places of the contacts. The rail is drawn
    with its own scale, and the picture says how much larger than the bodies.
    """
    turns = np.exp(2j * np.pi * np.arange(_FRAMES + 1) / _FRAMES)
    largest = max((abs(x) for x in bodies.values()), default=0.0) or 1.0
    size = float(np.abs(rail).max()) or 1.0
    rows = (np.outer(turns, rail).real / size, {name: (x * turns).real / largest for name, x in bodies.items()})
    said = "The shape of the chosen vibration: rail and bodies"
    return _frames(places, *rows, contacts, seconds, x_title, largest / size, said)


def shape_in_time(
    places: Reals,
    rail: Reals,
    contacts: Any,
    bodies: dict[str, Reals],
    seconds: float,
    more: Sequence[str] = ("", ""),
) -> str:
    """The rail and the bodies at one time after the other, in `seconds`; scales as of `moving_shape`.

    rail: (times, places); bodies: (times,) each. more: what else moves the rail's line, and what else is drawn.
    """
    largest = max((float(np.abs(x).max()) for x in bodies.values()), default=0.0) or 1.0
    size = float(np.abs(rail).max()) or 1.0
    moved = {name: np.asarray(x) / largest for name, x in bodies.items()}
    said = "The motion in time: rail and bodies"
    return _frames(places, np.asarray(rail) / size, moved, contacts, seconds, "x, m", largest / size, said, more)


def film(found: Vibration, title: str) -> str:
    """The motion as a file of its own that a browser plays, over and over; a bar at the top runs with the time.

    After the first lift-off the rail is pale, and no scale is stretched for it.
    """
    within, times, event = found.within, found.times, found.lift_off

    def held(rows: Reals) -> Reals:
        most = _BEYOND * (float(np.abs(rows[..., within]).max(initial=0.0)) or 1.0)
        return np.clip(rows, -most, most)

    said = f"largest deflection {1e3 * float(np.abs(found.rail[:, within]).max(initial=0.0)):.4g} mm"
    lost = "" if event is None else f"contact {event.contact} lifts off at {event.time:.4g} s, then beyond the model"
    pale = _animated("stroke", ["#0072b2" if one else "#c8c8c8" for one in within], _PLAYED, discrete=True)
    bar = [f"{x:.1f}" for x in np.linspace(LEFT, WIDE - RIGHT, len(times))]
    moved = f'<circle class="root" cy="{TOP}" r="4">{_animated("cx", bar, _PLAYED)}</circle>'
    lines = (title, f"{said}, {times[0]:g} s to {times[-1]:g} s", lost)
    words = "".join(text(LEFT + 8, TOP + 18 + 16 * k, line) for k, line in enumerate(lines) if line)
    bodies = {name: held(row) for name, row in found.vehicle.items()}
    contacts = found.problem.pencil.places
    return alone(shape_in_time(found.places, held(found.rail).T, contacts, bodies, _PLAYED, (pale, words + moved)))


def _frames(
    places: Reals,
    rail: Reals,
    bodies: dict[str, Reals],
    contacts: Any,
    seconds: float,
    x_title: str,
    larger: float,
    said: str,
    more: Sequence[str] = ("", ""),
) -> str:
    """rail (frames, places) and bodies (frames,) each, at most 1."""
    high = 300
    axes = Axes((float(places[0]), float(places[-1])), (-1.4, 4.2), high)
    xs = axes.px(places)
    curves = [" ".join(f"{x:.1f},{y:.1f}" for x, y in zip(xs, axes.py(-row), strict=True)) for row in rail]
    parts = [
        f'<polyline class="rail" points="{curves[0]}">{_animated("points", curves, seconds)}{more[0]}</polyline>',
        text(LEFT + 8, high - BOTTOM - 8, f"rail drawn {larger:.3g} times as large as the bodies"),
    ]
    for place in contacts:
        at = np.array([np.interp(float(place), places, row) for row in rail])
        ys = [f"{y:.1f}" for y in axes.py(-at) - 9]
        x = float(axes.px(float(place)))
        parts.append(f'<circle class="body" cx="{x:.1f}" cy="{ys[0]}" r="7">{_animated("cy", ys, seconds)}</circle>')
    parts += _boxes(axes, dict(list(bodies.items())[:_BOXES]), seconds)
    parts += [
        more[1],
        frame(high),
        f'<text x="{WIDE / 2}" y="{high - 4}" text-anchor="middle">{x_title} (ahead is right)</text>',
    ]
    for t in ticks(*axes.x):
        parts.append(
            f'<text x="{float(axes.px(t)):.1f}" y="{high - BOTTOM + 18}" text-anchor="middle">{label(t)}</text>'
        )
    return svg(parts, said, high)


def numbered(bodies: dict[str, complex]) -> str:
    """Which coordinate has which number, where the picture has no room for names."""
    if len(bodies) <= _NAMED:
        return ""
    return "<p>" + ", ".join(f"{k}: {escape(name)}" for k, name in enumerate(bodies, 1)) + "</p>"


def _boxes(axes: Axes, bodies: dict[str, Reals], seconds: float) -> list[str]:
    """Each coordinate of the vehicles as a box that moves up and down, with its name."""
    parts = []
    width = (WIDE - LEFT - RIGHT) / max(len(bodies), 1)
    for k, (name, moved) in enumerate(bodies.items()):
        middle = LEFT + (k + 0.5) * width
        ys = [f"{y - 7:.1f}" for y in axes.py(2.9 - 0.8 * moved)]
        parts.append(
            f'<rect class="body" x="{middle - 0.35 * width:.1f}" y="{ys[0]}" width="{0.7 * width:.1f}" height="14">'
            f"{_animated('y', ys, seconds)}</rect>"
        )
        said = name if len(bodies) <= _NAMED else str(k + 1)
        parts.append(text(middle, float(axes.py(1.62)), said, "middle"))
    return parts


def _animated(attribute: str, values: Sequence[str], seconds: float, discrete: bool = False) -> str:
    steps = ' calcMode="discrete"' if discrete else ""
    name = f'attributeName="{attribute}" dur="{seconds:g}s" repeatCount="indefinite"{steps}'
    return f'<animate {name} values="{";".join(values)}"/>'
