"""No vibration on a beam grows faster than a rate that is known at once: for all passive vehicles, contacts, places.

Let s = y + iΩ and σ = s + ivp, y > 0. For real p, D = K + c s + m s² at P = ip with K = EI p⁴ + T p² + k, and
Re(σ conj D) = y K + (m y + c)(y² + Ω²) + v p Ω (2 m y + c). Its least value over Ω is y times

    EI p⁴ − b p² + k + (m y + c) y,   b = v² (2 m y + c)²/(4 y (m y + c)) − T = v² (m + c²/(4 y (m y + c))) − T,

which is positive for all p where b ≤ 0 or b² < 4 EI (k + (m y + c) y). As b falls with y and the right side grows,
what holds at one y holds at all larger ones. Then V = σG has, for σ = y + ix, V + V* = (1/2π)∫ |Σ u_j e^{−ipξ_j}|²
2 Re(σ N/D) dp > 0 with Ω = x − vp, so that no passive vehicle has a root there (SPEC, half-plane): none has
Im q ≤ −y.
"""

from __future__ import annotations

from fractions import Fraction

from mpsolve.problem.reduced import Guide

_BEAM = {(4, 0), (2, 0), (0, 0), (0, 1), (0, 2)}
_STEPS = 24


def fastest_growth(guide: Guide) -> Fraction | None:
    """A y (scaled) with no root in Im q ≤ −y, near the least of this theorem; None for other tracks than its beam."""
    D, N = guide.D_rest, guide.N_rest
    if not (set(D) <= _BEAM and set(N) == {(0, 0)} and N[0, 0] > 0):
        return None
    EI, T, k, c, m = (D.get(key, Fraction(0)) for key in ((4, 0), (2, 0), (0, 0), (0, 1), (0, 2)))
    if not (EI > 0 and m > 0 and k >= 0 and c >= 0):
        return None

    def holds(y: Fraction) -> bool:
        b = guide.v**2 * (m + c**2 / (4 * y * (m * y + c))) + T  # D has −T P²
        return b <= 0 or b**2 < 4 * EI * (k + (m * y + c) * y)

    high = Fraction(1, 2**20)
    while not holds(high):
        high *= 2
    low = Fraction(0)
    for _ in range(_STEPS):
        middle = (low + high) / 2
        low, high = (low, middle) if holds(middle) else (middle, high)
    return high
