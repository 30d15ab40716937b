"""The paper's cases as problems: `Case` in its dimensionless units, `PhysicalCase` in SI."""

from __future__ import annotations

from fractions import Fraction
from functools import singledispatch
from typing import Any, TypeAlias

from mpsolve.errors import InputError
from mpsolve.numbers.exact import Exact
from mpsolve.numbers.model import rational
from mpsolve.numbers.units import split
from mpsolve.numbers.written import Measured
from mpsolve.problem.case import Case
from mpsolve.problem.physical import PhysicalCase
from mpsolve.problem.problem import Problem
from mpsolve.tracks.euler_bernoulli import EulerBernoulli
from mpsolve.vehicles.mass import Mass

Given: TypeAlias = Problem | Case | PhysicalCase
"""What a question may be about."""


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


def value_at(given: Given, path: str, value: object, key: str = "") -> Fraction:
    """A value of the parameter at `path`; a text may have a unit of its own, but for the ratios of a Case.

    InputError, under `key` or the path, where it is none, and where there is no such parameter.
    """
    asked = as_problem(given).quantity(path)
    if not isinstance(given, Case):
        return asked.end(value, key or path)
    refuse_units(value, key or path)
    return rational(value, key or path)


def refuse_units(value: object, key: str) -> None:
    """InputError for a text with a unit, where a Case is asked about."""
    text = value.text if isinstance(value, Measured) else value
    if isinstance(text, str) and split(text)[1]:
        raise InputError(key, f"is {text!r}, but a Case holds the paper's ratios: give a number alone")


def as_paper(given: Given) -> Case | PhysicalCase | None:
    """The paper's case that this is, in the same units; None for another track, other vehicles, or no stiffness k."""
    if isinstance(given, (Case, PhysicalCase)):
        return given
    track = given.track
    if not isinstance(track, EulerBernoulli) or track.eta or not track.k:
        return None
    masses = [(one.vehicle.M, one.position) for one in given.vehicles if isinstance(one.vehicle, Mass)]
    if len(masses) < len(given.vehicles):
        return None
    masses.sort(key=lambda mass: mass[1])
    return PhysicalCase(
        EI=track.EI, m=track.m, k=track.k, c=track.c, kp=track.kp, N=track.N, v=given.v, masses=masses
    )


def _rational(value: Exact, key: str) -> Fraction:
    if not value.is_rational:
        stated = f"is {value.short()} = {value}, which is irrational"
        raise InputError(key, f"{stated}: give the PhysicalCase that it comes from, or a rational ratio")
    return value.as_fraction()
