"""The ranges that are looked at where none is given: they hold the problem's values and its wave speeds."""

from __future__ import annotations

from dataclasses import dataclass
from fractions import Fraction
from math import isqrt

from mpsolve.problem.family import Interval
from mpsolve.problem.problem import Problem
from mpsolve.waves.critical import critical_velocities
from mpsolve.waves.speeds import wave_speeds
from mpsolve.waves.velocity import CriticalVelocities

MASS_FACTORS = (Fraction(1, 5), Fraction(3))
"""Of all masses, on a chart."""
_BEYOND = Fraction(5, 4)
_FAR = Fraction(21, 20)
_OFF = Fraction(1, 100)  # of a wave speed: how far off it is looked
_PLACES = 10**6


@dataclass(frozen=True)
class Velocities:
    """Ranges of velocities in ascending order: near ones hold the velocity and the least critical one, far ones go
    on beyond the wave speeds. Wave speeds are left out with a neighbourhood: nothing can be proved across them.

    steps: the same as near and far together, parted at twice the velocity, as faster ones may take long.
    """

    near: tuple[Interval, ...]
    far: tuple[Interval, ...] = ()
    steps: tuple[Interval, ...] = ()


def velocity_ranges(problem: Problem) -> Velocities:
    """From 0 on; the file's own velocity lies in a near range unless it is next to a wave speed."""
    top = top_velocity(problem, critical_of(problem))
    speeds = sorted(root_up(square) for square in wave_speeds(problem.track).values() if square > 0)
    far = rounded_up(max(speeds, default=Fraction(0)) * _FAR)
    slow = min(rounded_up(2 * problem.v), top) if problem.v else top
    beyond = _between(top, far, speeds) if far > top else ()
    steps = _between(Fraction(0), slow, speeds) + _between(slow, top, speeds) + beyond
    return Velocities(_between(Fraction(0), top, speeds), beyond, steps)


def gap_range(problem: Problem) -> Interval | None:
    """From half to twice the distance of the first two vehicles; None where there is one, or they share a place."""
    own = problem.parameters.get("gap[0]")
    return (own / 2, own * 2) if own else None


def _between(low: Fraction, high: Fraction, speeds: list[Fraction]) -> tuple[Interval, ...]:
    """The parts of a range off the wave speeds."""
    out, start = [], low
    for speed in speeds:
        before, after = speed * (1 - _OFF), speed * (1 + _OFF)
        if after <= start or before >= high:
            continue
        if before > start:
            out.append((start, before))
        start = after
    return (*out, (start, high)) if start < high else tuple(out)


def top_velocity(problem: Problem, critical: CriticalVelocities | None) -> Fraction:
    """Twice the velocity, and past the least critical velocity, in round numbers."""
    wanted = 2 * problem.v
    if critical is not None and len(critical):
        wanted = max(wanted, Fraction(float(critical.velocities[0].value.mid())) * _BEYOND)
    return rounded_up(wanted or Fraction(100))


def critical_of(problem: Problem) -> CriticalVelocities:
    """The critical velocities of a constant force, over a range that holds the velocity itself."""
    reach = max(problem.v * 4, Fraction(1))
    for _ in range(8):
        found = critical_velocities(problem.track, over={"v": (0, reach)})
        if len(found):
            return found
        reach *= 4
    return found


def rounded_up(x: Fraction) -> Fraction:
    """The next number with two figures."""
    step = Fraction(10) ** (len(str(int(x))) - 2) if x >= 1 else Fraction(1, 100)
    return -(-x // step) * step


def root_up(square: Fraction) -> Fraction:
    """A rational at or above the square root, within a millionth."""
    return Fraction(isqrt(-(-square * _PLACES**2 // 1)) + 1, _PLACES)
