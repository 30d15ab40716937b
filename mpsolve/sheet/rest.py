"""Masses at rest on a beam without axial force (α = 0, N = 0): the one case in which all four p-roots meet.

There D = p⁴ − w⁴ with w⁴ = 4(r² − β²), and w is the parameter in which the sheet is smooth about its branch
point r = β: seen from below the cut w > 0, with the upper p-roots −w and iw; round the branch point to the
upper side w turns by −π/2. For two masses and more

    f(w) = R Δ = −8 w⁴ Δ

is analytic near w = 0. Its Taylor coefficients, with proved errors, show |f − f(0)| < |f(0)| for |w| ≤ h: no root
there, and the change of argument round the branch point is a principal value.
"""

from __future__ import annotations

from typing import Any

import flint

from mpsolve.errors import PrecisionError
from mpsolve.fields import laplace_det
from mpsolve.model.branch import Track
from mpsolve.numbers.taylor import taylor
from mpsolve.outcome import Reason
from mpsolve.proof.pellet import pellet

acb, arb = flint.acb, flint.arb

ARCS = 64
SHRINK = 2  # |f| is bounded for |w| ≤ √β/2 by ARCS balls on the rim, and sampled at √β/2^(1 + SHRINK)


def resting_start(track: Track) -> float:
    """A point r₁ > β of the cut such that no root has |w|⁴ ≤ 4(r₁² − β²), proved; `PrecisionError` if none."""
    beta: float = float(track.beta2.mid()) ** 0.5
    for step in range(8, 40, 2):
        start: float = beta * (1 + 2.0**-step)
        if disc_is_free(track, start):
            return start
    raise PrecisionError(
        Reason(
            "resting-branch-point",
            f"a root may lie next to the branch point Re q = {beta:.8g} of masses at rest without axial force",
            {"branch_point": repr(beta)},
            'ask for the region "unstable"' if track.eta_b > 0 else "give some damping, and ask for Im q < 0",
        )
    )


def disc_is_free(track: Track, start: float) -> bool:
    """Proves |f − f(0)| < |f(0)| for |w| ≤ h, h⁴ = 4(start² − β²)."""
    r = arb(start)
    outer = track.beta2.sqrt().sqrt() / 2  # so that r = √(β² + w⁴/4) is analytic
    radius = (4 * (r * r - track.beta2)).sqrt().sqrt()
    if not radius < outer:
        return False
    bound, half = arb(0), arb(0, (arb(1) / ARCS).upper())
    for k in range(ARCS):
        rim = outer * acb(arb(2 * k) / ARCS + half).exp_pi_i()
        bound = bound.max(arb(_resting_value(track, rim).abs_upper()))
    series = taylor(lambda w: _resting_value(track, w), acb(0), outer, bound, SHRINK)
    return pellet(series, 0, radius)


def _resting_value(track: Track, w: Any) -> Any:
    """f(w), from K(±x) = (2πi/4w³)(−e^{−iwx} + i e^{−wx}), x ≥ 0."""
    i, n = acb(0, 1), len(track.eta_m)
    q = (acb(track.beta2) + w**4 / 4).sqrt() + i * track.eta_b
    factor = i * q * q / w**3  # κ · 2πi/4w³
    rows = []
    for j in range(n):
        row = []
        for k in range(n):
            distance = abs(track.positions[j] - track.positions[k])
            wave = i * (-w * distance).exp() - (-i * w * distance).exp()
            row.append(int(j == k) - factor * wave * track.eta_m[k])
        rows.append(row)
    return -8 * w**4 * laplace_det(rows)
