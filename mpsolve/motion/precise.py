"""The steady and the unsteady harmonic part to any number of digits, in mpmath."""

from __future__ import annotations

import math
from collections.abc import Iterable
from typing import Any

import numpy as np

from mpsolve.certificate.on_sheet import AnySpectrum
from mpsolve.errors import InputError
from mpsolve.fields import MP
from mpsolve.model.branch import Track, track
from mpsolve.model.kernel import AHEAD, BEHIND, kernel
from mpsolve.model.load import Load, loads_of
from mpsolve.model.parameters import Case, PhysicalCase
from mpsolve.motion.certified import proved_spectrum
from mpsolve.motion.solution import HarmonicPair, HarmonicSolution
from mpsolve.motion.waves import Wave, induced_waves, steady_waves
from mpsolve.numbers.exact import Number, exact_list

_GUARD = 10  # digits beyond those asked for, in the roots and the arithmetic
MOST = 1000


def precise_harmonic(
    case: Case | PhysicalCase,
    loads: Iterable[Load] | None,
    xi: Iterable[Number] | Number | None,
    tau: Iterable[Number] | Number,
    spectrum: AnySpectrum | None,
    digits: int,
) -> HarmonicSolution:
    """As `harmonic_solution`, in arrays of mpmath numbers that are rounded to `digits` digits."""
    if not (isinstance(digits, int) and 15 <= digits <= MOST):
        raise InputError("digits", f"is {digits!r}: give a whole number from 15 to {MOST}")
    forces = loads_of(case, loads)
    whole = case.dimensionless if isinstance(case, PhysicalCase) else case
    spectrum = proved_spectrum(whole, spectrum, digits + _GUARD)
    if spectrum.digits < digits + _GUARD:
        raise InputError("spectrum", f"has {spectrum.digits} digits: certify with at least {digits + _GUARD}")
    field = MP(math.ceil((digits + _GUARD) * math.log2(10)) + 20)
    model = track(whole, field)
    places = [field.number(x) for x in (whole.merged.positions if xi is None else exact_list(xi, "xi"))]
    times = [field.number(x) for x in exact_list(tau, "tau")]
    if any(t < 0 for t in times):
        raise InputError("tau", "holds a time below 0: the motion starts at 0, give no earlier time")
    steady = [_motion(model, wave, places, times) for wave in steady_waves(whole, forces, field.bits)]
    near = 10.0 ** (-_GUARD / 2)
    waves = induced_waves(whole, forces, spectrum, field.bits, near)
    induced = [_motion(model, wave, places, times) for wave in waves]
    shapes = [(len(places), len(times)), *((len(model.positions), len(times)),) * 2]
    none = [np.full(shape, field.context.mpf(0), dtype=object) for shape in shapes]

    def total(parts: list[list[Any]], k: int) -> Any:
        return sum((part[k] for part in parts), none[k])

    pairs = [
        HarmonicPair(wave.q, wave.multiplicity, part[3], part[0]) for wave, part in zip(waves, induced, strict=True)
    ]
    return HarmonicSolution(
        total(steady, 0),
        total(steady[1:], 0),
        total(induced, 0),
        tuple(pairs),
        total([*steady, *induced], 1),
        total([*steady, *induced], 2),
    )


def _motion(model: Track, wave: Wave, places: list[Any], times: list[Any]) -> list[Any]:
    """Displacement at the places, velocity and force of the masses, and the amplitudes."""
    q, S, _ = wave.precise
    turns = [model.field.exp(model.field.i * q * tau) for tau in times]

    def rows(amplitudes: list[Any]) -> Any:
        values = np.empty((len(amplitudes), len(turns)), dtype=object)
        for j, a in enumerate(amplitudes):
            values[j] = [(a * turn).real for turn in turns]
        return values

    amplitudes = [_amplitude(model, wave, x) for x in places]
    contacts = [model.field.i * q * _amplitude(model, wave, x) for x in model.positions]
    return [rows(amplitudes), rows(contacts), rows([s / 4 for s in S]), np.array(amplitudes, dtype=object)]


def _amplitude(model: Track, wave: Wave, place: Any) -> Any:
    """(1/π) Σ S_j K(ξ − x_j)."""
    _, S, pair = wave.precise
    total = 0
    for force, x in zip(S, model.positions, strict=True):
        side = AHEAD if place >= x else BEHIND
        total = total + force * kernel(model, pair, side, abs(place - x))
    return total / model.field.pi
