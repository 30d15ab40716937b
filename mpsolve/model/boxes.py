"""The p-roots and R·Δ over arrays of boxes in q and one parameter, in rigorous float64 discs.

The formulas of kernel.py hold everywhere, but an enclosure that runs through them is 10 to 1000 times too wide. Here
each p-root is enclosed by a Newton step that is centred in all arguments, and R·Δ follows by scaled.py.

No box may meet a cut: then no p-root crosses the real axis within it, and the sides are told at its middle.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import Any

import numpy as np

from mpsolve.discs import Discs, where
from mpsolve.fields import Float64
from mpsolve.model.branch import Track, factors
from mpsolve.model.scaled import SplitRoots

_WIDENING = 1.5  # the radius tried about a p-root, in first-order estimates of its motion


@dataclass(frozen=True)
class RootDiscs:
    """Discs of the p-roots; valid where `known`, pairwise apart where `apart` (else a and c may share a disc)."""

    roots: SplitRoots
    known: Any
    apart: Any


def root_discs(track: Track, q: Discs) -> RootDiscs:
    """Encloses the p-roots for every q, α, η_b of each box (`track` holds discs, arrays of the shape of q)."""
    with np.errstate(all="ignore"):
        shifts = Shifts(track, q)
        seeds = _seeds(shifts)
        found = [shifts.isolate(m) for m in seeds]
        inside = found[0].proved & found[1].proved & found[2].proved & found[3].proved
        discs = sharpened(found, inside)
        sides = _sides(found)
        a, c, parted, paired = _vieta_pair(shifts, found, discs)
        paired = paired & ~inside
        roots = SplitRoots(where(paired, a, discs[0]), discs[1], where(paired, c, discs[2]), discs[3])
        apart = sides & (inside | (paired & parted)) & disjoint(roots)
        return RootDiscs(roots, sides & ((inside & apart) | paired), apart)


class Shifts:
    """D(p) over the boxes as its value at the middle and what q, α and η_b change."""

    def __init__(self, track: Track, q: Discs) -> None:
        self.q0, self.alpha0, self.eta0 = q.m, track.alpha.m.real, track.eta_b.m.real
        self.axial = track.axial
        zero = np.zeros_like(q.m)
        eta0 = Discs(self.eta0)
        self.dalpha = Discs(zero, track.alpha.r)
        self.deta = Discs(zero, track.eta_b.r)
        self.dr = Discs(zero, q.r) - 1j * self.deta
        self.r0 = Discs(self.q0) - 1j * eta0
        self.A0 = self.axial + Discs(self.alpha0) * self.alpha0
        self.A = track.A
        self.constant = (1 - eta0 * eta0 - self.r0 * self.r0) * 4
        self.linear0 = self.r0 * self.alpha0 * 8
        self.linear = track.alpha * (self.r0 + self.dr) * 8
        self.damping = self.deta * (eta0 * 2 + self.deta) * 4

    def isolate(self, m: Any) -> _Isolated:
        """Brouwer on m − D(m)/S(m, p), S the divided difference; D_p ≠ 0 on the disc makes the root unique."""
        p, square = Discs(m), Discs(m) * Discs(m)
        still = ((square - self.A0 * 4) * p + self.linear0) * p + self.constant
        gap = (self.r0 - p * self.alpha0) * 8
        value = still - self.dr * (gap + self.dr * 4)
        value = value + self.dalpha * ((gap + self.dr * 8 - p * self.dalpha * 4) * p) - self.damping
        slope = (square - self.A * 2) * p * 4 + self.linear
        radius = _WIDENING * value.upper / np.maximum(slope.lower, 1e-300)
        disc = Discs(m, radius)
        step = value / ((disc * disc + square - self.A * 4) * (disc + p) + self.linear)
        slopes = (disc * disc - self.A * 2) * disc * 4 + self.linear
        proved = (step.upper < radius) & slopes.nonzero()
        image = where(proved, p - step, Discs(m, np.inf))
        return _Isolated(m, value, image, self._thin(p, square, still), proved)

    def _thin(self, p: Discs, square: Discs, still: Discs) -> Any:
        """How far from m the root at the middle of the box may be; ∞ where this is not proved."""
        slope = (square - self.A0 * 2) * p * 4 + self.linear0
        radius = 4 * still.upper / np.maximum(slope.lower, 1e-300)
        disc = Discs(p.m, radius)
        slopes = (disc * disc - self.A0 * 2) * disc * 4 + self.linear0
        step = still / slopes  # a Newton step with every slope of the disc
        return np.where((step.upper < radius) & slopes.nonzero(), radius, np.inf)


@dataclass(frozen=True)
class _Isolated:
    """A root near m: `disc` holds it over the box, and at the middle of the box it is within `thin` of m."""

    m: Any
    value: Discs
    disc: Discs
    thin: Any
    proved: Any


def _seeds(shifts: Shifts) -> list[Any]:
    """Approximate p-roots at the middles, a and c the closest of an upper and a lower one."""
    track = Track(Float64(), shifts.alpha0, shifts.axial.m.real, shifts.eta0, (), (), True)
    pair = factors(track, shifts.q0)
    over, under = np.sqrt(pair.discriminant(1)), np.sqrt(pair.discriminant(-1))
    upper, lower = (pair.s / 2 + over, pair.s / 2 - over), (-pair.s / 2 + under, -pair.s / 2 - under)
    best = np.argmin([np.abs(u - v) for u in upper for v in lower], axis=0)
    second, odd = best >= 2, best % 2 == 1
    order = [np.where(second, upper[1], upper[0]), np.where(second, upper[0], upper[1])]
    order += [np.where(odd, lower[1], lower[0]), np.where(odd, lower[0], lower[1])]
    A, linear, constant = shifts.A0.m, shifts.linear0.m, shifts.constant.m
    return [m - (((m * m - 4 * A) * m + linear) * m + constant) / ((4 * m * m - 8 * A) * m + linear) for m in order]


def sharpened(found: list[_Isolated], inside: Any) -> list[Discs]:
    """Where all four are isolated: D(m) = Π(m − p') gives p = m − D(m)/Π(m − p') over the three others."""
    result = []
    for k, one in enumerate(found):
        o = [Discs(one.m) - other.disc for j, other in enumerate(found) if j != k]
        sharp = Discs(one.m) - one.value / (o[0] * o[1] * o[2])
        result.append(where(inside & (sharp.r < one.disc.r), sharp, one.disc))
    return result


def _sides(found: list[_Isolated]) -> Any:
    """At the middle, a and b are proved above the real axis, c and e below it, and apart: these are all four."""
    proved = np.ones(found[0].m.shape, dtype=bool)
    for one, sign in zip(found, (1, 1, -1, -1), strict=True):
        proved &= sign * one.m.imag > one.thin
    for one, other in (found[:2], found[2:]):
        proved &= _beside(one, Discs(other.m, other.thin))
    return proved


def _beside(one: _Isolated, disc: Discs) -> Any:
    return (Discs(one.m, one.thin) - disc).nonzero()


def disjoint(z: SplitRoots) -> Any:
    every = (z.a, z.b, z.c, z.e)
    pairs = [(every[j] - every[k]).nonzero() for k in range(4) for j in range(k)]
    return np.logical_and.reduce(pairs)


def _vieta_pair(shifts: Shifts, found: list[_Isolated], discs: list[Discs]) -> tuple[Discs, Discs, Any, Any]:
    """(a, c, whether apart, whether proved): the last two roots from b and e, a + c = −(b + e).

    (p + (b + e)/2)² = 4A + be − 3(b + e)²/4 for p = a, c. Where the square may vanish both share one disc.
    """
    _, b, _, e = discs
    total, product = b + e, b * e
    square, centre = shifts.A * 4 + product - total * total * 0.75, total * -0.5
    root = square.sqrt()
    one, two = centre + root, centre - root
    swap = np.abs(one.m - found[0].m) > np.abs(two.m - found[0].m)
    a, c = where(swap, two, one), where(swap, one, two)
    parted = np.isfinite(a.r) & _beside(found[0], c) & _beside(found[2], a)  # which is which, at the middle
    hull = Discs(centre.m, (centre.r + np.sqrt(square.upper)) * (1 + 2.0**-40))
    proved = found[1].proved & found[3].proved & (b - e).nonzero()
    return where(parted, a, hull), where(parted, c, hull), parted, proved


def root_slopes(track: Track, z: SplitRoots, q: Discs, motions: Any) -> list[list[Any]]:
    """dp/dt = −D_t/D_p of a, b, c, e along each motion (of q, α, η_b), where the roots are apart."""
    r = q - 1j * track.eta_b
    every = (z.a, z.b, z.c, z.e)
    result = []
    for k, p in enumerate(every):
        others = [p - o for j, o in enumerate(every) if j != k]
        residue = (others[0] * others[1] * others[2]).inverse()
        lean = (p * track.alpha - r) * 8  # D_q
        rates = []
        for motion in motions:
            rate = 0
            if motion.q:
                rate = lean * motion.q
            if motion.alpha:
                rate = rate - lean * p * motion.alpha
            if motion.eta_b:
                rate = rate + (q - p * track.alpha) * (8j * motion.eta_b)
            rates.append(-(residue * rate) if isinstance(rate, Discs) else 0)
        result.append(rates)
    return result


def part(track: Track, keep: Any) -> Track:
    """The boxes that are kept; numbers that all boxes share stay."""

    def take(value: Any) -> Any:
        return value[keep] if isinstance(value, Discs) and value.m.ndim else value

    return replace(
        track,
        alpha=take(track.alpha),
        eta_b=take(track.eta_b),
        eta_m=tuple(take(x) for x in track.eta_m),
        positions=tuple(take(x) for x in track.positions),
    )
