"""Isolated zeros are zeros of the truth, alone in their boxes, and their directions are those of tracked roots."""

from __future__ import annotations

from fractions import Fraction
from typing import Any

import flint
import pytest
from oracle import Truth

from mpsolve import Case
from mpsolve.errors import PrecisionError
from mpsolve.fields import ball_arithmetic
from mpsolve.numbers.exact import Exact
from mpsolve.stability.family import Family
from mpsolve.stability.masses import mass_level
from mpsolve.stability.zero import Zero, approach, isolate, sharpen, slopes, value

PAIR = {"eta_m": (30, 30), "positions": (0, 1)}
ZEROS = {
    "one mass": (Family(Case(alpha=0, eta_b="0.05", eta_m=70), "alpha"), 0.137, 1.075, 1),
    "two masses": (Family(Case(alpha=0, eta_b="0.1", **PAIR), "alpha"), 0.202, 0.974, 1),
    "window opens": (
        Family(Case(alpha=0, eta_b="0.05", eta_m=(50, 50), positions=(0, "1.5")), "alpha"),
        0.18106,
        0.69584,
        1,
    ),
    "window closes": (
        Family(Case(alpha=0, eta_b="0.05", eta_m=(50, 50), positions=(0, "1.5")), "alpha"),
        0.153945,
        0.88609,
        -1,
    ),
    "distance": (Family(Case(alpha="0.99", eta_b="0.1", **PAIR), "distance"), 0.201, 0.929, 1),
    "distance, back": (Family(Case(alpha="0.99", eta_b="0.1", **PAIR), "distance"), 0.199, 1.596, -1),
    "damping": (Family(Case(alpha="0.99", eta_b="0.1", **PAIR), "eta_b"), 0.1947, 0.08, 1),
    "level": (Family(Case(alpha="1.05", eta_b="0.05", eta_m=1), "level"), 0.0911, 0.444, 1),
    "level, two": (
        Family(Case(alpha="0.99", eta_b="0.1", eta_m=(70, 30), positions=(0, "1.1")), "level"),
        0.165,
        0.01426,
        1,
    ),
}
zeros = pytest.mark.parametrize("name", ZEROS)


def found(name: str) -> tuple[Family, Zero, int]:
    family, x, t, direction = ZEROS[name]
    point = approach(family, x, t)
    assert point is not None
    return family, isolate(family, *point), direction


def truth_at(family: Family, t: Any, digits: int) -> Truth:
    """The truth at the parameter t, for a level at the mass level t itself."""
    truth = Truth(family.case, digits)
    t = truth.mp.mpf(t)
    if family.parameter == "level":
        truth.eta_m = [t * eta for eta in truth.eta_m]
    elif family.parameter == "distance":
        truth.x = [k * t for k in range(len(truth.x))]
    else:
        setattr(truth, family.parameter, t)
    return truth


@zeros
def test_a_sharpened_zero_is_a_real_root_of_the_truth(name: str) -> None:
    family, rough, _ = found(name)
    zero = sharpen(family, rough, 40)
    with ball_arithmetic(250):
        t = mass_level(zero) if family.parameter == "level" else zero.t
        t, x = t.mid().str(50, radius=False), zero.x.mid().str(50, radius=False)
    truth = truth_at(family, t, 60)
    q = truth.root(truth.mp.mpf(x) * (1 + truth.mp.mpf(10) ** -20), 1e-15)
    assert abs(q - truth.mp.mpf(x)) < truth.mp.mpf(10) ** -36 * (1 + 1 / abs(q)) * 100
    assert rough.x.overlaps(zero.x)
    assert rough.t.overlaps(zero.t)
    for ball in (zero.x, zero.t):
        assert ball.rad() < abs(ball) * flint.arb(10) ** -40


@zeros
def test_the_direction_is_that_of_a_tracked_root(name: str) -> None:
    """From Im q > 0 to Im q < 0 is +1; for a level along the mass level itself."""
    family, zero, direction = found(name)
    assert zero.direction == direction
    with ball_arithmetic(80):
        t = float((mass_level(zero) if family.parameter == "level" else zero.t).mid())
    heights = [truth_at(family, t * (1 + h), 30).root(float(zero.x.mid())).imag for h in (-1e-5, 1e-5)]
    assert heights[0] * heights[1] < 0
    assert (heights[0] > 0) == (direction > 0)


@zeros
def test_the_hole_lies_in_the_box_of_uniqueness_and_holds_the_zero(name: str) -> None:
    _, zero, _ = found(name)
    x0, x1, t0, t1 = zero.hole
    sides = ((zero.x, x0, x1), (zero.t, t0, t1))
    for (ball, low, high), centre, reach in zip(sides, zero.centre, zero.reach, strict=True):
        assert ball > low
        assert ball < high
        assert centre - Fraction(reach) <= Fraction(low) < Fraction(high) <= centre + Fraction(reach)


@pytest.mark.parametrize("name", ["one mass", "distance", "level, two"])
def test_one_zero_is_found_from_anywhere_in_its_hole(name: str) -> None:
    """Newton's method from inside of the box comes to no other zero in it."""
    family, zero, _ = found(name)
    x0, x1, t0, t1 = zero.hole
    for u, v in ((0.1, 0.9), (0.5, 0.1), (0.9, 0.5)):
        point = approach(family, x0 + u * (x1 - x0), t0 + v * (t1 - t0))
        if point is not None and x0 < float(point[0]) < x1 and t0 < float(point[1]) < t1:
            assert abs(float(point[0] - zero.x.mid())) < 1e-9
            assert abs(float(point[1] - zero.t.mid())) < 1e-9


@zeros
def test_slopes_are_derivatives_of_the_value(name: str) -> None:
    family, x, t, _ = ZEROS[name]
    with ball_arithmetic(300) as field:
        x, t, h = flint.arb(x), flint.arb(t), flint.arb(2) ** -100
        f, along_x, along_t = slopes(family, field, x, t)
        assert f.overlaps(value(family, field, x, t))
        for slope, (dx, dt) in ((along_x, (h, 0)), (along_t, (0, h))):
            rise = value(family, field, x + dx, t + dt) - value(family, field, x - dx, t - dt)
            assert abs(slope - rise / (2 * h)) < 1e-20 * (1 + abs(slope))


def test_where_there_is_no_zero_none_is_isolated() -> None:
    family, *_ = ZEROS["one mass"]
    with pytest.raises(PrecisionError, match="touches the line"):
        isolate(family, flint.arb(0.3), flint.arb(0.8))


def test_a_zero_at_q_0_of_a_level_is_its_own_mirror_image() -> None:
    """F(−q̄, u) = conj F(q, u): real at q = 0, where the imaginary part alone vanishes."""
    family, *_ = ZEROS["level, two"]
    with ball_arithmetic(100) as field:
        for u in ("0.2", "0.5", "0.9"):
            level = Exact(u).ball()
            f = value(family, field, flint.arb(0), level)
            assert f.imag.contains(0)
            one, two = (value(family, field, flint.arb(x), level) for x in ("0.3", "-0.3"))
            assert one.overlaps(two.conjugate())
