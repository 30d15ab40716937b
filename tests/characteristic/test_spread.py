"""Waves at many distances are exponentials, however they are found."""

from __future__ import annotations

from fractions import Fraction

import numpy as np
import pytest

from mpsolve.characteristic.spread import Spread
from mpsolve.numbers.balls import acb, exact_ball, precision

EQUAL = tuple(Fraction(3 * k, 4) for k in range(-5, 6))
PLACES = [Fraction(k, 2) for k in (0, 1, 5, 6, 10, 11)]
BOGIES = tuple(x - y for x in PLACES for y in PLACES[::-1])  # in no order, some of them twice
UNEVEN = tuple(Fraction(k * k * k, 7) for k in range(-3, 4))


@pytest.mark.parametrize("exact", [EQUAL, BOGIES, UNEVEN, (Fraction(-2),)])
@pytest.mark.parametrize("thin", [True, False])
def test_waves_on_both_sides(exact: tuple[Fraction, ...], thin: bool) -> None:
    roots = [-0.4 + 1j, -0.1 - 2j]
    with precision(100):
        spread = Spread(exact)
        assert sorted(k for side in spread.sides for k in side.own) == list(range(len(exact)))
        for side in spread.sides:
            waves = side.waves([exact_ball(side.sign * z) for z in roots], thin)
            for k, wave in zip(side.own, waves, strict=True):
                assert (exact[k] >= 0) == (side.sign > 0)
                direct = [np.exp(side.sign * z * float(exact[k])) for z in roots]
                assert np.allclose([complex(x) for x in wave], direct, rtol=1e-14, atol=0)
                assert all(x.rel_accuracy_bits() > 85 for x in wave)


def test_balls_follow_the_precision() -> None:
    spread = Spread((Fraction(1, 3),))
    for bits in (64, 200, 64):
        with precision(bits):
            (ball,) = spread.balls
            assert acb(ball).overlaps(acb(1) / 3)
            assert abs(acb(ball).rel_accuracy_bits() - bits) < 4
