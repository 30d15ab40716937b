"""Three and more masses far out on the continued sheet: waves that nearly passive obstacles scatter.

With the travelling waves of rigorous_tail.py, B = I − κηK is diag(B)(I + M + V): M of the travelling waves, V of the
evanescent ones. As in sheet/far.py, det(I + M) = Π (1 + g z_j), z_j being what the masses beyond j reflect. Here

    g = iηw gain √(FB)/4 / (1 + ηwX'),   F = −4C₂, B = 4C₀,   X' near (1 + i)/4,

is near ĝ₀ = 1/d, Re d = 1, Im d ≤ −1, a lossless obstacle with |ĝ₀| ≤ 1/√2: it would be the same but for the
corrections in 1/w and for 4 Im w/(η|w|²), which Re d lacks. Between the masses the waves grow, at most at the sum of
both rates. A lossless obstacle takes |z| < 1 to (|z| + |ĝ₀|)/(1 + |ĝ₀||z|) at most, and for 1 ≤ |z| < √2

    |Γ|² = 1 + (|z|² − 1)(1 − |ĝ₀|²)/|1 + ĝ₀z|² ≤ 1 + (z² − 1)/(√2 − z)².
"""

from __future__ import annotations

from collections.abc import Sequence
from itertools import pairwise
from typing import Any

import flint

from mpsolve.model.branch import Track
from mpsolve.sheet.far import Asymptotics, deviating, product, require

acb, arb = flint.acb, flint.arb

_AHEAD, _BEHIND = 2, 0  # the p-roots w P_k of the travelling waves


def inverse_bound(track: Track, at: Asymptotics, delta: float, growth: Any, travelling: Any, evanescent: Any) -> Any:
    """A bound of every entry of (I + M + V)⁻¹ for |w| ≥ W, 0 ≤ Im w ≤ δ.

    growth: the rate of a wave to and fro. travelling, evanescent: bounds of the entries of M and of V. Raises
    PrecisionError where W is too small or δ too large.
    """
    n = len(track.eta_m)
    gaps = [b - a for a, b in pairwise(track.positions)]
    g, change, skew = _obstacle(track, at, delta)
    reflection, floor = g, arb(1)  # of the last mass, beyond which there is none
    for gap in reversed(gaps):
        z = reflection * (growth * gap).exp()
        require(g * z < 1, "the reflection")
        floor = floor * (1 - g * z)
        reflection = _upper(deviating(_passive(z), z, g, change, skew))
    row = (1 + (n - 1) * (travelling + evanescent) ** 2).sqrt()
    # by Hadamard, row by row: what V changes, and the minors
    left = floor - n * arb(n - 1).sqrt() * evanescent * row ** (n - 1)
    require(left > 0, "the scattering matrix")
    return row ** (n - 1) / left


def _obstacle(track: Track, at: Asymptotics, delta: float) -> tuple[Any, Any, Any]:
    """Bounds of |g|, |g − ĝ₀| and |τ + 1/τ − 2|, τ² = F/B."""
    root2, one, i = arb(2).sqrt(), acb(1, 1), acb(0, 1)
    shift = abs(at.gain * (one + at.E[1] + i * at.E[2]) - one) / root2
    loss = 4 * arb(delta) / (least(track.eta_m) * at.W * at.W * root2)
    require(shift < 1 and loss < 1, "the diagonal")
    mean = product(at, _AHEAD).sqrt()
    deviation = ((abs(at.gain * mean - 1) + shift) / (1 - shift) + loss) / (1 - loss)
    skew = abs((2 + at.E[_AHEAD] + at.E[_BEHIND]) / mean - 2)
    return (1 + deviation) / root2, deviation / root2, skew


def _passive(z: Any) -> Any:
    """A bound of |Γ| for a lossless obstacle, |ĝ₀| ≤ 1/√2, before an array that reflects no more than z."""
    root2 = arb(2).sqrt()
    if z < 1:
        return (1 + root2 * z) / (root2 + z)
    z = z.max(arb(1))
    require(z < root2, "the reflection")
    return (1 + (z * z - 1) / (root2 - z) ** 2).sqrt()


def least(values: Sequence[Any]) -> Any:
    """A lower bound of the least of these balls."""
    found = values[0]
    for value in values[1:]:
        found = found.min(value)
    return arb(found.lower())


def _upper(ball: Any) -> Any:
    return arb(ball.upper())
