"""The loads of a page's response: rows for its readers, exact texts for machines."""

from __future__ import annotations

from collections.abc import Iterable, Iterator

from mpsolve.model.load import Load, gives_forces
from mpsolve.numbers.exact import Exact
from mpsolve.report.answer import Source
from mpsolve.report.rows import shown

_Row = tuple[str, str, str]


def load_rows(source: Source, loads: Iterable[Load]) -> Iterator[_Row]:
    """Symbol, value and meaning of the force on each mass; its harmonic part only where one is given."""
    physical = source.physical
    if physical is None:
        for j, load in enumerate(loads, 1):
            harmonic = load.amplitude, load.frequency, load.phase
            yield from _rows(j, ("η_C", "η_A", "ω̂_f", "φ"), ("", " per unit of τ"), load.constant, harmonic)
    elif gives_forces(physical):
        for j, mass in enumerate(physical.masses, 1):
            harmonic = mass.P_A, mass.omega_f, mass.phi_f
            yield from _rows(j, ("P", "P_A", "ω_f", "φ_f"), (" N", " rad/s"), mass.P, harmonic)
    else:
        for j, load in enumerate(loads, 1):
            yield f"P{j}", f"{shown(load.constant)} N", f"weight of mass {j}, for no force is given"


def _rows(
    j: int, symbols: tuple[str, ...], units: tuple[str, str], constant: Exact, harmonic: tuple[Exact, Exact, Exact]
) -> Iterator[_Row]:
    force, frequency = units
    yield f"{symbols[0]}{j}", f"{shown(constant)}{force}", f"constant force on mass {j}"
    if any(harmonic):
        said = (force, "amplitude of its harmonic force"), (frequency, "its frequency"), (" rad", "its phase")
        for symbol, value, (unit, meaning) in zip(symbols[1:], harmonic, said, strict=True):
            yield f"{symbol}{j}", f"{shown(value)}{unit}", meaning


def load_data(loads: Iterable[Load]) -> list[dict[str, str]]:
    """The values of each load as exact texts."""
    return [{name: str(value) for name, value in vars(load).items()} for load in loads]
