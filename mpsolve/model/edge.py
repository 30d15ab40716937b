"""One-sided boundary values on the branch cut: G(r) = R·Δ for real r = q − iη_b, finite at branch points.

On the line Im q = η_b the quartic D is real in p. Its resolvent cubic has a real root y that pairs the p-roots
by their order, D = (p² − s p + t)(p² + s p + t') with real s, t, t'; each factor gives two real roots or a
conjugate pair. Seen from below the cut a real root p belongs to the upper ones exactly when D_r/D_p > 0
(moving r to r − iε moves p by iε D_r/D_p). The values from above follow by symmetry,
K(ξ, r̄) = conj K(−ξ, r), so that with

    G±(r) = R det[ I − (2(r ± iη_b)²/π) K M ]      (K, R seen from below)

R·Δ is G₊ below the cut and conj G₋ above it. In G the poles of K at a collision of an upper with a lower
root cancel against R by algebra, not by division, so a ball may hold the branch point itself.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import flint

from mpsolve.errors import PrecisionError
from mpsolve.fields import real_pairing
from mpsolve.model.branch import Track
from mpsolve.model.scaled import SplitRoots, scaled_characteristic

acb, arb = flint.acb, flint.arb


def edge_roots(track: Track, r: Any) -> SplitRoots:
    """Enclosures of the p-roots for every real r in the ball, with their sides proved.

    Two roots that may collide share one ball: one of them is above and one below, since their D_p have
    opposite signs and D_r = 8(αp − r) one sign. Raises `PrecisionError` where the ball is too wide.
    """
    r = arb(r)
    c2, c1, c0 = -4 * track.A, 8 * track.alpha * r, 4 * track.beta2 - 4 * r * r
    s, h = real_pairing(c2, c1, c0, track.field.bits)
    y = s * s
    upper: list[Any] = []
    lower: list[Any] = []
    factors = [(s / 2, -y / 4 - (c2 + h) / 2), (-s / 2, -y / 4 - (c2 - h) / 2)]
    for k, (centre, delta2) in enumerate(factors):
        over, under = _sides(track, r, centre, delta2, factors[1 - k])
        upper += over
        lower += under
    if len(upper) != 2 or len(lower) != 2:
        raise PrecisionError("the sides of the p-roots on the cut are open: split the piece")
    sharp = [_sharpened(track, r, p) for p in upper]
    # a factor's nonreal roots are conjugates, one in each list, in the order of the factors
    conjugates = iter([p.conjugate() for p, wide in zip(sharp, upper, strict=True) if wide.imag > 0])
    return SplitRoots(*sharp, *(next(conjugates) if p.imag < 0 else _sharpened(track, r, p) for p in lower))


def _sharpened(track: Track, r: Any, p: Any) -> Any:
    """One step of interval Newton on D(p, r), centred in r as well; p itself where roots may collide."""
    middle, centre = p.mid(), r.mid()
    shift = r - centre
    slope = 4 * p * (p * p - 2 * track.A) + 8 * track.alpha * r
    if slope.contains(0):
        return p
    value = ((middle * middle - 4 * track.A) * middle + 8 * track.alpha * centre) * middle
    value += 4 * (track.beta2 - centre * centre) + shift * (8 * (track.alpha * middle - centre) - 4 * shift)
    return middle - value / slope


def _sides(track: Track, r: Any, centre: Any, delta2: Any, other: tuple[Any, Any]) -> tuple[list[Any], list[Any]]:
    """The roots centre ± √δ², sorted into (above, below)."""
    if delta2 < 0:
        height = (-delta2).sqrt()
        return [acb(centre, height)], [acb(centre, -height)]
    if delta2 > 0:
        width = delta2.sqrt()
        over, under = [], []
        for sign in (1, -1):
            p = centre + sign * width
            other_factor = (p - other[0]) ** 2 - other[1]  # (p − p₃)(p − p₄)
            quotient = sign * other_factor * (track.alpha * p - r)  # the sign of D_p D_r
            if quotient > 0:
                over.append(acb(p))
            elif quotient < 0:
                under.append(acb(p))
            else:
                raise PrecisionError("the side of a real p-root is open: split the piece")
        return over, under
    wide, high = (arb(0, _root_of_positive_part(side).upper()) for side in (delta2, -delta2))
    slope = track.alpha * (centre + wide) - r  # D_r/8
    if not (slope > 0 or slope < 0):
        raise PrecisionError("D_r may vanish at a double p-root: split the piece")
    pair = acb(centre + wide, high)
    return [pair], [pair]


@dataclass(frozen=True)
class EdgeValue:
    """G₊ (below the cut) and G₋ (above it, conjugated) on a ball of r."""

    plus: Any
    minus: Any


def edge_value(track: Track, r: Any) -> EdgeValue:
    """Enclosures of G± over the ball r, for any number of masses. Raises `PrecisionError`."""
    roots = edge_roots(track, r)
    shift = acb(0, 1) * track.eta_b
    plus, minus = (2 * (arb(r) + sign * shift) ** 2 / track.field.pi for sign in (1, -1))
    value = EdgeValue(*scaled_characteristic(track, roots, (plus, minus)))
    if not (value.plus.is_finite() and value.minus.is_finite()):
        raise PrecisionError("two pairs of p-roots meet at once within the piece: split it, or change alpha a little")
    return value


def resting_edge_value(track: Track, r: Any) -> EdgeValue:
    """G±/s for one mass at rest (α = 0), s = a + b: finite and in general not 0 where two pairs of p-roots meet.

    There R = 2s²(s² − 4A), so that G±/s = 2s(s² − 4A) + 4πiκη.
    """
    s, i = _resting_sum(track, arb(r)), acb(0, 1)
    kappas = (2 * (arb(r) + sign * i * track.eta_b) ** 2 / track.field.pi for sign in (1, -1))
    return EdgeValue(*(2 * s * (s * s - 4 * track.A) + 4 * track.field.pi * i * k * track.eta_m[0] for k in kappas))


def _resting_sum(track: Track, r: Any) -> Any:
    """s = a + b for α = 0, Im s ≥ 0: s² = 4N − 4z, z = √(β² − r²) in the gap and i√(r² − β²) beyond r = β."""
    x = track.beta2 - r * r
    z = acb(_root_of_positive_part(x), _root_of_positive_part(-x))
    square = 4 * (track.axial - z)
    if square.real > 0:
        return -square.sqrt()
    if square.real < 0 or square.imag < 0:
        return acb(0, 1) * (-square).sqrt()
    reach = arb(0, abs(square).upper().sqrt().upper())
    return acb(reach, reach)


def _root_of_positive_part(x: Any) -> Any:
    """√max(x, 0) over a real ball."""
    if x > 0:
        return x.sqrt()
    return arb(0) if x <= 0 else arb(0).union(arb(x.upper()).sqrt())
