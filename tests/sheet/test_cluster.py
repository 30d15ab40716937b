"""Multiple and nearly multiple roots: two masses far apart."""

from __future__ import annotations

import math

import pytest
from oracle import Truth, holds

from mpsolve import Case
from mpsolve.sheet.cluster import separate


@pytest.mark.parametrize("d", [20, 40, 60, 100])
@pytest.mark.parametrize("digits", [15, 30])
def test_two_far_masses_have_a_close_pair_of_roots(d: int, digits: int) -> None:
    """Each near the single mass's root; they come apart like e^{−cd} until the digits cannot tell them."""
    case = Case(alpha="0.5", eta_b="0.05", eta_m=(70, 70), positions=(0, d))
    single = Truth(Case(alpha="0.5", eta_b="0.05", eta_m=70), 60).root(0.1548 + 0.0016j)
    balls = separate(case, complex(single), digits)
    assert sum(ball.multiplicity for ball in balls) == 2
    assert len(balls) == 2 or holds(balls[0].q, single)
    for k, ball in enumerate(balls):
        assert (ball.q - ball.q.mid()).abs_upper() <= 10.0**-digits * ball.q.abs_upper()
        assert abs(complex(ball.q.mid()) - complex(single)) < 1e-3
        assert not any(ball.q.overlaps(other.q) for other in balls[:k])


def test_separated_roots_hold_the_true_ones() -> None:
    case = Case(alpha="0.5", eta_b="0.05", eta_m=(70, 70), positions=(0, 40))
    truth = Truth(case, 80)
    balls = separate(case, 0.15484109 + 0.0016363620j, 30)
    assert len(balls) == 2
    for ball in balls:
        assert holds(ball.q, truth.root(truth.middle(ball.q), 1e-25))


def test_a_simple_root_is_no_cluster() -> None:
    case = Case(alpha="0.5", eta_b="0.05", eta_m=70)
    (ball,) = separate(case, 0.15484109 + 0.0016363620j, 20)
    assert ball.multiplicity == 1
    assert math.isclose(float(ball.q.real.mid()), 0.1548411, rel_tol=1e-6)


def test_nothing_is_found_where_there_is_no_root() -> None:
    assert separate(Case(alpha="0.5", eta_b="0.05", eta_m=70), 0.4 - 0.2j, 15) == []
