"""Packed balls come back exactly."""

from __future__ import annotations

from flint import arb

from mpsolve.fields import ball_arithmetic
from mpsolve.numbers.packed import pack, unpack


def test_balls_travel_exactly() -> None:
    with ball_arithmetic(400):
        balls = [arb.pi(), arb(0), arb("0.1") * arb(10) ** 40, -arb(2).sqrt() + arb(0, arb(2) ** -300)]
    for ball in balls:
        same = unpack(pack(ball))
        assert same.mid().man_exp() == ball.mid().man_exp()
        assert same.rad() >= ball.rad()
        assert same.rad() <= ball.rad() * arb("1.000001")
