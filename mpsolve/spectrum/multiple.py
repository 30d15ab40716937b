"""Roots of Δ̂ that meet, or nearly meet: each in its ball where they come apart, else a cluster with its number."""

from __future__ import annotations

import math
from typing import Any

from mpsolve.characteristic.proved import Proved
from mpsolve.errors import PrecisionError
from mpsolve.numbers.balls import acb, acb_poly, arb, precision, square
from mpsolve.numbers.rootball import RootBall, Symmetry, on_grid, radius_of
from mpsolve.numbers.taylor import Taylor, taylor
from mpsolve.proof.pellet import pellet
from mpsolve.spectrum.enclose import in_units, isolate, refine

MOST = 6
"""Roots in one cluster that are looked for."""
_OUTER = 14  # the larger disc has the radius |σ| 2^−14
_FIRST_BITS = 160


def separate(proved: Proved, seed: complex, digits: int) -> list[RootBall]:
    """The roots that meet near `seed` (σ̂, scaled), each counted as often as it is one.

    Empty when no cluster of up to MOST roots can be proved there.
    """
    target = math.ceil(digits * math.log2(10)) + 2
    centre = acb(seed)
    bits = _FIRST_BITS
    while True:
        with precision(2 * bits + 64):
            try:
                series, m = _recentred(proved, centre, bits // 8)
            except PrecisionError:
                return []
            if m == 0:
                return []
            centre = series.centre
            approximations = _inner_roots(series, m)
        apart = _isolated(proved, approximations, bits, digits)
        if apart is not None:
            return apart
        if bits >= 4 * target:
            with precision(2 * bits + 64):
                return as_cluster(proved, series, m, target)
        bits *= 2


def _taylor_of_delta(proved: Proved, centre: Any, shrink: int) -> Taylor:
    outer = arb(2) ** (math.frexp(float(centre.abs_lower()))[1] - 1 - _OUTER)
    bound = arb(_delta(proved, centre + square(outer)).abs_upper())
    if not bound.is_finite():
        raise PrecisionError("Δ is not bounded round the roots that meet: they are too near a cut")
    return taylor(lambda sigma: _delta(proved, sigma), centre, outer, bound, shrink)


def _delta(proved: Proved, sigma: Any) -> Any:
    """By plain elimination: near a multiple root no pivot may be left out."""
    return proved.matrices(sigma, slope=False)[0].det()


def _recentred(proved: Proved, centre: Any, shrink: int) -> tuple[Taylor, int]:
    """The series about the centre of gravity of the m roots that Pellet's test finds, and m."""
    for _ in range(3):
        series = _taylor_of_delta(proved, centre, shrink)
        m = _multiplicity(series)
        if m == 0:
            return series, 0
        a = series.coefficients
        centre = (centre - a[m - 1].mid() / (m * a[m].mid())).mid()
    return _taylor_of_delta(proved, centre, shrink), m


def _multiplicity(series: Taylor) -> int:
    for k in range(4, 60, 4):
        for m in range(1, MOST + 1):
            if pellet(series, m, series.outer * arb(2) ** -k):
                return m
    return 0


def _inner_roots(series: Taylor, m: int) -> list[Any]:
    """Approximations to the m small roots: those of the series cut after its m-th term."""
    scale = arb(2) ** -40 * series.outer
    scaled = [(a * scale**k).mid() for k, a in enumerate(series.coefficients[: m + 1])]
    try:
        roots = acb_poly(scaled).roots()
    except (ValueError, ZeroDivisionError):
        return []
    return [(series.centre + scale * z.mid()).mid() for z in roots]


def _isolated(proved: Proved, approximations: list[Any], bits: int, digits: int) -> list[RootBall] | None:
    """Disjoint balls of all roots, None where they do not come apart; with more digits where they must."""
    for enough in (digits, 2 * digits):
        try:
            balls = [refine(isolate(proved, sigma, bits), enough) for sigma in approximations]
        except PrecisionError:
            continue
        if balls and not any(a.q.overlaps(b.q) for k, a in enumerate(balls) for b in balls[:k]):
            return balls
    return None


def as_cluster(proved: Proved, series: Taylor, m: int, target: int) -> list[RootBall]:
    """A square ball of relative size 2^−target: at least m roots in its disc, at most m around it."""
    unit = proved.reduced.frequency_unit
    centre = in_units(series.centre, unit)
    ball = on_grid(centre, target, m, Symmetry.NONE)
    scale = acb(1) / acb(arb(unit.numerator) / unit.denominator)
    shift = abs((ball.q.mid() - centre) * scale)
    radius = abs(radius_of(ball.exponent, m) * scale)
    inner, outer = radius - shift, radius * arb(2).sqrt() + shift
    return [ball] if pellet(series, m, inner) and pellet(series, m, outer) else []
