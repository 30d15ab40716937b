"""The motion after the vehicle is put on the track: curves of rail and forces, and the rail's shape with bodies."""

from __future__ import annotations

from typing import Any

import numpy as np

from mpsolve.explorer.player import player
from mpsolve.pictures.lines import Curve, Mark, lines_picture
from mpsolve.pictures.shape import moving_shape, numbered, shape_in_time
from mpsolve.problem.problem import Problem
from mpsolve.spectrum.shape import root_shape
from mpsolve.vibration.response import response

POINTS = 401
PLACES = 81
EVERY = 4
"""Of the times: those at which the shape is drawn."""
PLAYED = 8.0  # s
_SHOWN = 4
_POINTS = 121
_SPREAD = 1e-12


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


def stretch(problem: Problem, points: int) -> Any:
    """Places under the vehicles and beside them, in m, to 0.1 mm."""
    places = [float(x) for x in problem.pencil.places]
    reach = max(6.0, 0.6 * (max(places) - min(places)))
    return np.linspace(min(places) - reach, max(places) + reach, points).round(4)


def root_picture(problem: Problem, q: complex) -> str:
    """The shape of the root near q."""
    from flint import acb, arb

    places = [float(x) for x in problem.pencil.places]
    x = stretch(problem, _POINTS)
    ball = acb(arb(q.real, _SPREAD * abs(q)), arb(q.imag, _SPREAD * abs(q)))
    shape = root_shape(problem, ball, places=[*x.tolist(), *places])
    rail = np.array([complex(w.mid()) for w in shape.rail[: len(x)]])
    bodies = {name: complex(a.mid()) for name, a in shape.bodies.items()}
    return moving_shape(x, rail, places, bodies, 2.0) + numbered(bodies)
