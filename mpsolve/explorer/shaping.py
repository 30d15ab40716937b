"""The rail and the bodies in a vibration, as a picture that moves."""

from __future__ import annotations

from typing import Any

import numpy as np

from mpsolve.pictures.shape import moving_shape, numbered
from mpsolve.problem.problem import Problem
from mpsolve.spectrum.shape import root_shape

_POINTS = 121
_SPREAD = 1e-12


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
