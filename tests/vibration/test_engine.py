"""The engine alone: what it says of its error, when a root is kept from it."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
from track_models import DAMPED
from vehicle_models import TYPICAL

from mpsolve import Problem
from mpsolve.vehicles.loads import outer_forces
from mpsolve.vibration.engine import Engine
from mpsolve.vibration.forcing import tones
from mpsolve.vibration.image import Image
from mpsolve.vibration.poles import searched

PROBLEM = Problem(DAMPED["two-layer"], TYPICAL["bogie"], v=100)
IMAGE = Image(PROBLEM, PROBLEM.pencil.places)
ACTING = tones(IMAGE, outer_forces(IMAGE.pencil, None), ())
TIMES = np.linspace(0, 0.5, 40) * IMAGE.rate


def test_a_root_that_is_kept_back_is_noticed() -> None:
    """Then the line runs above all growth, and the motion is the same."""
    poles = searched(PROBLEM)
    whole = Engine(IMAGE, ACTING, (), poles).solve(TIMES)
    lacking = Engine(IMAGE, ACTING, (), replace(poles, poles=poles.poles[1:])).solve(TIMES)
    assert whole.line.path.alpha < 0 < lacking.line.path.alpha
    one, other = (found.parts(TIMES[1:]).total for found in (whole, lacking))
    assert np.abs(one - other).max() <= 1e-7 * np.abs(one).max()
    assert (np.abs(one - other) <= (whole.error + lacking.error)[:, None] + 1e-12 * np.abs(one).max(1)[:, None]).all()


def test_before_the_loads_come_nothing_moves() -> None:
    whole = Engine(IMAGE, ACTING, (), searched(PROBLEM)).solve(TIMES)
    size = np.abs(whole.parts(TIMES[1:]).total).max(1)
    assert (np.abs(whole.moved(np.array([-50.0, -200.0]))) <= 1e-8 * size[:, None] + whole.error[:, None]).all()


def test_the_parts_do_not_hang_on_where_the_line_runs() -> None:
    """What is left to the integral is the same with the line above the axis."""
    poles = searched(PROBLEM)
    below = Engine(IMAGE, ACTING, (), poles).solve(TIMES)
    above = Engine(IMAGE, ACTING, (), replace(poles, complete=False)).solve(TIMES)
    assert above.line.path.alpha > 0
    for one, other in zip(vars(below.parts(TIMES[1:])).values(), vars(above.parts(TIMES[1:])).values(), strict=True):
        assert np.abs(one - other).max() <= 1e-7 * np.abs(below.parts(TIMES[1:]).total).max()
