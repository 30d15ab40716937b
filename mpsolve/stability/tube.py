"""One root followed through a range of velocity ratios, with proof: a chain of tubes that hold one root for each α.

A tube over a step in s, α = α₀ + s (α₁ − α₀), is a disc U that moves along m + v (s − s_m), s_m the step's middle.
With f = R·Δ, which has the zeros of Δ, the mean value theorem encloses f on the line from its value at the middle and
its slopes over the step; interval Newton, −f/f_q inside U for every s, shows that U holds exactly one root for each
s, which is therefore one continuous branch. Where the next tube starts, an enclosure of the branch lies within both.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import Any

import flint
import numpy as np

from mpsolve.discs import DiscField, Discs, DualField
from mpsolve.dual import Dual
from mpsolve.model.boxes import RootDiscs, root_discs, root_slopes
from mpsolve.model.branch import ALONG_ALPHA, ALONG_Q, Track, track
from mpsolve.model.scaled import SplitRoots, scaled_characteristic
from mpsolve.numbers.exact import Exact
from mpsolve.problem.case import Case

acb, arb = flint.acb, flint.arb
_ROUNDS = 400
_SHORTEST = 2.0**-10  # of the way from start to end
_OUT = 1 + 2.0**-40
_ROUND = 2.0**-46  # covers the rounding of α and of midpoints, relative to 1 + |q|


def follow(case: Case, starts: Sequence[Exact], ends: Sequence[Exact], balls: Sequence[Any]) -> list[Any | None]:
    """Balls of the roots at α = ends[k] to which the one root in balls[k] at α = starts[k] is proved to continue.

    None where the chain breaks: the root may reach the cut, or meet another one. The velocity ratio of `case` is not
    used. All chains advance together, one tube each in every round.
    """
    if not balls:
        return []
    arithmetic: Any = DiscField()
    model = track(case, arithmetic)
    chains = _Chains(model, np.array([float(a) for a in starts]), np.array([float(a) for a in ends]), balls)
    with np.errstate(all="ignore"):
        chains.begin()
        for _ in range(_ROUNDS):
            if not chains.active.any():
                break
            chains.advance()
    return [
        acb(arb(m.real, r), arb(m.imag, r)) if s >= 1.0 else None
        for m, r, s in zip(chains.m.tolist(), chains.r.tolist(), chains.s.tolist(), strict=True)
    ]


@dataclass(frozen=True)
class _Slopes:
    """f at the middles; f_q and f_α over the boxes; where all are proved."""

    value: Discs
    along_q: Discs
    along_alpha: Discs
    good: Any


class _Chains:
    """Branches along α₀ + s (α₁ − α₀), each known at its own s within the disc m, r; s runs through floats."""

    def __init__(self, model: Track, start: Any, end: Any, balls: Sequence[Any]) -> None:
        self.model, self.start, self.width = model, start, end - start
        self.m = np.array([complex(q.mid()) for q in balls])
        self.r = np.array([float((q - q.mid()).abs_upper()) for q in balls]) + 2.0**-50 * (1 + np.abs(self.m))
        self.s, self.length = np.zeros(len(balls)), np.ones(len(balls))
        self.speed = np.zeros(len(balls), dtype=complex)  # dq/ds, as a guess
        self.active = np.ones(len(balls), dtype=bool)

    def begin(self) -> None:
        """Takes the speeds at the start; drops the branches where the formulas do not hold."""
        every = np.arange(len(self.m))
        self.active = self._sharpen(every, self.m, self.r, self.s)

    def advance(self) -> None:
        """One tube for each active branch: twice as long next time where it is proved, half as long where not."""
        k = np.flatnonzero(self.active)
        after = np.minimum(self.s[k] + self.length[k], 1.0)
        step = after - self.s[k]
        centre, v, noise = self.m[k], self.speed[k], _ROUND * (1 + np.abs(self.m[k]))
        half = step / 2
        middle, sweep = centre + v * half, np.abs(v) * half * _OUT
        alpha, dalpha = self._alpha(k, self.s[k] + half), np.abs(self.width[k]) * half * _OUT
        first = self._image(k, self._slopes(middle, sweep, alpha, dalpha), v, half)
        size = 1.5 * first.upper + 2 * self.r[k] + noise
        proved = self._slopes(middle, sweep + size, alpha, dalpha)
        image = self._image(k, proved, v, half).upper
        good = proved.good & (image < 0.99 * size) & (self.r[k] + noise < 0.99 * size)
        if good.any():
            reached = k[good]
            good[good] = self._sharpen(reached, (centre + v * step)[good], (image + noise)[good], after[good])
        self.s[k[good]] = after[good]
        self.length[k] = np.where(good, 2 * step, step / 2)
        self.active[k[good]] = after[good] < 1.0
        self.active[k[~good & (step < _SHORTEST)]] = False

    def _alpha(self, k: Any, s: Any) -> Any:
        return self.start[k] + self.width[k] * s

    def _image(self, k: Any, seen: _Slopes, v: Any, half: Any) -> Discs:
        """−f/f_q over the line."""
        drift = (seen.along_alpha * self.width[k] + seen.along_q * v) * Discs(np.zeros(half.shape), half)
        image: Discs = -(seen.value + drift) / seen.along_q
        return image

    def _sharpen(self, k: Any, m: Any, r: Any, s: Any) -> Any:
        """Newton about the middles of discs that hold the branches k at s; takes the result where all is proved."""
        alpha, still, good = self._alpha(k, s), np.zeros(len(k)), np.ones(len(k), dtype=bool)
        speed = self.speed[k]
        for _ in range(2):
            seen = self._slopes(m, r, alpha, still)
            step = -(seen.value / seen.along_q)
            middle = m + step.m
            radius = step.r + _ROUND / 8 * (1 + np.abs(middle))
            better = seen.good & (radius < r)
            speed = np.where(seen.good, -seen.along_alpha.m * self.width[k] / seen.along_q.m, speed)
            good &= seen.good
            m, r = np.where(better, middle, m), np.where(better, radius, r)
        self.m[k[good]], self.r[k[good]], self.speed[k[good]] = m[good], r[good], speed[good]
        return good

    def _slopes(self, q: Any, reach: Any, alpha: Any, dalpha: Any) -> _Slopes:
        """Over the boxes q ± reach, α ± dalpha, each a little widened to cover rounding."""
        noise = _ROUND * (1 + np.abs(alpha))
        over, field = Discs(q, reach + 2.0**-50 * (1 + np.abs(q))), self.model.field
        box, point = self._at(alpha, dalpha + noise), self._at(alpha, noise)
        found, middle = root_discs(box, over), root_discs(point, Discs(q))
        value = scaled_characteristic(point, middle.roots, [Discs(q) * Discs(q) * 2 / field.pi])[0]
        rates = root_slopes(box, found.roots, over, (ALONG_Q, ALONG_ALPHA))
        z = found.roots
        dual = SplitRoots(*(Dual(p, rate) for p, rate in zip((z.a, z.b, z.c, z.e), rates, strict=True)))
        one, zero = Discs(np.ones_like(q)), Discs(np.zeros_like(q))
        moving = Dual(over, [one, zero])
        f = scaled_characteristic(replace(box, field=DualField()), dual, [moving * moving * 2 / field.pi])[0]
        good = found.apart & middle.known & self._on_sheet(found, over) & self._on_sheet(middle, Discs(q))
        finite = np.isfinite(f.slopes[0].r) & np.isfinite(f.slopes[1].r) & np.isfinite(value.r)
        return _Slopes(value, f.slopes[0], f.slopes[1], good & finite & f.slopes[0].nonzero())

    def _at(self, alpha: Any, dalpha: Any) -> Track:
        eta_b = self.model.eta_b
        damping = Discs(np.broadcast_to(eta_b.m, alpha.shape), eta_b.r)
        return replace(self.model, alpha=Discs(alpha, dalpha), eta_b=damping)

    def _on_sheet(self, found: RootDiscs, q: Discs) -> Any:
        """The box is off the line of the cuts, or every p-root off the real axis: then no p-root changes sides."""
        z, eta_b = found.roots, self.model.eta_b
        off_line = np.abs(q.m.imag - eta_b.m.real) > (q.r + eta_b.r) * _OUT
        off_axis = np.logical_and.reduce([np.abs(p.m.imag) > p.r * _OUT for p in (z.a, z.b, z.c, z.e)])
        return (off_line & self.model.cuts_on_line) | off_axis
