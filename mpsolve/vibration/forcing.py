"""What acts on a problem, as tones Re(column · e^{iωt}), irregularities of rail and wheels too; what they keep up."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from math import comb, pi
from typing import Any

import numpy as np

from mpsolve.errors import InputError
from mpsolve.numbers.arrays import Complexes, Reals
from mpsolve.numbers.model import rational, shown, whole
from mpsolve.problem.problem import Problem
from mpsolve.vehicles.loads import Outer
from mpsolve.vibration.image import Image

_STEP = 1e-3
"""Scaled: from where limits at 0 are extrapolated."""
_SAME = 1e-9
_SINGULAR = 1e-13
"""The least singular value, of a matrix with rows and columns of size 1, that is told from 0."""


@dataclass(frozen=True)
class Tone:
    """Re(column · e^{iωt̂}) from t = 0 on; frequency ω ≥ 0, scaled; column (bodies + contacts,), complex."""

    frequency: float
    column: Complexes


@dataclass(frozen=True)
class Irregularity:
    """amplitude · sin(frequency · t + phase) of the wheel and rail at one contact, compressing it where positive.

    In units of the problem (m, rad/s, rad). It begins at t = 0 from where it then is: amplitude · sin(phase) is no
    compression.
    """

    amplitude: float
    frequency: float
    phase: float = 0.0


def checked_irregularities(given: Sequence[Irregularity] | None, contacts: int) -> tuple[Irregularity, ...]:
    """One for each contact, or none at all; InputError otherwise."""
    if given is None:
        return ()
    found = tuple(given)
    if len(found) != contacts or not all(isinstance(one, Irregularity) for one in found):
        raise InputError(
            "irregularities", f"are no {contacts} Irregularity: give one for each contact, rear to front"
        )
    return found


def tones(image: Image, outer: Outer, irregularities: tuple[Irregularity, ...]) -> tuple[Tone, ...]:
    """Constant first, then by ascending frequency; none that is 0."""
    zero = np.zeros(image.contacts)
    columns: dict[float, Any] = {}

    def add(frequency: float, column: Complexes) -> None:
        if np.any(column):
            columns[frequency] = columns.get(frequency, 0) + column

    for k in range(len(outer.constant)):
        force = image.column(outer.direction[:, k], zero)
        add(0.0, outer.constant[k] * force + 0j)
        _add_wave(add, outer.amplitude[k] * force, outer.frequency[k] / image.rate, outer.phase[k])
    for j, one in enumerate(irregularities):
        unit = np.where(np.arange(image.contacts) == j, one.amplitude, 0.0)
        column = image.column(np.zeros(image.size), unit)
        _add_wave(add, column, one.frequency / image.rate, one.phase)
        add(0.0, -np.sin(one.phase) * column + 0j)
    return tuple(Tone(frequency, columns[frequency]) for frequency in sorted(columns))


def _add_wave(add: Any, column: Reals, frequency: float, phase: float) -> None:
    """sin(ωt + φ) = Re(−i e^{iφ} e^{iωt}); ω < 0 by turning the sine."""
    if not frequency:
        add(0.0, np.sin(phase) * column + 0j)
    elif frequency > 0:
        add(frequency, -1j * np.exp(1j * phase) * column)
    else:
        add(-frequency, 1j * np.exp(-1j * phase) * column)


def transform(acting: tuple[Tone, ...], sigma: Any, rows: int) -> Complexes:
    """The sum of their Laplace transforms, (len(σ), rows), rows = bodies + contacts."""
    total = np.zeros((len(sigma), rows), complex)
    for tone in acting:
        D, turn = tone.column, 1j * tone.frequency
        if tone.frequency:
            one, other = 0.5 / (sigma - turn), 0.5 / (sigma + turn)
            total = total + one[:, None] * D + other[:, None] * D.conj()
        else:
            total = total + (1 / sigma)[:, None] * D.real
    return total


@dataclass(frozen=True)
class Forced:
    """Re(amplitude e^{iωt}); amplitude (channels,)."""

    frequency: float
    amplitude: Complexes

    def motion(self, times: Any) -> Any:
        """(channels, times)."""
        return (self.amplitude[:, None] * np.exp(1j * self.frequency * times)).real

    def rate(self, times: Any) -> Any:
        """d/dt of it."""
        return (1j * self.frequency * self.amplitude[:, None] * np.exp(1j * self.frequency * times)).real


def forced(image: Image, tone: Tone) -> Forced:
    """InputError where the frequency is an induced one, so that the motion has no bound."""
    at = np.array([1j * tone.frequency])
    amplitude, clear = np.full(1, np.nan), False
    with np.errstate(all="ignore"):
        A = image.matrices(at)[0][0]
        if np.isfinite(A).all():
            clear = float(np.linalg.svd(_even(A), compute_uv=False)[-1]) > _SINGULAR
            amplitude = image.solve(at, tone.column[None])[0] if clear else amplitude
        elif not tone.frequency:
            amplitude, clear = _limit(image, tone)
    if not clear or not np.isfinite(amplitude).all():
        said = f"act at {tone.frequency * image.rate:.6g} rad/s" if tone.frequency else "are constant"
        stated = f"{said}, a frequency at which vehicle and track move by themselves: the motion grows without end"
        raise InputError("loads", f"{stated}; change the frequency, or hold what moves by itself")
    return Forced(tone.frequency, amplitude if tone.frequency else amplitude.real + 0j)


def _limit(image: Image, tone: Tone) -> tuple[Reals, bool]:
    """The amplitude as σ → 0 from the right, where p-roots meet common zeros of N and D; and whether there is one."""
    values = image.solve(_STEP * np.arange(1.0, 9.0), np.broadcast_to(tone.column, (8, len(tone.column)))).real
    best, fewer = (_extrapolated(values[:n]) for n in (8, 7))
    return best, bool(np.abs(best - fewer).max() <= _SAME * np.abs(best).max())


def _extrapolated(values: Any) -> Any:
    """To 0 from 1, 2, …: the polynomial through all."""
    n = len(values)
    weights = np.array([(-1.0) ** k * comb(n, k + 1) for k in range(n)])
    return weights @ values


def _even(A: Complexes) -> Any:
    """Rows and columns brought to the size 1."""
    A = A / np.maximum(np.abs(A).max(1, keepdims=True), 1e-300)
    return A / np.maximum(np.abs(A).max(0, keepdims=True), 1e-300)


def rail_roughness(problem: Problem, amplitude: Any, wavelength: Any, phase: float = 0.0) -> tuple[Irregularity, ...]:
    """A wave on the rail, amplitude · sin(2πx/wavelength + phase) upwards, as every contact runs over it.

    Contacts meet it one after the other: that at ξ sees 2π(vt + ξ)/wavelength + phase.
    amplitude, wavelength: in m, or texts with units.

    >>> from mpsolve import tracks, vehicles
    >>> pair = Problem(tracks.String(T=1, m=1, k=1, c=1), vehicles.train(vehicles.Mass(1), 2, "0.5"), v=3)
    >>> [round(one.phase, 3) for one in rail_roughness(pair, "1e-5", 2)]
    [0.0, 1.571]
    """
    size, length = _small(amplitude, wavelength, "wavelength")
    turn = 2 * pi / length
    omega = turn * float(problem.v)
    return tuple(Irregularity(size, omega, turn * float(x) + phase) for x in problem.pencil.places)


def out_of_round(
    problem: Problem, amplitude: Any, radius: Any, order: int = 1, contact: int | None = None
) -> tuple[Irregularity, ...]:
    """Wheels of this radius whose tread swells and shrinks `order` times a turn, amplitude · sin(order · v t/radius).

    contact: the only one whose wheel is so, counted from 1 at the rear; without it all are.
    amplitude, radius: in m, or texts with units.
    """
    size, length = _small(amplitude, radius, "radius")
    count = problem.pencil.contacts
    if isinstance(order, bool) or not isinstance(order, int) or order < 1:
        raise InputError("order", f"is {order!r}: give a whole number from 1 on")
    if contact is not None:
        contact = whole(contact, "contact", 1, count)
    omega = order * float(problem.v) / length
    return tuple(Irregularity(size if contact in (None, j) else 0.0, omega) for j in range(1, count + 1))


def _small(amplitude: Any, length: Any, key: str) -> tuple[float, float]:
    """Both in m; InputError where the length is none, or the amplitude is no small part of it."""
    size = float(rational(amplitude, "amplitude", "m", "amplitude"))
    exact = rational(length, key, "m", key)
    number = float(exact)
    if number <= 0:
        raise InputError(key, f"is {shown(exact, length)}, not above 0: give a length in m")
    if abs(size) > number:
        raise InputError(
            "amplitude", f"is {size:g} m beside a {key} of {number:g} m: write '{size:g} µm', if that is meant"
        )
    return size, number
