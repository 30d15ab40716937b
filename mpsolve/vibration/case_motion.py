"""What a computed motion is: its parts in arrays."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field
from functools import cached_property
from typing import Any

import numpy as np

from mpsolve.display import card
from mpsolve.numbers.arrays import Complexes, Reals, Truths
from mpsolve.outcome import Reason
from mpsolve.problem.case import Case
from mpsolve.vehicles.load import Load
from mpsolve.vibration.liftoff import Event
from mpsolve.vibration.motion import Vibration


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
