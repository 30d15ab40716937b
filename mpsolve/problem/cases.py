"""The paper's cases as problems: `Case` in its dimensionless units, `PhysicalCase` in SI."""

from __future__ import annotations

from fractions import Fraction
from functools import singledispatch
from typing import Any

from mpsolve.errors import InputError
from mpsolve.model.parameters import Case, PhysicalCase
from mpsolve.numbers.exact import Exact
from mpsolve.problem.problem import Problem
from mpsolve.tracks.euler_bernoulli import EulerBernoulli
from mpsolve.vehicles.mass import Mass


@singledispatch
def as_problem(given: Any) -> Problem:
    """The problem that a Case, a PhysicalCase or a Problem stands for; InputError for all else."""
    raise InputError("problem", f"is of type {type(given).__name__}: give a Problem, a Case or a PhysicalCase")


@as_problem.register
def _(given: Problem) -> Problem:
    return given


@as_problem.register
def _(given: Case) -> Problem:
    """EI = 1/4, m = k = 1, c = 2 η_b, kp = η_S, N = η_N, masses η_M, v = α: then q is the paper's, and G = (2/π) K.

    InputError where a ratio is irrational, as those of a PhysicalCase often are.
    """
    eta_b, eta_s, eta_n, alpha = (_rational(getattr(given, key), key) for key in ("eta_b", "eta_s", "eta_n", "alpha"))
    track = EulerBernoulli(EI=Fraction(1, 4), m=1, k=1, c=2 * eta_b, kp=eta_s, N=eta_n)
    masses = [_rational(x, f"eta_m[{j}]") for j, x in enumerate(given.eta_m, 1)]
    places = [_rational(x, f"positions[{j}]") for j, x in enumerate(given.positions, 1)]
    return Problem(track, [Mass(mass).at(place) for mass, place in zip(masses, places, strict=True)], v=alpha)


@as_problem.register
def _(given: PhysicalCase) -> Problem:
    """The same beam and masses in SI: q is in rad/s."""
    track = EulerBernoulli(given.EI, given.m, given.k, given.c, given.kp, given.N)
    return Problem(track, [Mass(mass.M).at(mass.position) for mass in given.masses], v=given.v)


def _rational(value: Exact, key: str) -> Fraction:
    if not value.is_rational:
        stated = f"is {value.short()} = {value}, which is irrational"
        raise InputError(key, f"{stated}: give the PhysicalCase that it comes from, or a rational ratio")
    return value.as_fraction()
