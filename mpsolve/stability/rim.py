"""R·Δ on the edge of the cut as a function of a real wave number p and the velocity ratio: both sides, one formula.

On the cut D(p, q) = 0 has a real root p, and q − iη_b = r = αp + S/2, S² = p⁴ − 4Np² + 4β². As p runs through the
real numbers, (r, side) runs along the edge: where r grows with p, the point is on the upper side of the cut, else on
the lower side, and p counts as one of the upper p-roots, p = a. At the branch point r' = 0 nothing is singular. The
other p-roots solve

    C(x) = x³ + p x² + (p² − 4A) x + p³ − 4Np + 4α²p + 4αS = 0,

of which one real root c is on the other side than p, and b, e = −(p + c)/2 ± √(4A − (3p² + 2pc + 3c²)/4). A pair b, e
that is not real has one root on each side. If it is real, σ = D_r D_p tells: b is the one with the σ of p.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import Any

import flint
import numpy as np

from mpsolve.dual import Dual
from mpsolve.errors import PrecisionError
from mpsolve.fields import cardano, simple_root
from mpsolve.model.branch import Track
from mpsolve.model.scaled import SplitRoots, scaled_characteristic
from mpsolve.stability.entire import EntireBalls

acb, arb = flint.acb, flint.arb


@dataclass(frozen=True)
class Edge:
    """A point, or box, of the edge: S, r, the slopes of S and r along p, and the p-roots (a = p)."""

    p: Any
    S: Any
    S_rate: Any
    r: Any
    r_rate: Any
    roots: SplitRoots


def cubic(track: Track, p: Any, S: Any) -> tuple[Any, Any, Any]:
    """The coefficients of C of x², x and 1."""
    square, N, alpha = p * p, track.axial, track.alpha
    linear = square - track.A * 4
    return p, linear, p * (square - N * 4 + alpha * alpha * 4) + alpha * S * 4


def cubic_along_p(track: Track, p: Any, S_rate: Any, x: Any) -> Any:
    """C_p at a fixed x."""
    N, alpha = track.axial, track.alpha
    return x * x + p * x * 2 + p * p * 3 - N * 4 + alpha * alpha * 4 + alpha * S_rate * 4


def cubic_along_alpha(track: Track, p: Any, S: Any, x: Any) -> Any:
    """C_α at a fixed x."""
    return (p - x) * track.alpha * 8 + S * 4


def pair_square(track: Track, p: Any, c: Any) -> Any:
    """((b − e)/2)² = 4A − (p + c)²/2 − (p − c)²/4."""
    total, gap = p + c, p - c
    return track.A * 4 - total * total * 0.5 - gap * gap * 0.25


def rates(track: Track, edge: Edge) -> list[list[Any]]:
    """The slopes (along p, along α) of a, b, c, e."""
    z = edge.roots
    inner = (z.b, z.c, z.e)
    result: list[list[Any]] = [[1, 0]]
    for k, x in enumerate(inner):
        one, two = (x - o for j, o in enumerate(inner) if j != k)
        residue = 1 / (one * two)  # 1/C'(x)
        along_p = cubic_along_p(track, edge.p, edge.S_rate, x)
        along_alpha = cubic_along_alpha(track, edge.p, edge.S, x)
        result.append([-(along_p * residue), -(along_alpha * residue)])
    return result


def edge_function(track: Track, edge: Edge, i: Any) -> Any:
    """R·Δ on the edge."""
    q = edge.r + i * track.eta_b
    return scaled_characteristic(track, edge.roots, [q * q * 2 / track.field.pi])[0]


def edge_slopes(track: Track, edge: Edge, field: Any, number: Any) -> Any:
    """R·Δ with its slopes along p and α; `field` takes dual numbers, `number` makes a complex constant."""
    slopes = rates(track, edge)
    z, i = edge.roots, track.field.i
    zero = number(0)
    a = Dual(number(z.a), [number(1), zero])
    rest = [Dual(number(p), [number(s) for s in rate]) for p, rate in zip((z.b, z.c, z.e), slopes[1:], strict=True)]
    q = Dual(edge.r + i * track.eta_b, [number(edge.r_rate), number(edge.p)])
    moving = replace(track, field=field)
    return scaled_characteristic(moving, SplitRoots(a, *rest), [q * q * 2 / track.field.pi])[0]


def half_square(N: Any, beta2: Any, p: Any, axial_positive: bool) -> Any:
    """S² = p⁴ − 4Np² + 4β², in the form that keeps it from 0."""
    square = p * p
    if axial_positive:
        lift = square - N * 2
        return lift * lift + (beta2 - N * N) * 4
    return square * square - N * square * 4 + beta2 * 4


# --- balls --------------------------------------------------------------------------------------------------


def edge_ball(track: Track, p: Any) -> Edge:
    """The edge at the ball p (flint.arb; `track` over balls). Raises `PrecisionError` where sides are open."""
    bits = track.field.bits
    S = half_square(track.axial, track.beta2, p, float(track.axial) > 0).sqrt()
    S_rate = 2 * p * (p * p - 2 * track.axial) / S
    r, r_rate = track.alpha * p + S / 2, track.alpha + S_rate / 2
    c2, c1, c0 = cubic(track, p, S)
    seed = partner_seed(*(float(x.mid()) for x in (track.alpha, track.axial, track.beta2, p)))
    c = simple_root([c0, c1, c2], arb(seed), bits)
    square, centre = pair_square(track, p, c), -(p + c) / 2
    if square < 0:
        height = (-square).sqrt()
        b, e = acb(centre, height), acb(centre, -height)
    elif square > 0:
        b, e = (acb(x) for x in _sorted_pair(track, r, p, c, centre, square.sqrt()))
    else:
        raise PrecisionError("two p-roots meet next to a cut point: change a parameter a little")
    return Edge(p, S, S_rate, r, r_rate, SplitRoots(acb(p), b, acb(c), e))


def _sorted_pair(track: Track, r: Any, p: Any, c: Any, centre: Any, width: Any) -> tuple[Any, Any]:
    b, e = centre + width, centre - width
    roots = (p, c, b, e)
    signs = []
    for k, x in enumerate(roots):
        sigma = track.alpha * x - r
        for j, o in enumerate(roots):
            if j != k:
                sigma = sigma * (x - o)
        signs.append(1 if sigma > 0 else -1 if sigma < 0 else 0)
    if signs == [signs[0], -signs[0], signs[0], -signs[0]] and signs[0]:
        return b, e
    if signs == [signs[0], -signs[0], -signs[0], signs[0]] and signs[0]:
        return e, b
    raise PrecisionError("the sides of four real p-roots are open: split the piece")


def value_ball(track: Track, p: Any) -> Any:
    """R·Δ at the ball p."""
    moving = replace(track, field=EntireBalls(track.field))
    return edge_function(moving, edge_ball(track, p), acb(0, 1))


def slopes_ball(track: Track, p: Any) -> tuple[Any, Any, Any]:
    """R·Δ and its slopes along p and α at the ball p."""
    dual = edge_slopes(track, edge_ball(track, p), EntireBalls(track.field), acb)
    return dual.value, dual.slopes[0], dual.slopes[1]


def partner_seed(alpha: float, axial: float, beta2: float, p: float) -> float:
    """An approximation to c: the real root of C on p's own branch r = αx + S(x)/2, on the other side than p."""
    return float(partner_seeds(alpha, axial, beta2, np.array([p]))[0])


def partner_seeds(alpha: Any, axial: float, beta2: float, p: Any) -> Any:
    """`partner_seed` for arrays, in float64 (heuristic: what it gives is proved elsewhere)."""
    S = np.sqrt(p**4 - 4 * axial * p * p + 4 * beta2)
    r = alpha * p + S / 2
    c1, c0 = p * p - 4 * (axial + alpha * alpha), p**3 - 4 * axial * p + 4 * alpha * alpha * p + 4 * alpha * S
    lean = alpha + p * (p * p - 2 * axial) / S  # r'(p)
    best, least = np.zeros_like(p), np.full(np.shape(p), np.inf)
    for root in cardano(p, c1, c0):
        x = root.real
        half = np.sqrt(np.maximum(x**4 - 4 * axial * x * x + 4 * beta2, 1e-300))
        miss = np.abs(root.imag) + np.abs(r - alpha * x - half / 2)
        slope = alpha + x * (x * x - 2 * axial) / half
        wrong = (miss > 1e-6 * (1 + np.abs(x)) ** 2) | (slope * lean > 0)
        score = np.abs(x - p) + np.where(wrong, 1e3 * (1 + miss), 0)
        better = score < least
        best, least = np.where(better, x, best), np.where(better, score, least)
    return best
