"""What a motion of many digits is, and one that the effort did not suffice for."""

from __future__ import annotations

import math
from dataclasses import dataclass
from fractions import Fraction
from typing import Any

import numpy as np

from mpsolve.outcome import Reason
from mpsolve.vibration.image import Image


@dataclass(frozen=True)
class PreciseVibration:
    """The motion from rest in arrays of mpmath numbers (dtype object), in the units of the problem; not proved.

    rail (places, times), the sum of steady, harmonic and transient; vehicle by coordinates; contact_force (n, times).
    error: of the rail and of the forces, relative to the largest of each, by causality and a lower Ω; an estimate.
    reason: where effort ran out; then all numbers are NaN, and the errors infinite.
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


def unknown_precise(image: Image, mp: Any, times: list[Fraction], reason: Reason) -> PreciseVibration:
    """Of which nothing is known."""
    rail, force = (np.full((n, len(times)), mp.nan, object) for n in (len(image.places), image.contacts))
    bodies = {name: np.full(len(times), mp.nan, object) for name in image.pencil.names}
    without = (math.inf, math.inf)
    return PreciseVibration(
        tuple(times), image.places, rail, rail.copy(), rail.copy(), rail.copy(), bodies, force, without, reason
    )
