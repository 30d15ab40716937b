"""Taylor coefficients of an analytic function in balls, with proved errors.

They come from samples on a circle; what the samples cannot see is bounded by the maximum of |f| on a larger disc. By
Pellet's test they count roots: if |a_m| h^m > Σ_{k≠m} |a_k| h^k, the disc |z| < h holds exactly m roots of Σ a_k z^k.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from flint import acb, arb

from mpsolve.frozen import frozen

SAMPLES = 16


@frozen
class Taylor:
    """Balls of a_0 … a_{SAMPLES−1} of f(centre + z) = Σ a_k z^k; |a_k| ≤ bound/outer^k for every k."""

    centre: acb
    coefficients: tuple[acb, ...]
    bound: arb
    outer: arb


def taylor(function: Callable[[Any], Any], centre: acb, outer: arb, bound: arb, shrink: int) -> Taylor:
    """From samples on the circle of radius outer·2^−shrink; `bound` ≥ |f| on the disc of radius `outer`.

    What the samples cannot tell apart is below bound·2^(−shrink·SAMPLES).
    """
    inner = outer * arb(2) ** -shrink
    turns = [acb(arb(2 * j) / SAMPLES).exp_pi_i() for j in range(SAMPLES)]
    samples = [function(centre + inner * turn) for turn in turns]
    alias = bound * arb(2) ** (1 - shrink * SAMPLES)
    coefficients = []
    for k in range(SAMPLES):
        total = sum((f / turns[(j * k) % SAMPLES] for j, f in enumerate(samples)), acb(0)) / SAMPLES
        error = arb(0, (alias / inner**k).upper())
        coefficients.append(total / inner**k + acb(error, error))
    return Taylor(centre, tuple(coefficients), bound, outer)


def pellet(series: Taylor, m: int, radius: arb) -> bool:
    """True if the disc of this radius about the centre is proved to hold exactly m roots."""
    if not radius > 0:
        return False
    ratio = radius / series.outer
    tail = series.bound * ratio**SAMPLES / (1 - ratio)
    others = sum((abs(a) * radius**k for k, a in enumerate(series.coefficients) if k != m), tail)
    return bool(ratio < 1 and abs(series.coefficients[m]) * radius**m > others)
