"""Each ball has one p-root of mpmath for every σ, at any precision; what cannot be told apart is refused."""

from __future__ import annotations

from fractions import Fraction
from typing import Any

import numpy as np
import pytest
from residue import TRACKS, Residues, holds, random_track

from mpsolve.characteristic.roots import Orders, apart, discs, float_roots, leading, root_balls
from mpsolve.characteristic.symbol import Symbol
from mpsolve.errors import PrecisionError
from mpsolve.numbers.balls import acb, acb_poly, exact_ball, precision, square
from mpsolve.problem.reduced import track_guide

SIGMA = 0.5 + 0.25j


def balls(symbol: Symbol, sigma: Any) -> list[Any]:
    middle = [row(sigma.mid()) for row in symbol.balls()]
    return root_balls(symbol, sigma, float_roots(middle, len(symbol.rows) - 1))


@pytest.mark.parametrize("bits", [53, 64, 80, 81, 120, 200, 1000, 5000])
def test_exact_points_at_any_precision(bits: int) -> None:
    for track, v in ((TRACKS["two-layer"], Fraction(100)), (random_track(2, 3), Fraction(1, 3))):
        guide = track_guide(track, v)
        truth = Residues(guide, bits // 3 + 40)
        with precision(bits):
            found = balls(Symbol.of(guide.D), exact_ball(SIGMA))
        exact = truth.roots(SIGMA)
        assert len(found) == len(exact)
        assert all(sum(holds(ball, z) for ball in found) == 1 for z in exact)
        assert all(ball.rel_accuracy_bits() > bits - 30 for ball in found)


@pytest.mark.parametrize("half", [1e-30, 1e-12, 1e-6, 1e-3])
def test_balls_of_every_width(half: float) -> None:
    guide = track_guide(TRACKS["slab"], Fraction(50))
    truth = Residues(guide, 50)
    with precision(120):
        found = balls(Symbol.of(guide.D), exact_ball(SIGMA) + square(half))
    for turn in (0, 1, -1j, 1 + 1j):
        exact = truth.roots(truth.mp.mpmathify(SIGMA) + truth.mp.mpf(half * 0.999) * turn)
        assert all(sum(holds(ball, z) for ball in found) == 1 for z in exact)
    spread = (
        [abs(a - b) for a, b in zip(truth.roots(SIGMA), truth.roots(SIGMA + half), strict=True)]
        if half > 1e-9
        else []
    )
    assert all(float(max(ball.rad() for ball in found)) < 20 * max(spread) for _ in spread[:1])


def test_the_value_over_a_ball_is_no_wider_than_it_is() -> None:
    """(P − σ)² at P = 2, σ = 2 ± 0.01: naive evaluation has a width of 4 · 0.01 and more."""
    symbol = Symbol.of({(2, 0): Fraction(1), (1, 1): Fraction(-2), (0, 2): Fraction(1)})
    with precision(64):
        local = Orders(symbol, acb(2) + square(0.01))
        assert local(acb(2)).contains(0)
        assert float(local(acb(2)).abs_upper()) < 4e-4
        about = local.about(acb(2))
        assert about[2] == 1
        assert about[1].contains(acb(0.019, 0))
        assert float(about[1].abs_upper()) < 0.03


def test_discs_are_as_wide_as_gershgorin_has_them() -> None:
    """P² − 1/16 about −1 and 1: |W| = 15/32 falls short of the roots, 3/4 away; 2|W| holds them."""
    symbol = Symbol.of({(2, 0): Fraction(1), (0, 0): Fraction(-1, 16)})
    with precision(64):
        local = Orders(symbol, acb(1))
        _, radii = discs(local, local.wide, [acb(-1), acb(1)])
    assert all(0.75 < float(r) < 0.95 for r in radii)
    with precision(64):
        local = Orders(Symbol.of({(2, 0): Fraction(1), (0, 0): Fraction(1, 16)}), acb(1))
        with pytest.raises(PrecisionError, match="told apart"):
            discs(local, local.wide, [acb(-1), acb(1)])


def test_roots_that_cannot_be_told_apart() -> None:
    """P² = σ over a ball that holds 0."""
    symbol = Symbol.of({(2, 0): Fraction(1), (0, 1): Fraction(-1)})
    with precision(64), pytest.raises(PrecisionError, match="told apart"):
        root_balls(symbol, acb(0.01) + square(0.02), np.array([-0.1, 0.1]))


def test_a_leading_coefficient_that_may_vanish() -> None:
    with precision(64):
        with pytest.raises(PrecisionError, match="leading coefficient"):
            leading(acb_poly([1, acb(0.1) + square(0.2)]), 1)
        with pytest.raises(PrecisionError, match="out of float64"):
            float_roots([acb(1), acb(0)], 1)


def test_nearness_is_told() -> None:
    assert apart(np.array([1.0, 2, 3]))
    assert not apart(np.array([1.0, 1.0001, 3]))
    assert apart(np.array([1.0]))
    assert not apart(np.array([0.0, 0.0]))
