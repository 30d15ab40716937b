"""Roots that meet, or nearly meet: each in its ball where they come apart, else a cluster with its number.

Nothing here knows what the function is: it gives its series, the ball of one root, and the ball of a cluster.
"""

from __future__ import annotations

import math
from typing import Any, Protocol

from mpsolve.errors import PrecisionError
from mpsolve.frozen import frozen
from mpsolve.numbers.balls import acb, acb_poly, arb, precision
from mpsolve.numbers.rootball import RootBall
from mpsolve.numbers.taylor import Taylor, pellet

_FIRST_BITS = 160


class Meeting(Protocol):
    """What a function must give for its clusters."""

    @property
    def most(self) -> int:
        """Roots in one cluster that are looked for."""

    def series(self, centre: Any, shrink: int) -> Taylor:
        """About the exact centre; the errors of its coefficients fall with `shrink`."""

    def single(self, seed: Any, bits: int, digits: int) -> RootBall:
        """The simple root near the seed, looked for with so many bits; PrecisionError where there is none."""

    def cluster(self, series: Taylor, m: int, target: int) -> list[RootBall]:
        """The ball of relative size 2^−target that holds the m roots about the centre; none where that fails."""


@frozen
class _Found:
    series: Taylor
    m: int


def separate(roots: Meeting, seed: Any, digits: int) -> list[RootBall]:
    """The roots that meet near `seed`, each counted as often as it is one.

    Empty when no cluster of up to `most` roots can be proved there.
    """
    target = math.ceil(digits * math.log2(10)) + 2
    centre = acb(seed)
    bits = _FIRST_BITS
    while True:
        with precision(2 * bits + 64):
            try:
                found = _recentred(roots, centre, bits // 8)
            except PrecisionError:
                return []
            if found.m == 0:
                return []
            centre = found.series.centre
            approximations = _inner_roots(found)
        apart = _isolated(roots, approximations, bits, digits)
        if apart is not None:
            return apart
        if bits >= 4 * target:
            with precision(2 * bits + 64):
                return roots.cluster(found.series, found.m, target)
        bits *= 2


def _recentred(roots: Meeting, centre: acb, shrink: int) -> _Found:
    """The series about the centre of gravity of the m roots that Pellet's test finds, and m."""
    for _ in range(3):
        series = roots.series(centre, shrink)
        m = _multiplicity(series, roots.most)
        if m == 0:
            return _Found(series, 0)
        a = series.coefficients
        centre = (centre - a[m - 1].mid() / (m * a[m].mid())).mid()
    return _Found(roots.series(centre, shrink), m)


def _multiplicity(series: Taylor, most: int) -> int:
    for k in range(4, 60, 4):
        for m in range(1, most + 1):
            if pellet(series, m, series.outer * arb(2) ** -k):
                return m
    return 0


def _inner_roots(found: _Found) -> list[acb]:
    """Approximations to the m small roots: those of the series cut after its m-th term."""
    series = found.series
    scale = arb(2) ** -40 * series.outer
    scaled = [(a * scale**k).mid() for k, a in enumerate(series.coefficients[: found.m + 1])]
    try:
        roots = acb_poly(scaled).roots()
    except (ValueError, ZeroDivisionError):
        return []
    return [(series.centre + scale * z.mid()).mid() for z in roots]


def _isolated(roots: Meeting, approximations: list[acb], bits: int, digits: int) -> list[RootBall] | None:
    """Disjoint balls of all roots, None where they do not come apart; with more digits where they must."""
    for enough in (digits, 2 * digits):
        try:
            balls = [roots.single(seed, bits, enough) for seed in approximations]
        except PrecisionError:
            continue
        if balls and not any(a.q.overlaps(b.q) for k, a in enumerate(balls) for b in balls[:k]):
            return balls
    return None
