"""A motion of which nothing is known claims nothing."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
from track_models import DAMPED
from vehicle_models import TYPICAL

from mpsolve import Problem, response
from mpsolve.outcome import Reason
from mpsolve.vibration.image import Image
from mpsolve.vibration.path import Path
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


def test_the_motion_never_swings_further_than_is_told() -> None:
    solution = response(PROBLEM, times=[0, 2.0]).solution
    static = sum(one.amplitude.real for one in solution.steady) + solution.held
    later = np.geomspace(1e-2, 2.0, 400) * IMAGE.rate
    away = np.abs(solution.moved(later) + (solution.held - static)[:, None])
    told = np.array([solution.swing(time) for time in later]).T
    assert (away <= told + 1e-6 * np.abs(static)[:, None]).all()
    assert (np.diff(told, axis=1) <= 0).all()
    assert (told[:, -1] < 0.5 * np.abs(static) + 1e-9).sum() > IMAGE.channels / 2
    bare = replace(solution, line=replace(solution.line, path=Path(0.1)))
    assert np.isinf(bare.swing(10.0)).all()
