"""Boxes in floats are rounded inward or outward, never across the exact end, and a hole never leaves its proof."""

from __future__ import annotations

from fractions import Fraction

import flint
import numpy as np
from hypothesis import given, settings
from hypothesis import strategies as st

from mpsolve import Case
from mpsolve.discs import DiscField
from mpsolve.fields import ball_arithmetic
from mpsolve.model.branch import track
from mpsolve.stability.family import Family
from mpsolve.stability.holes import about, exact, holds, inward, outward
from mpsolve.stability.krawczyk import contracted
from mpsolve.stability.rimsearch import _widest, edge_zeros
from mpsolve.stability.zero import Zero, approach, isolate, sharpen

centres = st.fractions(min_value=-1000, max_value=1000, max_denominator=10**30)
reaches = st.integers(1, 60).map(lambda k: 2.0**-k)


@settings(max_examples=300)
@given(centres, reaches)
def test_ends_are_rounded_to_the_side_asked_for(centre: Fraction, reach: float) -> None:
    low, high = about(centre, reach)
    a, b = map(Fraction, inward((low, high)))
    c, d = map(Fraction, outward((low, high)))
    assert c <= low <= a
    assert b <= high <= d
    step = Fraction(abs(float(centre)) + 1) * Fraction(2) ** -52
    assert max(a - c, d - b) <= 2 * step


def test_the_hole_of_a_far_zero_of_a_narrow_box_lies_in_the_box() -> None:
    """At x = 8 a float is 2^-50 apart from the next: rounding to nearest stuck out of a box of reach 2^-44."""
    with ball_arithmetic(64):
        x = (flint.arb(8) + flint.arb(2) ** -51 - flint.arb(2) ** -60).mid()
        t = flint.arb("0.9").mid()
        zero = Zero(x, t, (exact(x), exact(t)), (2.0**-44, 2.0**-44), 1)
    for k, ball in ((0, x), (2, t)):
        assert Fraction(zero.hole[k]) >= exact(ball) - Fraction(2) ** -44
        assert Fraction(zero.hole[k + 1]) <= exact(ball) + Fraction(2) ** -44
        assert zero.hole[k] < zero.hole[k + 1]


def test_a_ball_on_the_border_is_not_held() -> None:
    with ball_arithmetic(64):
        interval = Fraction(1), Fraction(2)
        assert holds(interval, flint.arb(1.5, 0.25))
        assert not holds(interval, flint.arb(1.5, 0.5))
        assert not holds(interval, flint.arb(1.75, 0.3))


def test_krawczyk_keeps_to_the_reach_that_was_given() -> None:
    """arb(0, h) has a radius of 30 bits, rounded up: an image that lies in it, but not within h, proves nothing."""
    h = 0.1
    assert Fraction(h) < exact(flint.arb(0, h).upper())
    with ball_arithmetic(200):
        i = flint.acb(0, 1)
        wide = flint.arb(0, h).upper()
        beyond = ((wide + flint.arb(h)) / 2).mid()  # a zero between h and the ball's radius
        assert contracted(-beyond + 0 * i, flint.acb(1), i, flint.arb(0), flint.arb(0), h, h) is None
        assert contracted(flint.acb(-0.05), flint.acb(1), i, flint.arb(0), flint.arb(0), h, h) is not None


PAIR = Family(Case(alpha=0, eta_b="0.1", eta_m=(70, 70), positions=(0, 1)), "alpha")


def test_a_zero_is_held_by_its_own_box_after_sharpening() -> None:
    point = approach(PAIR, 0.202, 0.974)
    assert point is not None
    zero = sharpen(PAIR, isolate(PAIR, *point), 60)
    for centre, reach, ball in zip(zero.centre, zero.reach, (zero.x, zero.t), strict=True):
        assert holds(about(centre, reach), ball)


def test_the_hole_of_a_zero_on_the_edge_lies_in_its_box() -> None:
    case = Case(alpha=1, eta_b="0.05", eta_m=(70, 70), positions=(0, 1))
    found = edge_zeros(case, 0.8, 1.1, 15, 400_000)
    assert found.zeros
    for zero in found.zeros:
        for k, (centre, ball) in enumerate(zip(zero.centre, (zero.p, zero.alpha), strict=True)):
            low, high = about(centre, zero.reach)
            assert low <= Fraction(zero.hole[2 * k]) < Fraction(zero.hole[2 * k + 1]) <= high
            assert holds((low, high), ball)
        assert Fraction(zero.span[0]) <= about(zero.centre[1], zero.reach)[0]


def test_the_widest_box_is_one_that_the_discs_looked_at() -> None:
    """Its ends as floats, and nothing beyond: at p = 700 the ends of a box of reach 2^-25 are rounded."""
    discs = track(Case(alpha=1, eta_b="0.05", eta_m=(70, 70), positions=(0, 1)), DiscField())
    found = edge_zeros(Case(alpha=1, eta_b="0.05", eta_m=(70, 70), positions=(0, 1)), 0.8, 1.1, 15, 400_000)
    for zero in found.zeros:
        p, t = float(zero.p.mid()), float(zero.alpha.mid())
        wide = _widest(discs, p, t)
        assert wide is not None
        (x, y), reach = wide
        reaches = 2.0 ** -np.arange(3.0, 26.0)
        assert any(
            Fraction(p - r) <= x - Fraction(reach)
            and x + Fraction(reach) <= Fraction(p + r)
            and Fraction(t - r) <= y - Fraction(reach)
            and y + Fraction(reach) <= Fraction(t + r)
            for r in reaches.tolist()
        )
