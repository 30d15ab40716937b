"""Bands for the values of rails and of what runs on them: a value outside is likely to be one in another unit.

They are wide on purpose: all shipped presets and examples lie well inside. A band decides nothing.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from fractions import Fraction
from typing import Any

from mpsolve.numbers.model import Model, Part
from mpsolve.numbers.spoken import beside, rounded, spoken
from mpsolve.outcome import Reason
from mpsolve.problem.problem import Problem

Band = tuple[float, float]

_BEAM: Mapping[str, Band] = {
    "EI": (1e4, 1e12), "m": (10, 1e5), "S": (1e5, 1e12), "k": (1e5, 1e10), "c": (5, 1e7),
}  # fmt: skip
_LAYERED: Mapping[str, Band] = {
    "EI": (1e5, 1e9), "m": (10, 2000),
    "k_pad": (5e6, 2e10), "c_pad": (100, 1e7), "m_sleeper": (10, 5000), "k_ballast": (1e6, 2e10),
    "c_ballast": (500, 1e7), "m_ballast": (20, 5e4), "k_ground": (1e5, 2e10), "c_ground": (500, 1e8),
    "EI_slab": (1e4, 1e12), "m_slab": (50, 5e4), "k": (1e5, 2e10), "c": (100, 1e8),
}  # fmt: skip
_TRACKS: Mapping[str, Mapping[str, Band]] = {
    "euler-bernoulli": _BEAM, "rayleigh": _BEAM, "timoshenko": _BEAM,
    "two-layer": _LAYERED, "three-layer": _LAYERED, "slab": _LAYERED,
}  # fmt: skip
_SPRUNG: Mapping[str, Band] = {
    "wheel": (50, 1e5), "k": (1e4, 1e9), "c": (50, 1e7), "k_contact": (1e7, 1e11), "k2": (1e4, 1e9), "c2": (50, 1e8),
}  # fmt: skip
_VEHICLES: Mapping[str, Mapping[str, Band]] = {
    "mass": {"M": (50, 1e6)},
    "oscillator": {**_SPRUNG, "body": (50, 1e6)},
    "bogie": {**_SPRUNG, "frame": (50, 1e5), "inertia": (10, 1e6), "wheelbase": (0.3, 30), "body": (100, 1e6)},
    "coach": {**_SPRUNG, "body": (500, 1e6), "inertia": (1e3, 1e9), "pivots": (1, 100)},
}
_OTHER: Mapping[str, tuple[tuple[Fraction, str], ...]] = {
    "kg": ((Fraction(1000), "t"),),
    "kg/m": ((Fraction(1000), "t/m"),),
    "kg m²": ((Fraction(1000), "t m²"),),
    "m": ((Fraction(1, 1000), "mm"),),
    "N": ((Fraction(1000), "kN"), (Fraction(10**6), "MN")),
    "N/m": ((Fraction(1000), "kN/m"), (Fraction(10**6), "kN/mm"), (Fraction(10**9), "GN/m")),
    "N/m²": ((Fraction(1000), "kN/m²"), (Fraction(10**6), "MN/m²"), (Fraction(10**9), "kN/mm²")),
    "N m²": ((Fraction(1000), "kN m²"), (Fraction(10**6), "MN m²")),
    "N s/m": ((Fraction(1000), "kN s/m"), (Fraction(10**6), "MN s/m")),
    "N s/m²": ((Fraction(1000), "kN s/m²"), (Fraction(10**6), "MN s/m²")),
}
"""In what else a value of this unit may be written by mistake, the likelier one first."""


def implausible(problem: Problem) -> Iterator[Reason]:
    """A sentence for each value that no rail and no vehicle on one has; none where the track is no rail."""
    track: Any = problem.track
    if not on_rails(problem):
        return
    yield from _outside(track, "track", _TRACKS[track.name])
    seen: list[Any] = []
    for placed in problem.vehicles:
        if placed.vehicle not in seen:
            seen.append(placed.vehicle)
            yield from _vehicle(placed.vehicle, f"the {placed.vehicle.name}'s ")


def on_rails(problem: Problem) -> bool:
    """Whether the track is a rail with what carries it; no wire, no ice, no matrix, nothing in units of its own."""
    return getattr(problem.track, "name", "") in _TRACKS and getattr(problem.track, "m", None) != 1


def _vehicle(vehicle: Any, owner: str) -> Iterator[Reason]:
    if vehicle.name in _VEHICLES:
        yield from _outside(vehicle, owner, _VEHICLES[vehicle.name])
        for key, quantity, part in vehicle.described:
            if isinstance(quantity, Part):
                yield from _vehicle(part, f"{owner}{key}.")


def _outside(model: Model, owner: str, bands: Mapping[str, Band]) -> Iterator[Reason]:
    for key, quantity, value in model.described:
        if key not in bands or not value or _within(value, bands[key]):
            continue
        low, high = bands[key]
        name = f"track.{key}" if owner == "track" else f"{owner}{key}"
        known = f"{spoken(low, quantity.unit, 2)} to {spoken(high, quantity.unit, 2)}"
        stated = f"{name} is {beside(value, quantity.unit)}, but any {quantity.meaning} known here is {known}"
        path = name if owner == "track" else key
        yield Reason("value-unlikely", stated, {path: str(value)}, _meant(key, value, quantity.unit, bands[key]))


def _meant(key: str, value: Fraction, unit: str, band: Band) -> str:
    """The unit in which the number would be a likely one."""
    for size, other in _OTHER.get(unit, ()):
        if _within(value * size, band):
            seat = "; what one rail seat has is divided by the sleepers' distance first"
            layer = unit in ("N/m²", "N s/m²", "kg/m") and key != "m"
            return f'write {key} = "{rounded(value)} {other}", if that is meant{seat if layer else ""}'
    return "check it and its unit, if that is not meant"


def _within(value: Fraction, band: Band) -> bool:
    return band[0] <= value <= band[1]
