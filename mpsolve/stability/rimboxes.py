"""The edge of the cut over arrays of boxes [p] × [α] in rigorous float64 discs: where R·Δ is proved not to vanish.

As in rim.py; each quantity is enclosed by its value at the middle of the box and its slopes over the box. What makes
a labelling of the p-roots a proof is said at `_labels`.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import Any

import numpy as np

from mpsolve.discs import Discs, where
from mpsolve.model.boxes import part
from mpsolve.model.branch import Track
from mpsolve.model.scaled import SplitRoots
from mpsolve.stability.entire import DualDiscs
from mpsolve.stability.rim import (
    Edge,
    cubic,
    cubic_along_alpha,
    cubic_along_p,
    edge_function,
    edge_slopes,
    half_square,
    pair_square,
    partner_seeds,
    rates,
)

_OUT = 1 + 2.0**-50  # half-widths of boxes are rounded outward
_WIDENINGS = (1.4, 2.2)
_HALF = 0.5

Region = Any  # float64 array of shape (n, 4): p from, p to, α from, α to


@dataclass(frozen=True)
class Assessment:
    """Of each box: proved to hold no zero with 0 ≤ r < radius; whether to halve it along p.

    value: R·Δ at the middle; along_p, along_alpha: its slopes over the box, both valid where `sure`.
    """

    free: Any
    across: Any
    value: Discs
    along_p: Discs
    along_alpha: Discs
    sure: Any


@dataclass(frozen=True)
class _Boxes:
    """The edge over the boxes and at their middles, and what is proved of the labels."""

    track: Track
    edge: Edge
    middle_track: Track
    middle: Edge
    known: Any
    single: Any  # the pair b, e keeps apart, so that the slopes hold
    ambiguous: Any  # b and e may have to be exchanged


def assess(track: Track, boxes: Region, radius: float) -> Assessment:
    """`track` holds discs, its α is ignored: that of the boxes is taken."""
    p0, p1, t0, t1 = boxes.T
    p, t = (p0 + p1) / 2, (t0 + t1) / 2
    dp, dt = np.maximum(p1 - p, p - p0) * _OUT, np.maximum(t1 - t, t - t0) * _OUT
    with np.errstate(all="ignore"):
        found = _edges(track, p, dp, t, dt)
        r = found.edge.r
        outside = (r.m.real + r.r < 0) | (r.m.real - r.r > radius)
        result = _judged(found, dp, dt)
        free = outside | (found.known & result.free)
        again = found.known & found.ambiguous & free & ~outside
        if again.any():
            other = _exchanged(found, again)
            free[again] &= _judged(other, dp[again], dt[again]).free
        ratio = dp / dt / (1 + np.abs(p))
        steep = result.along_p.upper * dp > result.along_alpha.upper * dt
        usable = np.isfinite(result.along_p.r) & np.isfinite(result.along_alpha.r) & result.sure
        across = np.where(ratio > 8, True, np.where(ratio < 1 / 8, False, np.where(usable, steep, ratio > 1)))
    sure = result.sure & found.known & ~found.ambiguous
    return Assessment(free, across, result.value, result.along_p, result.along_alpha, sure)


def _judged(found: _Boxes, dp: Any, dt: Any) -> Assessment:
    """R·Δ over the boxes by its value, and by the mean value theorem."""
    i = found.track.field.i
    zero = np.zeros_like(dp)
    value = edge_function(found.track, found.edge, i)
    if len(found.track.eta_m) > 2:  # the bordered form takes one pair that may meet: (p, c), or (b, e)
        z = found.edge.roots
        renamed = replace(found.edge, roots=SplitRoots(z.b, z.a, z.e, z.c))
        value = _narrower(edge_function(found.track, renamed, i), value)
    at_middle = edge_function(found.middle_track, found.middle, i)
    dual = edge_slopes(found.track, found.edge, DualDiscs(), _disc_like(zero))
    along_p, along_alpha = dual.slopes
    centred = at_middle + along_p * Discs(zero, dp) + along_alpha * Discs(zero, dt)
    sure = found.single & np.isfinite(centred.r)
    free = value.nonzero() | (sure & centred.nonzero())
    return Assessment(free, free, at_middle, along_p, along_alpha, sure)


def _disc_like(zero: Any) -> Any:
    return lambda x: x if isinstance(x, Discs) else Discs(zero + x)


def _edges(track: Track, p: Any, dp: Any, t: Any, dt: Any) -> _Boxes:
    zero = np.zeros_like(p)
    dp, dt = Discs(zero, dp), Discs(zero, dt)
    here = replace(track, alpha=Discs(t))
    over = replace(track, alpha=Discs(t, dt.r))
    point, ball = Discs(p), Discs(p, dp.r)
    upward = bool(track.axial.m.real > 0)
    S0 = half_square(track.axial, track.beta2, point, upward).sqrt()
    rough = half_square(track.axial, track.beta2, ball, upward).sqrt()
    S_rate = ball * (ball * ball - track.axial * 2) * 2 / rough
    S = _narrower(S0 + S_rate * dp, rough)
    S_rate = _narrower(ball * (ball * ball - track.axial * 2) * 2 / S, S_rate)
    r0 = here.alpha * point + S0 * _HALF
    r_rate = over.alpha + S_rate * _HALF
    r = r0 + (here.alpha + S_rate * _HALF) * dp + ball * dt
    seeds = partner_seeds(t, float(track.axial.m.real), float(track.beta2.m.real), p)
    c0, c, found = _partner(here, over, point, ball, S0, S, S_rate, dp, dt, seeds)
    # ((b − e)/2)² and (b + e)/2 at the middle and over the box
    along_p, along_t = _partner_slopes(over, ball, S, S_rate, c)
    c = _narrower(c0 + along_p * dp + along_t * dt, c)
    square0 = pair_square(here, point, c0)
    square_p = -((ball + c) * (along_p + 1)) - (ball - c) * (1 - along_p) * _HALF
    square_t = over.alpha * 8 - (ball + c) * along_t + (ball - c) * along_t * _HALF
    square = _narrower(square0 + square_p * dp + square_t * dt, pair_square(over, ball, c))
    centre0, centre = (point + c0) * -_HALF, (ball + c) * -_HALF
    centre = _narrower(centre0 - (along_p + 1) * dp * _HALF - along_t * dt * _HALF, centre)
    negative, positive = square.m.real + square.r < 0, square.m.real - square.r > 0
    middles = _pair(square0, centre0)
    b, e = _pair(square, centre)
    single = (negative | positive) & (negative == (square0.m.real < 0))
    b, e = _sharper_pair(over, ball, S, S_rate, (b, c, e), middles, dp, dt, single)
    reach = np.sqrt(square.upper) * (1 + 2.0**-40)
    hull = Discs(centre.m, centre.r + reach)
    b, e = where(single, b, hull), where(single, e, hull)
    edge = Edge(ball, S, S_rate, r, r_rate, SplitRoots(ball, b, c, e))
    middle = Edge(point, S0, S0, r0, r_rate, SplitRoots(point, middles[0], c0, middles[1]))
    known, swap, ambiguous = _labels(over, edge, negative, positive & single, single)
    edge, middle = _swapped(edge, swap), _swapped(middle, swap)
    return _Boxes(over, edge, here, middle, known & found, single & found, ambiguous)


def _narrower(one: Discs, two: Discs) -> Discs:
    return where(one.r < two.r, one, two)


def _partner(
    here: Track,
    over: Track,
    point: Discs,
    ball: Discs,
    S0: Discs,
    S: Discs,
    S_rate: Discs,
    dp: Discs,
    dt: Discs,
    m: Any,
) -> tuple[Discs, Discs, Any]:
    """c at the middle and over the box, each proved to be the one real root of C near m, and where proved.

    m − C(m)/C[m, x], C[m, x] the divided difference, maps the disc into itself (Brouwer), and C' ≠ 0 there.
    """
    M = Discs(m)
    p2, p1, p0 = cubic(here, point, S0)
    still = ((M + p2) * M + p1) * M + p0
    moved = still + cubic_along_p(over, ball, S_rate, M) * dp + cubic_along_alpha(over, ball, S, M) * dt
    _, linear, _ = cubic(over, ball, S)
    best, proved = Discs(m, np.inf + np.zeros_like(m)), np.zeros(m.shape, dtype=bool)
    thin, sharp = np.full(m.shape, np.inf), np.zeros(m.shape, dtype=bool)
    wide, narrow = np.zeros(m.shape), np.full(m.shape, np.inf)
    slope = (M * 3 + ball * 2) * M + linear
    exact = (M * 3 + point * 2) * M + p1
    for widening in _WIDENINGS:
        reach = widening * moved.upper / np.maximum(slope.lower, 1e-300)
        disc = Discs(m, reach)
        step = moved / (disc * disc + disc * M + M * M + ball * (disc + M) + linear)
        good = (step.upper < reach) & ((disc * 3 + ball * 2) * disc + linear).nonzero() & ~proved
        best, proved, wide = where(good, M - step, best), proved | good, np.where(good, reach, wide)
        near = widening * still.upper / np.maximum(exact.lower, 1e-300)
        disc = Discs(m, near)
        step = still / (disc * disc + disc * M + M * M + point * (disc + M) + p1)
        fine = (step.upper < near) & ~sharp
        thin, sharp, narrow = np.where(fine, step.upper, thin), sharp | fine, np.where(fine, near, narrow)
    # within the disc over the box the root at the middle is the same one
    return Discs(m, thin), best, proved & sharp & (narrow <= wide)


def _partner_slopes(over: Track, ball: Discs, S: Discs, S_rate: Discs, c: Discs) -> tuple[Discs, Discs]:
    _, linear, _ = cubic(over, ball, S)
    residue = ((c * 3 + ball * 2) * c + linear).inverse()
    return -(cubic_along_p(over, ball, S_rate, c) * residue), -(cubic_along_alpha(over, ball, S, c) * residue)


def _pair(square: Discs, centre: Discs) -> tuple[Discs, Discs]:
    """centre ± √square, the root of positive imaginary part first where they are not real."""
    down = square.m.real < 0
    width = where(down, (-square).sqrt() * 1j, square.sqrt())
    return centre + width, centre - width


def _sharper_pair(
    over: Track,
    ball: Discs,
    S: Discs,
    S_rate: Discs,
    rough: tuple[Discs, Discs, Discs],
    middles: tuple[Discs, Discs],
    dp: Discs,
    dt: Discs,
    single: Any,
) -> tuple[Discs, Discs]:
    b, c, e = rough
    edge = Edge(ball, S, S_rate, ball, ball, SplitRoots(ball, b, c, e))
    slopes = rates(over, edge)
    moved = [m + s[0] * dp + s[1] * dt for m, s in zip(middles, (slopes[1], slopes[3]), strict=True)]
    return tuple(  # type: ignore[return-value]
        where(single & (new.r < old.r), new, old) for new, old in zip(moved, (b, e), strict=True)
    )


def _labels(track: Track, edge: Edge, negative: Any, positive: Any, single: Any) -> tuple[Any, Any, Any]:
    """(whether proved, whether b and e are to be exchanged, whether both orders have to be looked at).

    Two of the p-roots are upper and two lower ones, and a real one is told by the sign of σ = D_r D_p.

        b, e not real       one is upper, one lower, so that p and c are on different sides.
        b, e real, apart    the signs of all four σ are proved; or, where p and c may meet, D_r has one sign on both
                            and b, e do not separate them, so that D_p has opposite signs on p and c: then either
                            order of b and e is possible.
        b, e in one disc    that p and c keep away from, with D_r ≠ 0 on it: if they are real, D_p has opposite signs
                            on them. Both are the same disc, so that their order does not matter.
    """
    z, r = edge.roots, edge.r
    roots = (z.a, z.c, z.b, z.e)
    gaps = {(j, k): roots[j] - roots[k] for j in range(4) for k in range(4) if j != k}
    lean = [_sign(track.alpha * x - r) for x in roots]
    sign = {key: _sign(gap) for key, gap in gaps.items()}
    sigma = [lean[j] * np.prod([sign[j, k] for k in range(4) if k != j], axis=0) for j in range(4)]
    apart = positive & (sigma[0] != 0) & (sigma[1] == -sigma[0])
    plain = apart & (sigma[2] == sigma[0]) & (sigma[3] == -sigma[0])
    swap = apart & (sigma[2] == -sigma[0]) & (sigma[3] == sigma[0])
    beside = sign[0, 2] * sign[0, 3] * sign[1, 2] * sign[1, 3] > 0
    ambiguous = positive & ~plain & ~swap & (lean[0] * lean[1] > 0) & beside
    away = gaps[0, 2].nonzero() & gaps[1, 2].nonzero() & (lean[2] != 0)
    return negative & single | plain | swap | ambiguous | (~single & away), swap, ambiguous


def _sign(z: Discs) -> Any:
    """The sign of a real number in each disc, 0 where it is open."""
    return np.where(z.m.real > z.r * _OUT, 1, np.where(z.m.real < -z.r * _OUT, -1, 0))


def _swapped(edge: Edge, swap: Any) -> Edge:
    z = edge.roots
    return replace(edge, roots=SplitRoots(z.a, where(swap, z.e, z.b), z.c, where(swap, z.b, z.e)))


def _exchanged(found: _Boxes, keep: Any) -> _Boxes:
    """The boxes that are kept, with b and e in the other order."""
    every = np.ones(int(np.sum(keep)), dtype=bool)
    return _Boxes(
        part(found.track, keep),
        _swapped(_kept(found.edge, keep), every),
        part(found.middle_track, keep),
        _swapped(_kept(found.middle, keep), every),
        found.known[keep],
        found.single[keep],
        found.ambiguous[keep],
    )


def _kept(edge: Edge, keep: Any) -> Edge:
    z = edge.roots
    roots = SplitRoots(z.a[keep], z.b[keep], z.c[keep], z.e[keep])
    return Edge(edge.p[keep], edge.S[keep], edge.S_rate[keep], edge.r[keep], edge.r_rate[keep], roots)
