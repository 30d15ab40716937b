"""A case of the paper as a problem in rational numbers: a PhysicalCase in SI, a Case in its own units."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from fractions import Fraction
from typing import Any

import numpy as np

from mpsolve.numbers.arrays import Reals
from mpsolve.numbers.exact import Exact
from mpsolve.problem.case import Case
from mpsolve.problem.cases import as_problem
from mpsolve.problem.physical import PhysicalCase
from mpsolve.problem.problem import Problem
from mpsolve.tracks.euler_bernoulli import EulerBernoulli
from mpsolve.vehicles.load import Load
from mpsolve.vehicles.mass import Mass


@dataclass(frozen=True)
class CaseUnits:
    """The case `given`, in ratios and as a problem with τ = rate · t, ξ = chi · x; w_st: of a unit force, there."""

    given: Case | PhysicalCase
    case: Case
    problem: Problem
    rate: Exact
    chi: Exact
    w_st: Exact

    def loads(self, loads: Iterable[Load], times: Exact | int = 1) -> list[Load]:
        """In the units of the problem, so many times."""
        return [
            Load(times * one.constant, times * one.amplitude, self.rate * one.frequency, one.phase) for one in loads
        ]

    def places(self, xi: Reals) -> Reals:
        """x of these ξ in float64."""
        return np.asarray(xi, float) / float(self.chi)

    def times(self, tau: Any) -> Any:
        """t of these τ in float64."""
        return np.asarray(tau, float) / float(self.rate)


def units_of(given: Case | PhysicalCase, exact: bool = False) -> CaseUnits:
    """Irrational ratios of a Case are taken to float64, or refused with an InputError where they must be exact."""
    if isinstance(given, PhysicalCase):
        w_st = given.chi / (2 * given.k)
        return CaseUnits(given, given.dimensionless, as_problem(given), given.time_scale, given.chi, w_st)
    problem = as_problem(given) if exact else _beam(given)
    return CaseUnits(given, given, problem, Exact(1), Exact(1), Exact("0.5"))


def _beam(case: Case) -> Problem:
    """EI = 1/4, m = k = 1, c = 2 η_b, kp = η_S, N = η_N, masses η_M, v = α; irrational ratios as float64 has them."""
    eta_b, eta_s, eta_n, alpha = (rounded(getattr(case, key)) for key in ("eta_b", "eta_s", "eta_n", "alpha"))
    track = EulerBernoulli(EI=Fraction(1, 4), m=1, k=1, c=2 * eta_b, kp=eta_s, N=eta_n)
    masses = zip(case.eta_m, case.positions, strict=True)
    return Problem(track, [Mass(rounded(mass)).at(rounded(place)) for mass, place in masses], v=alpha)


def rounded(value: Exact) -> Fraction:
    """The number itself if it is rational, else as float64 has it."""
    return value.as_fraction() if value.is_rational else Fraction(float(value))


@dataclass(frozen=True)
class Scale:
    """What one unit of τ, of w and of force is in the units that are shown, and their names."""

    time: float = 1.0
    length: float = 1.0
    force: float = 1.0
    time_name: str = "τ"
    length_name: str = "w/w_st"
    force_name: str = "1"

    @classmethod
    def of(cls, physical: PhysicalCase | None) -> Scale:
        """In s, mm and kN for loads in units of 1 N: τ = √(k/m) t of (10), w_st = χ/(2k) · 1 N of (13)."""
        if physical is None:
            return cls()
        static = float(physical.chi) / (2 * float(physical.k))
        return cls(1 / float(physical.time_scale), 1e3 * static, 1e-3, "s", "mm", "kN")

    @property
    def physical(self) -> bool:
        """Whether the units are those of a physical case."""
        return self.time_name == "s"

    @property
    def length_unit(self) -> str:
        """Of displacements."""
        return self.length_name if self.physical else "w_st"

    @property
    def said(self) -> str:
        """The units in words."""
        if self.physical:
            return "times in s, displacements in mm, forces in kN"
        return "τ = √(k/m) t, ξ = χ x, displacements in units of w_st = χ/(2k) · unit force, forces in unit forces"
