"""A pair of masses over velocity and mass, on which the parts of a chart are tested."""

from __future__ import annotations

from fractions import Fraction

from mpsolve import Problem, tracks, vehicles

PAIR = Problem(
    tracks.EulerBernoulli(EI="1/4", m=1, k=1, c="0.4"), vehicles.train(vehicles.Mass(40), 2, "1.5"), v="0.7"
)
OVER = {"v": (Fraction(3, 5), Fraction(9, 10)), "scale.mass": (Fraction(1, 2), Fraction(2))}
