"""The argument of Δ far away, as a sum of principal values: what closes the contour without an arc.

Beyond the proved radius (far.py) each of these factors of Δ stays in a half-plane: 1 − κη_jK(0); for three and
more masses the factors 1 + g_j z_j of the waves scattered between them; and the small rest.
"""

from __future__ import annotations

from typing import Any

import flint

from mpsolve.model.branch import Pairing, Track
from mpsolve.model.scaled import SplitRoots

acb, arb = flint.acb, flint.arb


def paired_roots(track: Track, pair: Pairing) -> SplitRoots:
    """The p-roots s/2 ± δ above and −s/2 ± δ' below the axis."""
    delta, delta_below = (track.field.sqrt(pair.discriminant(side)) for side in (1, -1))
    half = pair.s / 2
    return SplitRoots(half + delta, half - delta, -half + delta_below, -half - delta_below)


def far_argument(track: Track, roots: SplitRoots, kappa: Any, delta: Any) -> Any:
    """arg Δ at a point beyond the proved radius, continued from 0 on the imaginary axis of r.

    kappa = 2q²/π, delta = Δ(q). The two p-roots next to the real axis carry the waves.
    """
    a, b = sorted((roots.a, roots.b), key=lambda p: abs(float(p.imag.mid())))
    c, e = sorted((roots.c, roots.e), key=lambda p: abs(float(p.imag.mid())))
    ahead = 1 / ((a - b) * (a - c) * (a - e))
    behind = -1 / ((c - a) * (c - b) * (c - e))
    contact = ahead + 1 / ((b - a) * (b - c) * (b - e))
    strength = 2 * track.field.pi * acb(0, 1) * kappa
    diagonal = [1 - strength * eta * contact for eta in track.eta_m]
    total = arb(0)
    for factor in diagonal:
        total += factor.arg()
        delta = delta / factor
    if len(diagonal) > 2:
        for factor in _scattering_factors(track, (a, c), (strength * ahead, strength * behind), diagonal):
            total += factor.arg()
            delta = delta / factor
    return total + delta.arg()


def _scattering_factors(track: Track, waves: Any, strengths: Any, diagonal: list[Any]) -> list[Any]:
    """1 + g_j z_j, from the last mass to the first; z_j is the reflection of the masses beyond, seen at j."""
    (a, c), (ahead, behind), unit = waves, strengths, acb(0, 1)
    reflection, factors = acb(0), []
    for j in reversed(range(len(diagonal))):
        z = acb(0)
        if j + 1 < len(diagonal):
            gap = track.positions[j + 1] - track.positions[j]
            z = (unit * (a - c) * gap).exp() * reflection
        scale = -track.eta_m[j] / diagonal[j]
        g_ahead, g_behind = scale * ahead, scale * behind
        factor = 1 + g_behind * z
        reflection = (z * (1 - g_ahead - g_behind) - g_ahead) / factor
        factors.append(factor)
    return factors
