"""Balls on a grid: they hold what they are made of, have short midpoints, and keep what symmetry proves."""

from __future__ import annotations

import pytest

from mpsolve.errors import PrecisionError
from mpsolve.numbers.balls import acb, arb, precision, square
from mpsolve.numbers.rootball import RADIUS, RootBall, Symmetry, on_grid, radius_of


@pytest.mark.parametrize("goal", [20, 53, 100, 333])
def test_the_image_is_inside_and_the_midpoint_is_short(goal: int) -> None:
    with precision(goal + 100):
        exact = acb(arb(2).sqrt() / 7, -arb(3).sqrt())
        image = exact + square(arb((1, -goal - 20)))
        ball = on_grid(image, goal, 1, Symmetry.NONE)
        assert ball.q.contains(image)
        assert ball.q.rad() <= abs(exact).upper() * arb((1, -goal))
        assert ball.q.bits() <= goal + 30
        for x in (ball.q.real, ball.q.imag):
            assert (x.mid() * arb((1, -ball.exponent))).is_integer()
            assert radius_of(ball.exponent, 1) <= x.rad() < radius_of(ball.exponent, 1) * 1.0001


def test_what_vanishes_by_symmetry_is_zero() -> None:
    with precision(100):
        image = acb(0, arb(2).sqrt())
        ball = on_grid(image, 60, 1, Symmetry.IMAGINARY)
        assert ball.q.real == 0
        assert ball.q.contains(image)
        assert on_grid(acb(arb(2).sqrt(), 0), 60, 1, Symmetry.REAL).q.imag == 0


def test_the_mirror_image() -> None:
    with precision(100):
        ball = on_grid(acb(arb(2).sqrt(), arb(3).sqrt()), 60, 1, Symmetry.NONE)
    mirror = ball.mirrored
    with precision(200):
        assert mirror.q.contains(acb(-ball.q.real, ball.q.imag))
    assert mirror.q.rad() == ball.q.rad()
    assert (mirror.exponent, mirror.symmetry) == (ball.exponent, ball.symmetry)
    assert isinstance(mirror, RootBall)


def test_a_cluster_is_wider_than_its_grid() -> None:
    assert radius_of(-10, 2) == 2**10 * radius_of(-10, 1)
    assert radius_of(0, 1) == arb(RADIUS)


def test_an_image_that_is_too_wide() -> None:
    with precision(100), pytest.raises(PrecisionError, match="too wide"):
        on_grid(acb(1, 1) + square(arb((1, -10))), 60, 1, Symmetry.NONE)


def test_a_ball_that_is_not_finite_is_refused() -> None:
    with pytest.raises(PrecisionError, match="was lost"):
        on_grid(acb("nan"), 60, 1, Symmetry.NONE)
