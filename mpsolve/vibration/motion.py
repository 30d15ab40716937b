"""What a computed motion is, in the units of the problem, in floats or to many digits."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass, field
from fractions import Fraction
from functools import cached_property
from typing import Any

import numpy as np

from mpsolve.errors import EffortError
from mpsolve.numbers.arrays import Complexes, Reals, Truths
from mpsolve.outcome import Reason
from mpsolve.problem.problem import Problem
from mpsolve.vibration.image import Image
from mpsolve.vibration.liftoff import Event, early_times, first_lift_off, unjudged
from mpsolve.vibration.rows import Rows
from mpsolve.vibration.solution import Parts, Solution


@dataclass(frozen=True)
class MotionError:
    """Estimates of the largest errors over all places, coordinates, contacts and times; vehicle by coordinates."""

    rail: float
    vehicle: dict[str, float]
    contact_force: float


@dataclass(frozen=True)
class InducedPart:
    """What a pair of induced frequencies q, −q̄ contributes: Re(amplitude e^{iqt}), q in the problem's units.

    rail (places,), contact_force (contacts,), complex; vehicle by coordinates. For a multiple root: of its leading
    term in time.
    """

    q: complex
    multiplicity: int
    rail: Complexes
    vehicle: dict[str, complex]
    contact_force: Complexes


@dataclass(frozen=True)
class Vibration(Rows):
    """The motion of a problem: float64, errors estimated, not proved; lengths down, forces and times in its units.

    times (t,). places (p,). rail (p, t): deflections under places of the moving frame, the sum of `steady` (with its
    part `steady_harmonic` at the frequencies of loads and irregularities), `harmonic` (at induced frequencies) and
    `transient`. vehicle: for each coordinate by name (t,). contact_force (n, t): from rear to front, compression
    positive, with the static part. induced: the harmonic part by frequencies. reason: why less is known than was
    asked for, where effort ran out: `error` tells of the motion as it is, and what is not known is NaN.
    """

    problem: Problem
    times: Any
    places: Reals
    rail: Reals
    steady: Any
    steady_harmonic: Reals
    harmonic: Reals
    transient: Reals
    vehicle: dict[str, Reals]
    contact_force: Reals
    error: MotionError
    solution: Solution = field(repr=False)
    solve: Callable[[Any], Solution] = field(repr=False, compare=False)

    @property
    def rail_error(self) -> float:
        """The estimated error of the deflections of the rail."""
        return self.error.rail

    @cached_property
    def lift_off(self) -> Event | None:
        """When a contact force first comes to 0, up to the last time; None where none does, `unjudged` left out.

        It is found on the motion itself and does not depend on the times asked for, but for the last one. EffortError
        where no motion is known, as the effort ran out.
        """
        if self.reason is not None and not np.isfinite(self.error.contact_force):
            raise EffortError(self.reason)
        last = float(np.max(self.times, initial=0.0))
        early = early_times(self.solution, last * self.solution.image.rate)
        return first_lift_off(self.solve(early) if len(early) else self.solution, last)

    @property
    def unjudged(self) -> tuple[int, ...]:
        """Contacts that no constant force presses, counted from the rear, from 1: whether they are kept is open."""
        return unjudged(self.solution)

    @property
    def reason(self) -> Reason | None:
        """None where all was worked for that was asked for."""
        return self.solution.reason

    @property
    def within(self) -> Truths:
        """Which times are within the model: before the first lift-off, (t,) of booleans."""
        event = self.lift_off
        return np.full(len(self.times), True) if event is None else self.times <= event.time

    @property
    def induced(self) -> tuple[InducedPart, ...]:
        """The harmonic part by pairs of induced frequencies."""
        image = self.solution.image
        out = []
        for mode in self.solution.modes:
            row = (2.0 if mode.sigma.imag > 0 else 1.0) * mode.moments[-1]
            bodies, force, rail = split(image, row)
            names = dict(zip(image.pencil.names, bodies.tolist(), strict=True))
            out.append(InducedPart(-1j * mode.sigma * image.rate, mode.multiplicity, rail, names, force))
        return tuple(out)


def split(image: Image, rows: Any) -> tuple[Any, Any, Any]:
    """Rows of channels as bodies, contact forces and rail."""
    n, m = image.size, image.contacts
    return rows[:n], rows[n : n + m], rows[n + m :]


def fields_of(image: Any, total: Any, **parts: Any) -> dict[str, Any]:
    """What every motion has, from rows of channels: the whole of all of them, parts of the rail by their names."""
    bodies, force, rail = split(image, total)
    own = {name: split(image, rows)[2] for name, rows in parts.items()}
    return {"rail": rail, "vehicle": dict(zip(image.pencil.names, bodies, strict=True)), "contact_force": force} | own


def vibration(
    problem: Problem, solution: Solution, times: Any, parts: Parts, solve: Callable[[Any], Solution]
) -> Vibration:
    """The solution read at these times, in the problem's units."""
    image = solution.image
    bodies, force, rail = split(image, solution.error)
    largest = MotionError(
        float(np.max(rail, initial=0.0)),
        dict(zip(image.pencil.names, bodies.tolist(), strict=True)),
        float(force.max()),
    )
    rows = fields_of(
        image, parts.total, steady=parts.static + parts.forced, steady_harmonic=parts.forced, harmonic=parts.free,
        transient=parts.transient,
    )  # fmt: skip
    places = np.array(image.places, float)
    return Vibration(problem, times, places, **rows, error=largest, solution=solution, solve=solve)


@dataclass(frozen=True)
class PreciseVibration:
    """The motion from rest in arrays of mpmath numbers (dtype object), in the units of the problem; not proved.

    rail (places, times), the sum of steady, harmonic and transient; vehicle by coordinates; contact_force (n, times).
    error: of the rail and of the forces, relative to the largest of each, by causality and a lower Ω; an estimate.
    reason: where effort ran out, all numbers are NaN and the errors infinite; or that the digits are not reached.
    """

    times: Any
    places: tuple[Fraction, ...]
    rail: Any
    steady: Any
    harmonic: Any
    transient: Any
    vehicle: dict[str, Any]
    contact_force: Any
    error: tuple[float, float]
    reason: Reason | None = None


def unknown_precise(image: Image, mp: Any, times: tuple[Fraction, ...], reason: Reason) -> PreciseVibration:
    """Of which nothing is known."""
    rows = np.full((image.channels, len(times)), mp.nan, object)
    known = fields_of(image, rows, steady=rows, harmonic=rows, transient=rows)
    return PreciseVibration(times, image.places, **known, error=(math.inf, math.inf), reason=reason)
