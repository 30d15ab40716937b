"""The paper's ratios as paths: `alpha`, `eta_b`, `eta_n`, `eta_s`, `eta_m` (of all masses) and `d` (0, d, 2d, …).

They name parameters of a `Case`: of masses on the beam with EI = 1/4, m = k = 1, in the paper's units.
"""

from __future__ import annotations

from fractions import Fraction
from itertools import pairwise
from typing import Any

from mpsolve.numbers.model import Quantity, nonnegative, positive, real
from mpsolve.tracks.euler_bernoulli import EulerBernoulli
from mpsolve.vehicles.mass import Mass
from mpsolve.vehicles.vehicle import Placed

Placeds = tuple[Placed, ...]
RATIOS: dict[str, Quantity] = {
    "alpha": nonnegative("", "velocity ratio"),
    "eta_b": nonnegative("", "damping ratio"),
    "eta_n": real("", "axial force ratio, compression positive"),
    "eta_s": nonnegative("", "Pasternak modulus ratio"),
    "eta_m": positive("", "mass ratio of each mass"),
    "d": positive("", "distance of equally spaced masses"),
}


def ratio(track: Any, vehicles: Placeds, path: str) -> Quantity | None:
    """The quantity of a ratio; None where the path is none, or the problem is no case of the paper."""
    if path not in RATIOS or not isinstance(track, EulerBernoulli):
        return None
    unit = (Fraction(1, 4), Fraction(1), Fraction(1), Fraction(0))
    if (track.EI, track.m, track.k, track.eta) != unit or not all(isinstance(p.vehicle, Mass) for p in vehicles):
        return None
    return RATIOS[path] if path != "d" or len(vehicles) > 1 else None


def paths_of(path: str, number: int) -> list[tuple[str, int]]:
    """The (path, factor) that a ratio of a case with so many masses stands for."""
    if path == "d":
        return [(f"gap[{k}]", 1) for k in range(number - 1)]
    return [
        {"alpha": ("v", 1), "eta_b": ("track.c", 2), "eta_n": ("track.N", 1), "eta_s": ("track.kp", 1)}.get(
            path, ("vehicles.M", 1)
        )
    ]


def ratios_of(track: Any, vehicles: Placeds, v: Fraction) -> dict[str, Fraction]:
    """The ratios with their values; `eta_m` and `d` where all masses, or distances, are equal. Empty for no case."""
    if ratio(track, vehicles, "alpha") is None:
        return {}
    out = {"alpha": v, "eta_b": track.c / 2, "eta_n": track.N, "eta_s": track.kp}
    masses = {p.vehicle.M for p in vehicles if isinstance(p.vehicle, Mass)}
    gaps = {b.position - a.position for a, b in pairwise(vehicles)}
    out |= {"eta_m": masses.pop()} if len(masses) == 1 else {}
    return out | ({"d": gaps.pop()} if len(gaps) == 1 else {})
