"""A track without its damping, as exact data: its waves neither decay nor grow."""

from __future__ import annotations

from fractions import Fraction
from typing import Any

from mpsolve.errors import InputError
from mpsolve.numbers.model import Quantity, quantities
from mpsolve.tracks.at_rest import Status, at_rest
from mpsolve.tracks.waveguide import Polynomial, Track, Waveguide, mapped


def undamped(track: Track | Waveguide) -> Waveguide:
    """The equations with every damping 0; InputError where it is not clear what the damping is.

    A track with named parameters loses those whose unit has an odd power of the second, like N s/m². Bare equations
    whose D has odd powers of s lose the odd powers in each entry; for that they must be reciprocal, A(P, s) being
    the transpose of A(−P, s), as equations of springs, dampers and masses are.
    """
    if isinstance(track, Track):
        damping = {name: Fraction(0) for name, one in quantities(type(track)).items() if dissipates(one)}
        guide = track.with_values(damping)
        if not _is_even(guide.dispersion):
            raise InputError(
                "track",
                "is damped with all its parameters in seconds at 0, so its undamped waves are "
                "unknown: give the undamped equations as a Waveguide",
            )
        return guide
    guide = track.waveguide
    if _is_even(guide.dispersion):
        return guide
    if not is_reciprocal(guide):
        raise InputError(
            "track",
            "is damped, and its equations are not reciprocal, so what is damping in them is not "
            "clear: give the undamped equations",
        )
    return Waveguide(
        tuple(
            tuple(mapped(entry, lambda _, j, c: c if j % 2 == 0 else Fraction(0)) for entry in row)
            for row in guide.matrix
        ),
        guide.loaded,
    )


def dissipates(quantity: Quantity) -> bool:
    """Whether the unit has an odd power of the second: stiffness and mass have even ones, newtons too."""
    return "s" in quantity.unit.replace("/", " ").split()


_TYPICAL = {"c_pad": "30 kN s/m²", "c_ballast": "80 kN s/m²", "c_ground": "50 kN s/m²"}
"""Damping of ballasted track, for one rail."""


def damping_wanted(track: Track | Waveguide) -> str:
    """Which damping would be felt by every vibration of the track, and what is typical of it."""
    names = (
        [name for name, one in quantities(type(track)).items() if dissipates(one)] if isinstance(track, Track) else []
    )
    keys = [name for name in names if _damps(track, name)]
    if not keys:
        return "give it some damping"
    rail = hasattr(track, "EI")
    shown = [f"{key} ({_TYPICAL[key]} is typical)" if rail and key in _TYPICAL else key for key in keys]
    worked = ", or work one out with mpsolve work-out damping" if rail else ""
    return f"give a value above 0 to {' or '.join(shown)}{worked}"


def _damps(track: Any, name: str) -> bool:
    """Whether a value for this damping alone leaves no vibration without any."""
    return at_rest(track.with_values({name: Fraction(1)})).status is not Status.UNDAMPED


def is_reciprocal(guide: Waveguide) -> bool:
    """Whether a_ij(P, s) = a_ji(−P, s)."""
    n = len(guide.matrix)
    return all(
        guide.matrix[i][j] == mapped(guide.matrix[j][i], lambda a, _, c: c * (-1) ** a)
        for i in range(n)
        for j in range(i + 1)
    )


def _is_even(polynomial: Polynomial) -> bool:
    return all(j % 2 == 0 for _, j in polynomial)
