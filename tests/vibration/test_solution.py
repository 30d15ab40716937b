"""A motion of which nothing is known claims nothing."""

from __future__ import annotations

import numpy as np
from track_models import DAMPED
from vehicle_models import TYPICAL

from mpsolve import Problem
from mpsolve.outcome import Reason
from mpsolve.vibration.image import Image
from mpsolve.vibration.solution import unknown_parts, unknown_solution

PROBLEM = Problem(DAMPED["two-layer"], TYPICAL["bogie"], v=20)
IMAGE = Image(PROBLEM, PROBLEM.pencil.places)
TIMES = np.array([0.0, 1.0, 7.0])


def test_every_number_is_nan_and_every_error_infinite() -> None:
    why = Reason("effort", "it is spent")
    solution = unknown_solution(IMAGE, why)
    assert solution.reason == why
    assert np.isinf(solution.error).all()
    assert solution.error.shape == (IMAGE.channels,)
    for values in (solution.parts(TIMES).total, solution.rates(TIMES[1:]), unknown_parts(IMAGE, TIMES).total):
        assert values.shape[0] == IMAGE.channels
        assert np.isnan(values).all()
    parts = unknown_parts(IMAGE, TIMES)
    assert np.isnan([parts.static, parts.forced, parts.free, parts.transient]).all()
