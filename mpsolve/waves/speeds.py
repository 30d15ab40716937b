"""Wave speeds that short waves of a track tend to, with their names: what is known of a track by dispatch."""

from __future__ import annotations

from fractions import Fraction
from functools import singledispatch
from typing import Any

from mpsolve.tracks.rayleigh import Rayleigh
from mpsolve.tracks.string import String
from mpsolve.tracks.three_layer import ThreeLayer
from mpsolve.tracks.timoshenko import Timoshenko


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
