"""Ranges in which an undamped beam lets no passive vehicle grow: the theorem of one point (SPEC2, 8.8) over a box.

The bracket EI y² − (N − kp + m v²) y + k of `spectrum.lossless` falls as v grows, is linear in each other parameter
of the track and knows nothing of vehicles: at each y ≥ 0 it is least at a corner with the greatest v.
"""

from __future__ import annotations

from collections.abc import Mapping
from fractions import Fraction
from itertools import product
from typing import Any

from mpsolve.errors import InputError
from mpsolve.numbers.balls import rational_ball
from mpsolve.outcome import Reason
from mpsolve.problem.family import Interval
from mpsolve.problem.line import on_line
from mpsolve.problem.problem import Problem
from mpsolve.problem.reduced import reduce_problem
from mpsolve.spectrum.lossless import passive_everywhere
from mpsolve.tracks.euler_bernoulli import EulerBernoulli

NOTE = "the undamped beam takes up power at all frequencies and velocities of the range: no boxes are needed"
_OF_VEHICLES = ("vehicles", "gap[", "scale.", "eta_m", "d")
_SPEEDS = ("v", "alpha")


def never_unstable(problem: Problem, over: Mapping[str, Interval]) -> bool:
    """Whether nothing grows at any point of the ranges; False where the theorem does not tell."""
    free = {path: ends for path, ends in over.items() if path == "alpha" or not path.startswith(_OF_VEHICLES)}
    if any(None in ends for ends in free.values()):
        return False
    corners = [(max(map(abs, ends)),) if path in _SPEEDS else ends for path, ends in free.items()]
    return all(_passive_at(problem, dict(zip(free, corner, strict=True))) for corner in product(*corners))


def _passive_at(problem: Problem, point: Mapping[str, Fraction]) -> bool:
    try:
        for path, value in point.items():
            problem = problem.changed(path, value)
        line = on_line(reduce_problem(problem))
    except InputError:
        return False
    return line is not None and passive_everywhere(line)


def stable_up_to(problem: Problem, over: Mapping[str, Interval]) -> tuple[Reason, dict[str, Any]] | None:
    """Why a range of velocities is open, and the velocity up to which nothing grows, where it lies inside the range.

    That is √((2√(EI k) + kp − N)/m), at which the cuts join: a ball, in the unit of the path; None elsewhere.
    """
    ((path, (low, high)),) = over.items()
    track = problem.track
    if path not in _SPEEDS or not isinstance(track, EulerBernoulli) or track.c or track.eta or high is None:
        return None
    if low < 0 or not _passive_at(problem, {path: low}):
        return None
    unit = problem.changed(path, 1).v
    ball = (
        (2 * rational_ball(track.EI * track.k).sqrt() + rational_ball(track.kp - track.N)) / rational_ball(track.m)
    ).sqrt() / rational_ball(unit)
    stated = "without damping roots are real above the velocity at which the cuts join, and cross nothing there"
    remedy = "give the track some damping, or certify single velocities"
    return Reason("undamped", stated, {}, remedy), {"stable up to": ball}
