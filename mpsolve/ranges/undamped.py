"""Ranges over which a beam has no damping: what is known of them without boxes, for real roots are no rarity there.

*Where nothing grows.* The theorem of one point (SPEC2, 8.8) over a box: the bracket EI y² − (N − kp + m v²) y + k of
`spectrum.lossless` falls as v grows, is linear in each other parameter of the track and knows nothing of vehicles: at
each y ≥ 0 it is least at a corner with the greatest v. What grows beyond, under one mass, is told by `lone_mass`.
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

NOTE = (
    "the undamped beam takes up power at all frequencies and velocities of the range: roots may be real, but none "
    "grows; no boxes are needed"
)
SPEEDS = ("v", "alpha")
_OF_VEHICLES = ("vehicles", "gap[", "scale.", "eta_m", "d")


def never_unstable(problem: Problem, over: Mapping[str, Interval]) -> bool:
    """Whether nothing grows at any point of the ranges; False where the theorem does not tell."""
    free = {path: ends for path, ends in over.items() if not of_vehicles(path)}
    if any(None in ends for ends in free.values()):
        return False
    corners = [(max(map(abs, ends)),) if path in SPEEDS else ends for path, ends in free.items()]
    return all(passive_at(problem, dict(zip(free, corner, strict=True))) for corner in product(*corners))


def of_vehicles(path: str) -> bool:
    """Whether a path names something of vehicles."""
    return path.startswith(_OF_VEHICLES)


def at_corner(problem: Problem, point: Mapping[str, Fraction]) -> Problem:
    """The problem with these values, factors last."""
    for path, value in sorted(point.items(), key=lambda one: one[0].startswith("scale.")):
        problem = problem.changed(path, value)
    return problem


def passive_at(problem: Problem, point: Mapping[str, Fraction]) -> bool:
    """Whether nothing grows at a point, by the theorem."""
    try:
        line = on_line(reduce_problem(at_corner(problem, point)))
    except InputError:
        return False
    return line is not None and passive_everywhere(line)


def no_damping(problem: Problem, over: Mapping[str, Interval]) -> bool:
    """Whether the track is a beam without any damping, all over the ranges, that does not buckle by itself."""
    if not isinstance(problem.track, EulerBernoulli):
        return False
    for corner in product(*(tuple(x for x in ends if x is not None) for ends in over.values())):
        try:
            track: Any = at_corner(problem, dict(zip(over, corner, strict=True))).track
        except InputError:
            return False
        if track.c or track.eta or not track.k > 0 or not _held(track):
            return False
    return True


def _held(track: EulerBernoulli) -> bool:
    """EI y² + (kp − N) y + k > 0 for all y ≥ 0, exactly."""
    T = track.kp - track.N
    return bool(T >= 0 or 4 * track.EI * track.k > T * T)


def cuts_join(problem: Problem, path: str) -> Any:
    """√((2√(EI k) + kp − N)/m), at which the cuts of the undamped beam join: a ball, in the unit of the path."""
    track: Any = problem.track
    unit = problem.changed(path, 1).v
    square = (2 * rational_ball(track.EI * track.k).sqrt() + rational_ball(track.kp - track.N)) / rational_ball(
        track.m
    )
    return square.sqrt() / rational_ball(unit)


def left_open(problem: Problem, over: Mapping[str, Interval]) -> tuple[Reason, dict[str, Any]]:
    """Why ranges without damping are open, and the velocity up to which nothing grows, where it lies inside them."""
    stated = (
        "faster than its slowest wave an undamped beam has cuts on all of the real axis, where no crossing is sought"
    )
    reason = Reason("undamped", stated, {}, "give the track some damping, or certify single points")
    path, (low, high) = next(iter(over.items()))
    if len(over) > 1 or path not in SPEEDS or high is None or not passive_at(problem, {path: low}):
        return reason, {}
    return reason, {"stable up to": cuts_join(problem, path)}
