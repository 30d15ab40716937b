"""What acts on a problem, as tones: Re(column · e^{iωt}) on the right of the transformed equations."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np

from mpsolve.errors import InputError
from mpsolve.vehicles.loads import Outer
from mpsolve.vibration.image import Image


@dataclass(frozen=True)
class Tone:
    """Re(column · e^{iωt̂}) from t = 0 on; frequency ω ≥ 0, scaled; column (bodies + contacts,), complex."""

    frequency: float
    column: Any


@dataclass(frozen=True)
class Irregularity:
    """amplitude · sin(frequency · t + phase) of the wheel and rail at one contact, compressing it where positive.

    In units of the problem (m, rad/s, rad). It begins at t = 0 from where it then is: amplitude · sin(phase) is no
    compression.
    """

    amplitude: float
    frequency: float
    phase: float = 0.0


def checked_irregularities(given: Any, contacts: int) -> tuple[Irregularity, ...]:
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

    def add(frequency: float, column: Any) -> None:
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


def _add_wave(add: Any, column: Any, frequency: float, phase: float) -> None:
    """sin(ωt + φ) = Re(−i e^{iφ} e^{iωt}); ω < 0 by turning the sine."""
    if not frequency:
        add(0.0, np.sin(phase) * column + 0j)
    elif frequency > 0:
        add(frequency, -1j * np.exp(1j * phase) * column)
    else:
        add(-frequency, 1j * np.exp(-1j * phase) * column)


def transform(acting: tuple[Tone, ...], sigma: Any, rows: int) -> Any:
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
