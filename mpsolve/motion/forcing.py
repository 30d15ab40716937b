"""The forces of all masses as a sum of frequencies, and their Laplace image F_j(q), eq. (22)."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

from mpsolve.errors import known
from mpsolve.fields import Field
from mpsolve.numbers.exact import Exact
from mpsolve.problem.case import Case
from mpsolve.vehicles.load import Load


@dataclass(frozen=True)
class Tone:
    """The forces Re(a_j e^{iωτ}) on the masses (merged): `frequency` ω ≥ 0, `amplitudes` a_j."""

    frequency: Any
    amplitudes: tuple[Any, ...]
    exact: Exact  # ω


def tones(case: Case, loads: Sequence[Load], field: Field) -> tuple[Tone, ...]:
    """The loads by frequency, ω = 0 (the constant forces) first; loads of masses at one position are added.

    The amplitude of η_A sin(ωτ + φ) is η_A e^{i(φ − π/2)}, as in (2).
    """
    places = list(dict.fromkeys(case.positions))
    zero = field.number(Exact(0))
    found: dict[Exact, list[Any]] = {Exact(0): [zero] * len(places)}
    for place, load in zip(case.positions, loads, strict=True):
        k = places.index(place)
        found[Exact(0)][k] = found[Exact(0)][k] + field.number(load.constant)
        if not load.amplitude:
            continue
        turn = field.i * field.number(load.phase)
        wave, back = field.exp(turn), field.exp(-turn)
        size = field.number(load.amplitude)
        if not load.frequency:
            found[Exact(0)][k] = found[Exact(0)][k] + size * ((wave - back) / (2 * field.i)).real
            continue
        row = found.setdefault(abs(load.frequency), [zero] * len(places))
        row[k] = row[k] + size * (-field.i * wave if load.frequency.sign > 0 else field.i * back)
    return tuple(Tone(field.number(key), tuple(row), key) for key, row in found.items())


def image(parts: Sequence[Tone], field: Field, q: Any) -> list[Any]:
    """F_j(q) of (22), with the poles ±ω of a real force: F_j/4 is the Laplace image of the force at iq."""
    i, total = field.i, None
    for tone in parts:
        if tone.exact:
            ahead, back = 2 / (i * (q - tone.frequency)), 2 / (i * (q + tone.frequency))
            row = [a * ahead + _conjugate(a) * back for a in tone.amplitudes]
        else:
            row = [a * (4 / (i * q)) for a in tone.amplitudes]
        total = row if total is None else [u + v for u, v in zip(total, row, strict=True)]
    return known(total, "a part of the force")


def _conjugate(a: Any) -> Any:
    return a.conjugate()
