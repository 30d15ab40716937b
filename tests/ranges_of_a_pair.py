"""A pair of masses over velocity, for the tests of what a range is proved from."""

from __future__ import annotations

from fractions import Fraction
from functools import cache

from mpsolve import Problem, certify, tracks, vehicles
from mpsolve.ranges.scope import Scope, scope_of

TRACK = tracks.EulerBernoulli(EI="6.4e6", m=60, k="1e6", c=770)
PAIR = Problem(TRACK, vehicles.train(vehicles.Mass(10000), 2, "3.4"), v=100)


@cache
def over_velocity() -> Scope:
    return scope_of(PAIR, {"v": (Fraction(150), Fraction(230))})


@cache
def over_velocity_and_mass() -> Scope:
    return scope_of(PAIR, {"v": (Fraction(150), Fraction(230)), "scale.mass": (Fraction(9, 10), Fraction(11, 10))})


@cache
def lowest(v: Fraction) -> complex:
    """The certified lowest root with Re q > 0, in rad/s."""
    roots = certify(PAIR.changed("v", v), region=("below", 4), check=False).roots
    q = min((complex(root.q) for root in roots), key=lambda q: q.imag)
    return complex(abs(q.real), q.imag)
