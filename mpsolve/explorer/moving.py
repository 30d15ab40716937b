"""The motion after the vehicle is put on the track: the rail under the contacts, and the contact forces."""

from __future__ import annotations

import numpy as np

from mpsolve.pictures.lines import Curve, Mark, lines_picture
from mpsolve.problem.problem import Problem
from mpsolve.vibration.response import response

POINTS = 401
_SHOWN = 4


def motion_pictures(problem: Problem, seconds: float) -> str:
    """Two pictures, in mm and kN; grey after the first lift-off, which a line marks. Errors as of `response`."""
    found = response(problem, times=np.linspace(0.0, seconds, POINTS), places=problem.pencil.places)
    end = None if found.lift_off is None else float(found.lift_off.time)
    marks = [] if end is None else [Mark(end, "lift-off")]
    chosen = range(0, len(found.rail), max(1, -(-len(found.rail) // _SHOWN)))
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
