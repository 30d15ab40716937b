"""Problems whose charts have points of each kind, each with ranges of two parameters round it."""

from __future__ import annotations

from typing import Any

from mpsolve import Problem, tracks, vehicles
from mpsolve.vehicles.vehicle import AnyVehicle


def beam(c: str) -> tracks.EulerBernoulli:
    return tracks.EulerBernoulli(EI="1/4", m=1, k=1, c=c)


def linked(M: str, C: str, K: str, d: str) -> AnyVehicle:
    """Two masses on a spring and a damper between them."""
    signs = [[1, -1], [-1, 1]]
    damper, spring = ([[f"{s * float(x):g}" for s in row] for row in signs] for x in (C, K))
    return vehicles.Vehicle(M=[[M, 0], [0, M]], C=damper, K=spring, B=[[1, 0], [0, 1]], places=[0, d])


THREE = [vehicles.Mass(M).at(x) for M, x in (("32.6", 0), ("2.4", "1.54"), ("11.5", "3.2"))]
MEETINGS: dict[str, tuple[Problem, dict[str, Any]]] = {
    "two pairs": (Problem(beam("0.4"), THREE, v=1), {"v": ("1.09", "1.12"), "scale.mass": ("2.2", "2.4")}),
    "pair and divergence": (
        Problem(beam("0.29"), linked("28.65", "0.55", "3.5", "3.24"), v=1),
        {"v": ("1.44", "1.48"), "scale.mass": ("0.46", "0.56")},
    ),
    "pair from q = 0": (
        Problem(beam("0.3"), linked("10", "15", "2", "2.4"), v=1),
        {"v": ("1.17", "1.22"), "track.c": ("0.29", "0.34")},
    ),
}  # fmt: skip
