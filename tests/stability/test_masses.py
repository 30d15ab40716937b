"""Crossing masses against single certified cases, tracked roots and limits."""

from __future__ import annotations

from fractions import Fraction
from typing import Any

import flint
import pytest
from oracle import Truth

from mpsolve import Case
from mpsolve.certificate.sheet import certify_sheet as certify
from mpsolve.errors import InputError
from mpsolve.fields import ball_arithmetic
from mpsolve.stability.masses import CrossingMasses, crossing_masses

CASES: dict[str, tuple[Any, ...]] = {
    "one mass": ("1.05", "0.05", 0, None),
    "two masses": ("0.99", "0.1", (0, "1.1"), None),
    "unequal masses": ("0.99", "0.1", (0, "1.1"), (70, 30)),
    "a window": ("1.097", "0.05", (0, "2.5"), None),
    "below, d = 1.5": ("0.9", "0.05", (0, "1.5"), None),
}


def solved(name: str) -> CrossingMasses:
    alpha, eta_b, positions, proportions = CASES[name]
    return crossing_masses(alpha, eta_b, positions, proportions)


def unstable(name: str, level: Fraction) -> int | None:
    alpha, eta_b, positions, proportions = CASES[name]
    places = positions if isinstance(positions, tuple) else (positions,)
    shares = proportions or (1,) * len(places)
    case = Case(alpha=alpha, eta_b=eta_b, eta_m=[level * share for share in shares], positions=places)
    return certify(case, digits=15, region="unstable").unstable


def level(ball: Any, digits: int = 20) -> Fraction:
    with ball_arithmetic(200):
        return Fraction(ball.str(digits, radius=False))


@pytest.mark.parametrize("name", CASES)
def test_counts_just_below_and_above_each_crossing(name: str) -> None:
    """As single cases have them, 10⁻⁶ to each side; and far above all."""
    result = solved(name)
    assert result.proved
    assert len(result.counts) == len(result) + 1
    assert result.counts[0] == 0
    assert min(result.counts) >= 0
    for k, crossing in enumerate(result):
        eta = level(crossing.eta)
        assert unstable(name, eta * (1 - Fraction(1, 10**6))) == result.counts[k]
        assert unstable(name, eta * (1 + Fraction(1, 10**6))) == result.counts[k + 1]
        assert result.counts[k + 1] - result.counts[k] == 2 * crossing.direction
    top = level(result[-1].eta) if len(result) else Fraction(1)
    assert unstable(name, round(top * 10)) == result.counts[-1]


@pytest.mark.parametrize("name", ["two masses", "unequal masses", "a window"])
def test_the_crossing_root_is_real_and_goes_the_way_it_says(name: str) -> None:
    alpha, eta_b, positions, proportions = CASES[name]
    for crossing in solved(name):
        eta, q = level(crossing.eta, 45), level(crossing.q, 45)
        case = Case(alpha=alpha, eta_b=eta_b, eta_m=proportions or (1, 1), positions=positions)
        truth = Truth(case, 50)
        mp, shares = truth.mp, truth.eta_m
        level_mp = mp.mpf(eta.numerator) / eta.denominator
        heights = []
        for change in (-(mp.mpf(10) ** -8), 0, mp.mpf(10) ** -8):
            truth.eta_m = [level_mp * (1 + change) * share for share in shares]
            heights.append(truth.root(mp.mpf(q.numerator) / q.denominator).imag)
        assert abs(heights[1]) < mp.mpf(10) ** -28
        assert heights[0] * crossing.direction > 0 > heights[2] * crossing.direction


def test_a_known_crossing_mass() -> None:
    (crossing,) = solved("two masses")
    with ball_arithmetic(200):
        assert crossing.eta.overlaps(flint.arb("21.885372513990844653952782919388 +/- 1e-30"))
        assert crossing.eta.rad() < 1e-28
    assert crossing.direction == 1


@pytest.mark.parametrize("digits", [15, 60])
def test_digits_are_those_asked_for(digits: int) -> None:
    (crossing,) = crossing_masses("0.99", "0.1", (0, "1.1"), digits=digits)
    (other,) = solved("two masses")
    assert crossing.eta.overlaps(other.eta)
    for ball in (crossing.eta, crossing.q):
        assert ball.rad() < abs(ball) * flint.arb(10) ** -digits


@pytest.mark.parametrize(("alpha", "eta_b"), [("0.3", "0.01"), ("0.7", "0.2"), ("0.95", "0.1"), ("0.5", "0.7")])
def test_one_damped_mass_is_stable_below_the_critical_velocity(alpha: str, eta_b: str) -> None:
    result = crossing_masses(alpha, eta_b, 0)
    assert result.proved
    assert len(result) == 0
    assert result.counts == (0,)


def test_masses_that_are_close_act_as_their_sum() -> None:
    (single,) = crossing_masses("1.05", "0.1", 0)
    (merged,) = crossing_masses("1.05", "0.1", (0, 0), (1, 1))
    (near,) = crossing_masses("1.05", "0.1", (0, "0.05"))
    assert merged.eta.overlaps(single.eta / 2)
    assert abs(float(2 * near.eta / single.eta) - 1) < 0.04
    assert not near.eta.overlaps(merged.eta)


def test_proportions_are_a_scale_of_the_level_in_either_order() -> None:
    (one,) = crossing_masses("0.99", "0.1", (0, "1.1"), (7, 3))
    (swapped,) = crossing_masses("0.99", "0.1", (0, "1.1"), (30, 70))
    assert one.eta.overlaps(10 * swapped.eta)  # Δ of two masses depends on the distance and the product alone


@pytest.mark.parametrize("positions", [0, (0, 1), (0, "0.5", 2)])
def test_without_damping_no_mass_is_unstable_below_the_critical_velocity(positions: Any) -> None:
    """The conserved energy in the moving frame is positive."""
    result = crossing_masses("0.9", 0, positions)
    assert result.proved
    assert (len(result), result.counts) == (0, (0,))


@pytest.mark.parametrize("alpha", ["1", "1.2"])
def test_without_damping_above_the_critical_velocity_nothing_is_claimed(alpha: str) -> None:
    result = crossing_masses(alpha, 0, 0)
    assert not result.proved
    assert result.counts == (None,)
    assert "damping" in result.reason


def test_tension_moves_the_critical_velocity() -> None:
    """α_C = √(1 − N): N = −0.44 gives 1.2."""
    assert crossing_masses("1.19", 0, 0, eta_s="0.44").proved
    assert not crossing_masses("1.21", 0, 0, eta_s="0.44").proved
    assert not crossing_masses("1.2", 0, 0, eta_s="0.44").proved


@pytest.mark.parametrize("digits", [14, 10_001, 15.5, "30"])
def test_digits_out_of_bounds_are_refused(digits: Any) -> None:
    with pytest.raises(InputError, match="digits"):
        crossing_masses("0.99", "0.1", (0, 1), digits=digits)


@pytest.mark.slow
@pytest.mark.parametrize("alpha", ["0.99", "1.05"])
def test_three_masses(alpha: str) -> None:
    positions = (0, "0.8", "1.6")
    result = crossing_masses(alpha, "0.2", positions)
    if not result.proved:
        assert result.reason
        return
    for k, crossing in enumerate(result):
        for side, count in ((-1, result.counts[k]), (1, result.counts[k + 1])):
            eta = level(crossing.eta) * (1 + Fraction(side, 10**6))
            case = Case(alpha=alpha, eta_b="0.2", eta_m=(eta,) * 3, positions=positions)
            assert certify(case, digits=15, region="unstable").unstable == count
