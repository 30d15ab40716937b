"""Root balls: they hold the root of (26), (37), are as sharp as asked, and know their symmetry."""

from __future__ import annotations

from typing import Any

import flint
import pytest
from oracle import Truth, holds

from mpsolve import Case
from mpsolve.errors import PrecisionError
from mpsolve.fields import ball_arithmetic
from mpsolve.numbers.rootball import Symmetry
from mpsolve.sheet.enclose import isolate, refine
from mpsolve.sheet.seek import seek

PAIR = {"eta_m": (70, 70), "positions": (0, "1.5")}
CASES = {
    "one mass": {"alpha": "0.5", "eta_b": "0.05", "eta_m": 70},
    "two masses": {"alpha": "0.67", "eta_b": "0.05", **PAIR},
    "three masses": {"alpha": "1.2", "eta_b": "0.2", "eta_m": (10, 3, 7), "positions": (0, 1, 3)},
    "undamped, subcritical": {"alpha": "0.5", "eta_b": 0, **PAIR},
    "undamped, supercritical": {"alpha": "1.2", "eta_b": 0, **PAIR},
}
named = pytest.mark.parametrize("name", CASES)


def relative_radius(ball: Any, digits: int) -> bool:
    with ball_arithmetic(4 * digits + 100):
        return bool((ball - ball.mid()).abs_upper() <= ball.abs_lower() * flint.arb(10) ** -digits)


def roots_of(case: Case) -> list[complex]:
    return [candidate.q for candidate in seek(case, 20.0)]


@named
@pytest.mark.parametrize("digits", [15, 30, 60])
def test_balls_hold_the_true_root_and_are_sharp(name: str, digits: int) -> None:
    case = Case(**CASES[name])
    truth = Truth(case, 2 * digits)
    seeds = roots_of(case)
    assert seeds
    for seed in seeds:
        box = isolate(case, seed)
        ball = refine(case, box, digits)
        exact = truth.root(truth.middle(ball.q), 1e-12)
        if ball.symmetry is Symmetry.REAL:
            assert abs(exact.imag) < truth.mp.mpf(10) ** (-digits - 5)
            exact = truth.mp.mpc(exact.real)
        assert ball.multiplicity == 1
        assert holds(ball.q, exact)
        assert holds(box.q, exact)
        assert box.q.contains(ball.q)
        assert relative_radius(ball.q, digits)


@named
def test_no_number_of_digits_is_missed(name: str) -> None:
    """The ladder of precisions never asks more of a Newton step than the one before has given."""
    case = Case(**CASES[name])
    for seed in roots_of(case):
        box = isolate(case, seed)
        for digits in (*range(15, 100), *range(100, 400, 13)):
            assert relative_radius(refine(case, box, digits).q, digits)


def test_a_thousand_digits() -> None:
    case = Case(**CASES["two masses"])
    (seed, _) = roots_of(case)
    ball = refine(case, isolate(case, seed), 1000)
    assert relative_radius(ball.q, 1000)
    assert not relative_radius(ball.q, 1010)  # no wider certificate than was asked for
    truth = Truth(case, 1100)
    assert holds(ball.q, truth.root(truth.middle(ball.q), truth.mp.mpf(10) ** -400))


def test_undamped_subcritical_roots_are_real() -> None:
    """Section 4.2: real roots below q_lm; a box that is symmetric to the axis and holds one root."""
    case = Case(**CASES["undamped, subcritical"])
    for seed in roots_of(case):
        ball = refine(case, isolate(case, seed), 30)
        assert ball.symmetry is Symmetry.REAL
        assert ball.q.imag == 0
        assert ball.mirrored.symmetry is Symmetry.REAL


def test_complex_roots_are_not_taken_for_real_ones() -> None:
    for name in ("undamped, supercritical", "two masses"):
        case = Case(**CASES[name])
        assert all(isolate(case, seed).symmetry is Symmetry.NONE for seed in roots_of(case))


def test_a_mirrored_ball_is_the_root_at_minus_conjugate() -> None:
    case = Case(**CASES["two masses"])
    seed = roots_of(case)[0]
    ball = refine(case, isolate(case, seed), 30)
    assert holds(ball.mirrored.q, -Truth(case, 60).root(seed).conjugate())
    assert relative_radius(ball.mirrored.q, 30)
    assert ball.mirrored.mirrored.q.str(40) == ball.q.str(40)


@pytest.mark.parametrize("seed", [1 - 1j, 5 - 3j])
def test_no_box_where_there_is_no_root(seed: complex) -> None:
    """Newton's method may lead to a root from there; then the box holds that root, and else it is refused."""
    case = Case(**CASES["one mass"])
    try:
        box = isolate(case, seed)
    except PrecisionError:
        return
    assert holds(box.q, Truth(case, 60).root(complex(box.image.mid())))
