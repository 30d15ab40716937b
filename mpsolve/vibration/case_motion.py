"""A case of the paper as a problem in rational numbers, a PhysicalCase in SI, a Case in its own units; its motion."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass, field
from fractions import Fraction
from functools import cached_property
from typing import Any

import numpy as np

from mpsolve.display import card
from mpsolve.numbers.arrays import Complexes, Reals, Truths
from mpsolve.numbers.exact import Exact
from mpsolve.outcome import Reason
from mpsolve.problem.case import Case
from mpsolve.problem.cases import as_problem
from mpsolve.problem.physical import PhysicalCase
from mpsolve.problem.problem import Problem
from mpsolve.tracks.euler_bernoulli import EulerBernoulli
from mpsolve.vehicles.load import Load
from mpsolve.vehicles.mass import Mass
from mpsolve.vibration.liftoff import Event
from mpsolve.vibration.motion import Vibration


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


@dataclass(frozen=True)
class HarmonicPair:
    """A pair q, −q̄ of induced frequencies and what it contributes, Re(amplitude(ξ) e^{iqτ}).

    q: complex, Re q ≥ 0 (Re q = 0: a single frequency). amplitude: complex, shape (len(xi),). contribution: shape
    (len(xi), len(tau)).
    """

    q: complex
    multiplicity: int
    amplitude: Complexes
    contribution: Reals


def modulus(pairs: Sequence[tuple[complex, Complexes]], tau: Reals) -> Any:
    """|Σ amplitude e^{iqτ}|, shape (len(amplitude), len(tau))."""
    return np.abs(sum(np.multiply.outer(np.asarray(a), np.exp(1j * q * tau)) for q, a in pairs))


@dataclass(frozen=True)
class Response:
    """The motion from rest: w = steady + harmonic + transient, each of shape (len(xi), len(tau)); float64 results.

    Displacements in units of w_st = χ/(2k) times the unit force of the loads, downward positive; τ and ξ of (10).
    steady_harmonic: the part of `steady` at the frequencies of the forces. harmonic_pairs: `harmonic` by pairs of
    induced frequencies. velocity, acceleration: of the contact points, shape (masses, len(tau)). contact_forces:
    P_j(τ) − M_j ẅ of (2), same shape, in units of the unit force, compression positive. contact_loss: for each mass
    the first time at which its contact force falls below zero, linear between the given times, or None; contact_note
    says why it is not known, or only that it is earlier ("" if it is known). error: an estimate, relative to the
    largest of the parts. reason: why less is known than was asked for, then NaN where nothing is. motion: the general
    response that all of it is taken from.
    """

    case: Case
    loads: tuple[Load, ...]
    xi: Reals
    tau: Reals
    steady: Any
    steady_harmonic: Reals
    harmonic: Reals
    transient: Reals
    harmonic_pairs: tuple[HarmonicPair, ...]
    velocity: Reals
    acceleration: Reals
    contact_forces: Reals
    contact_loss: tuple[float | None, ...]
    contact_note: tuple[str, ...]
    error: float
    reason: Reason | None = None
    motion: Vibration | None = field(default=None, repr=False, compare=False)

    @cached_property
    def lift_off(self) -> Event | None:
        """When a contact force first comes to 0, up to the last τ, and of which mass; then the model does not hold.

        It is found on the motion itself, whatever the times; of masses at one place, or without `motion`, it is only
        the first loss between the given times, off by as much as the longest step.
        """
        if self.motion is None or self.motion.reason is not None or len(set(self.case.positions)) < len(self.loads):
            lost = [(time, j) for j, time in enumerate(self.contact_loss, 1) if time is not None]
            step = float(np.max(np.diff(np.sort(self.tau), prepend=0.0), initial=0.0))
            return Event(*min(lost), step) if lost else None
        event = self.motion.lift_off
        if event is None:
            return None
        unit = float(self.tau.max() / self.motion.times.max())
        return Event(event.time * unit, event.contact, event.tolerance * unit)

    @property
    def within(self) -> Truths:
        """Which times are within the model: before the first lift-off, (len(tau),) of booleans."""
        return np.full(len(self.tau), True) if self.lift_off is None else self.tau <= self.lift_off.time

    @property
    def w(self) -> Any:
        """steady + harmonic + transient, shape (len(xi), len(tau)), in units of w_st."""
        return self.steady + self.harmonic + self.transient

    @property
    def envelope(self) -> Any:
        """The bound of the unsteady harmonic part, Figures 3–8, shape (len(xi), len(tau))."""
        pairs = [(pair.q, pair.amplitude) for pair in self.harmonic_pairs]
        return modulus(pairs, self.tau) if pairs else np.zeros((len(self.xi), len(self.tau)))

    def _repr_html_(self) -> str:
        """What a notebook shows."""
        return card(self)
