"""Wave speeds that short waves of a track tend to, with their names: what is known of a track by dispatch."""

from __future__ import annotations

from fractions import Fraction
from functools import singledispatch
from typing import Any

from mpsolve.errors import InputError
from mpsolve.tracks.rayleigh import Rayleigh
from mpsolve.tracks.string import String
from mpsolve.tracks.three_layer import ThreeLayer
from mpsolve.tracks.timoshenko import Timoshenko
from mpsolve.tracks.undamped import undamped
from mpsolve.tracks.waveguide import Track, Waveguide


@singledispatch
def wave_speeds(track: Any) -> dict[str, Fraction]:  # noqa: ARG001 — others carry none that is known
    """The squares of the speeds by their names; empty where none is known."""
    return {}


@wave_speeds.register
def _(track: String) -> dict[str, Fraction]:
    return {"waves of the string, √(T/m)": track.T / track.m}


@wave_speeds.register
def _(track: Rayleigh) -> dict[str, Fraction]:
    return {"bending waves, √(EI/J)": track.EI / track.J} if track.J else {}


@wave_speeds.register
def _(track: Timoshenko) -> dict[str, Fraction]:
    shear = (track.S + track.kp - track.N) / track.m
    name = "shear waves, √(S/m)" if track.kp == track.N else "shear waves, √((S + kp − N)/m)"
    return {name: shear, "bending waves, √(EI/J)": track.EI / track.J}


@wave_speeds.register
def _(track: ThreeLayer) -> dict[str, Fraction]:
    return (
        {"shear waves of the ballast, √(shear/m_ballast)": track.shear / track.m_ballast} if track.m_ballast else {}
    )


SLOW_WAVES = "Besides, shorter and slower waves of this track follow a constant force at any velocity."


def slow_waves(track: Track | Waveguide) -> bool:
    """Whether a branch of the dispersion curves has every phase velocity above 0.

    It starts at a frequency above 0 for long waves, as D(0, 0) ≠ 0 on a stable track, and its frequency stays bounded
    for short ones, as the highest power of P in the undamped D has a coefficient that depends on s: sleepers under a
    rail that bends no more. False where this is not known.
    """
    try:
        D = undamped(track).dispersion
    except InputError:
        return False
    highest = max((i for (i, _), c in D.items() if c), default=0)
    return bool(D.get((0, 0))) and any(i == highest and j and c for (i, j), c in D.items())
