"""The motion after the vehicle is put on the track: curves of rail and forces, and the rail's shape with bodies."""

from __future__ import annotations

import numpy as np
from flint import acb, arb

from mpsolve.explorer.player import player
from mpsolve.pictures import lines
from mpsolve.pictures.shape import moving_shape, numbered, shape_along, shape_in_time, stretch
from mpsolve.problem.problem import Problem
from mpsolve.vibration.response import response

POINTS = 401
PLACES = 81
EVERY = 4
"""Of the times: those at which the shape is drawn."""
PLAYED = 8.0  # s
_SHOWN = 4
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
    names = {k: f"contact {k + 1}" for k in range(0, len(contacts), max(1, -(-len(contacts) // _SHOWN)))}
    return "".join(lines.motion_pictures(found, names, True, prefix="motion-")), player(drawn, seconds, PLAYED, end)


def root_picture(problem: Problem, q: complex) -> str:
    """The shape of the root near q."""
    ball = acb(arb(q.real, _SPREAD * abs(q)), arb(q.imag, _SPREAD * abs(q)))
    x, rail, bodies = shape_along(problem, ball)
    return moving_shape(x, rail, problem.pencil.places, bodies, 2.0) + numbered(bodies)
