"""Rows that the tests share, and the receptance of a row by brute force: terms of the endless track, added up."""

from __future__ import annotations

from fractions import Fraction
from typing import Any

from receptance_truth import Receptance

from mpsolve import Problem, tracks, vehicles
from mpsolve.endless.row import Row, row_of

BEAM = tracks.EulerBernoulli(EI="0.25", m=1, k=1, c="0.1")
LAYERS = tracks.TwoLayer(EI=1, m=1, k_pad=4, c_pad=1, m_sleeper=2, k_ballast=2, c_ballast=1)
BOGIE = vehicles.Bogie(wheel=3, frame=5, inertia=2, wheelbase="1.5", k=2, c="0.3")


def masses(v: str) -> Row:
    """The paper's beam with η_M = 40, spacing 1.5, η_b = 0.05, at α = v."""
    return row_of(Problem(BEAM, vehicles.Mass(40), v=v), "1.5")


def bogies(v: str) -> Row:
    """Bogies on a two-layer track: two contacts a vehicle, bodies that no contact feels alone."""
    return row_of(Problem(LAYERS, BOGIE, v=v), "4.5")


def brute_sum(row: Row, a: Fraction, z: complex, sigma: complex, reach: int) -> complex:
    """Σ_{|k| ≤ reach} Ĝ(a + kd) z^{−k} in mpmath, each term from its own p-roots."""
    truth = Receptance(row.reduced.guide, 20)
    (ahead, behind), mp = truth.roots(sigma), truth.mp
    D, N = truth.in_P(truth.D, sigma), truth.in_P(truth.N, sigma)
    total: Any = mp.mpc(0)
    for k in range(-reach, reach + 1):
        xi = truth.number(a + k * row.step)
        poles, sign = (ahead, 1) if a + k * row.step >= 0 else (behind, -1)
        for P in poles:
            slope = mp.polyval(D, P, derivative=1)[1]
            total += sign * mp.polyval(N, P) * mp.exp(P * xi) / slope * mp.mpc(z) ** -k
    return complex(total)
