"""Roots of Δ̂ that meet, or nearly meet: each in its ball where they come apart, else a cluster with its number."""

from __future__ import annotations

import math
from typing import Any

from mpsolve.characteristic.proved import Proved
from mpsolve.errors import PrecisionError
from mpsolve.frozen import frozen
from mpsolve.numbers.balls import acb, arb, square
from mpsolve.numbers.rootball import RootBall, Symmetry, on_grid, radius_of
from mpsolve.numbers.taylor import Taylor, pellet, taylor
from mpsolve.proof import clusters
from mpsolve.spectrum.enclose import in_units, isolate, line_near, refine

_OUTER = 14  # the larger disc has the radius |σ| 2^−14


@frozen
class _Roots:
    """Δ̂ as the search for clusters asks for it, in σ̂."""

    proved: Proved
    most: int = 6

    def series(self, centre: acb, shrink: int) -> Taylor:
        line = line_near(self.proved, centre)
        centre = centre if line is None else line.onto(centre).mid()
        outer = arb(2) ** (math.frexp(float(centre.abs_lower()))[1] - 1 - _OUTER)
        bound = arb(self._delta(centre + square(outer)).abs_upper())
        if not bound.is_finite():
            raise PrecisionError("Δ is not bounded round the roots that meet: they are too near a cut")
        return taylor(self._delta, centre, outer, bound, shrink)

    def _delta(self, sigma: Any) -> Any:
        """By plain elimination: near a multiple root no pivot may be left out."""
        return self.proved.matrices(sigma, slope=False)[0].det()

    def single(self, seed: Any, bits: int, digits: int) -> RootBall:
        return refine(isolate(self.proved, seed, bits), digits)

    def cluster(self, series: Taylor, m: int, target: int) -> list[RootBall]:
        return as_cluster(self.proved, series, m, target)


def separate(proved: Proved, seed: complex, digits: int) -> list[RootBall]:
    """The roots that meet near `seed` (σ̂, scaled), each counted as often as it is one.

    Empty when no cluster of up to six roots can be proved there.
    """
    return clusters.separate(_Roots(proved), seed, digits)


def as_cluster(proved: Proved, series: Taylor, m: int, target: int) -> list[RootBall]:
    """A square ball of relative size 2^−target: at least m roots in its disc, at most m around it."""
    unit, line = proved.reduced.frequency_unit, line_near(proved, series.centre)
    centre = in_units(series.centre, unit)
    alone = m == 1 and line is not None and bool(line.onto(series.centre) == series.centre)  # on its own mirror image
    ball = on_grid(centre, target, m, line.symmetry if alone and line else Symmetry.NONE)
    scale = acb(1) / acb(arb(unit.numerator) / unit.denominator)
    shift = abs((ball.q.mid() - centre) * scale)
    radius = abs(radius_of(ball.exponent, m) * scale)
    inner, outer = radius - shift, radius * arb(2).sqrt() + shift
    return [ball] if pellet(series, m, inner) and pellet(series, m, outer) else []
