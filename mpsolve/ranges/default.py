"""The ranges that are looked at where none is given: they hold the problem's values and its wave speeds."""

from __future__ import annotations

from fractions import Fraction
from math import isqrt

from mpsolve.problem.problem import Problem
from mpsolve.waves.critical import CriticalVelocities, critical_velocities
from mpsolve.waves.speeds import wave_speeds

MASS_FACTORS = (Fraction(1, 5), Fraction(3))
"""Of all masses, on a chart."""
_BEYOND = Fraction(5, 4)
_PLACES = 10**6


def velocity_ranges(problem: Problem) -> tuple[tuple[Fraction, Fraction], ...]:
    """Ranges from 0, the second wider than the first; both hold the velocity and the least critical one.

    The last holds the wave speeds of the track too. The first may be all there is.
    """
    near = top_velocity(problem, critical_of(problem))
    speeds = [root_up(square) for square in wave_speeds(problem.track).values() if square > 0]
    far = rounded_up(max(speeds, default=Fraction(0)) * Fraction(21, 20))
    ends = (near,) if far <= near else (near, far)
    return tuple((Fraction(0), end) for end in ends)


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
