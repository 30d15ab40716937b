"""The motion after the vehicle is put on the track: curves of rail and forces, and the rail's shape with bodies."""

from __future__ import annotations

from typing import Any

import numpy as np

from mpsolve.explorer.player import player
from mpsolve.explorer.shaping import stretch
from mpsolve.pictures.lines import Curve, Mark, lines_picture
from mpsolve.pictures.shape import numbered, shape_in_time
from mpsolve.problem.problem import Problem
from mpsolve.vibration.response import response

POINTS = 401
PLACES = 81
EVERY = 4
"""Of the times: those at which the shape is drawn."""
PLAYED = 8.0  # s
_SHOWN = 4


def motion_pictures(problem: Problem, seconds: float) -> tuple[str, str]:
    """Two pictures of curves, in mm and kN, grey after the first lift-off; and the motion, played in PLAYED seconds.

    Errors as of `response`.
    """
    x = stretch(problem, PLACES)
    contacts = problem.pencil.places
    found = response(problem, times=np.linspace(0.0, seconds, POINTS), places=[*contacts, *x.tolist()])
    end = None if found.lift_off is None else float(found.lift_off.time)
    shape = found.rail[len(contacts) :, ::EVERY].T
    bodies = {name: moved[::EVERY] for name, moved in found.vehicle.items()}
    drawn = shape_in_time(x, shape, contacts, bodies, PLAYED) + numbered(bodies)
    return _curves(found, len(contacts), end), player(drawn, seconds, PLAYED, end)


def _curves(found: Any, contacts: int, end: float | None) -> str:
    marks = [] if end is None else [Mark(end, "lift-off")]
    chosen = range(0, contacts, max(1, -(-contacts // _SHOWN)))
    pictures = []
    for name, title, rows, factor, unit in (
        ("deflection", "Deflection of the rail under the contacts", found.rail, 1000.0, "mm"),
        ("force", "Contact forces", found.contact_force, 1e-3, "kN"),
    ):
        curves = [Curve(found.times, rows[k] * factor, f"contact {k + 1}", end) for k in chosen]
        pictures.append(
            lines_picture(curves, "time, s", f"{name}, {unit}", title, name=f"motion-{name}", marks=marks)
        )
    return "".join(pictures)
