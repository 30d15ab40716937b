"""Multiple and nearly multiple roots: Δ's Taylor coefficients with proved errors, and Pellet's test."""

from __future__ import annotations

import math
from typing import Any

import flint

from mpsolve.errors import PrecisionError
from mpsolve.fields import ball_arithmetic
from mpsolve.model.branch import Track, track
from mpsolve.model.characteristic import characteristic
from mpsolve.numbers.rootball import RootBall, Symmetry, on_grid, radius_of
from mpsolve.numbers.taylor import Taylor, taylor
from mpsolve.problem.case import Case
from mpsolve.proof.pellet import pellet
from mpsolve.sheet.enclose import isolate, refine

acb, arb = flint.acb, flint.arb

MOST = 6  # roots in one cluster that are looked for
_OUTER = 14  # the larger disc has the radius |c| 2^−14


def _taylor_of_delta(model: Track, centre: Any, shrink: int) -> Taylor:
    outer = arb(2) ** (math.frexp(float(centre.abs_lower()))[1] - 1 - _OUTER)
    spread = arb(0, outer.upper())
    bound = arb(characteristic(model, centre + acb(spread, spread)).abs_upper())
    return taylor(lambda q: characteristic(model, q), centre, outer, bound, shrink)


def separate(case: Case, seed: complex, digits: int) -> list[RootBall]:
    """The roots that meet near `seed`: each in its ball if they come apart, else one cluster with its number.

    Empty when no cluster of up to MOST roots can be proved there.
    """
    target = math.ceil(digits * math.log2(10)) + 2
    with ball_arithmetic(64):
        centre = acb(seed.real, seed.imag)
    bits = 160
    while True:
        shrink = bits // 8
        with ball_arithmetic(2 * bits + 64) as field:
            try:
                series, m = _recentred(track(case, field), centre, shrink)
            except PrecisionError:
                return []
            if m == 0:
                return []
            centre = series.centre
            approximations = _inner_roots(series, m)
        apart = _isolated(case, approximations, bits, digits)
        if apart is not None:
            return apart
        if bits >= 4 * target:
            with ball_arithmetic(2 * bits + 64):
                return _as_cluster(series, m, target)
        bits *= 2


def _recentred(model: Track, centre: Any, shrink: int) -> tuple[Taylor, int]:
    """The series about the centre of gravity of the m roots that Pellet's test finds, and m."""
    for _ in range(3):
        series = _taylor_of_delta(model, centre, shrink)
        m = _multiplicity(series)
        if m == 0:
            return series, 0
        a = series.coefficients
        centre = (centre - a[m - 1].mid() / (m * a[m].mid())).mid()
    return _taylor_of_delta(model, centre, shrink), m


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
        roots = flint.acb_poly(scaled).roots()
    except (ValueError, ZeroDivisionError):
        return []
    return [(series.centre + scale * z.mid()).mid() for z in roots]


def _isolated(case: Case, approximations: list[Any], bits: int, digits: int) -> list[RootBall] | None:
    """Disjoint balls of all roots, None where they do not come apart; with more digits where they must."""
    for enough in (digits, 2 * digits):
        try:
            boxes = [isolate(case, q, bits) for q in approximations]
            balls = [refine(case, box, enough) for box in boxes]
        except PrecisionError:
            continue
        if balls and not any(a.q.overlaps(b.q) for k, a in enumerate(balls) for b in balls[:k]):
            return balls
    return None


def _as_cluster(series: Taylor, m: int, target: int) -> list[RootBall]:
    """A square ball of relative size 2^−target: at least m roots in its disc, at most m around it."""
    ball = on_grid(series.centre, target, m, Symmetry.NONE)
    shift = ball.q.mid() - series.centre
    radius = radius_of(ball.exponent, m)
    inner, outer = radius - abs(shift), radius * arb(2).sqrt() + abs(shift)
    return [ball] if pellet(series, m, inner) and pellet(series, m, outer) else []
