"""K and its slope in balls against residue sums in mpmath; Δ_q against a difference quotient of the oracle's Δ."""

from __future__ import annotations

from typing import Any

import flint
import mpmath
import pytest
from oracle import Truth

from mpsolve import Case
from mpsolve.numbers.balls import precision, rational_ball
from paper.kernels import delta_rate, kernels

CASES = [
    (Case(alpha="0.67", eta_b="0.05", eta_m=("70", "70"), positions=("0", "1.5")), complex(0.4, -0.1)),
    (Case(alpha="0.5", eta_b="0", eta_m=("10", "10"), positions=("0", "2")), complex(0.3, 0)),
    (Case(alpha="0.9", eta_b="0.3", eta_m=("5", "5"), positions=("0", "1"), eta_n="0.2"), complex(0.1, -0.4)),
]


def near(ball: Any, truth: Any) -> bool:
    return abs(complex(ball.mid()) - complex(truth)) < 1e-12 * (1 + abs(complex(truth)))


@pytest.mark.parametrize(("case", "q"), CASES)
def test_kernels_are_residue_sums(case: Case, q: complex) -> None:
    truth, d = Truth(case, 30), float(case.positions[1])
    with precision(160):
        found = kernels(case, flint.acb(q.real, q.imag))
        for (value, rate), gap in ((found.contact, 0), (found.ahead, d), (found.behind, -d)):
            assert near(value, truth.kernel(gap, q))
            assert near(rate, truth.kernel_rate(gap, q))
            assert value.rad() < 1e-30


@pytest.mark.parametrize(("case", "q"), CASES)
def test_the_slope_of_delta(case: Case, q: complex) -> None:
    truth = Truth(case, 40)
    step = mpmath.mpf(10) ** -12
    expected = (truth.delta(truth.mp.mpc(q) + step) - truth.delta(truth.mp.mpc(q) - step)) / (2 * step)
    single = Case(alpha=case.alpha, eta_b=case.eta_b, eta_m=case.eta_m[:1], eta_n=case.eta_n)
    alone = Truth(single, 40)
    expected_alone = (alone.delta(alone.mp.mpc(q) + step) - alone.delta(alone.mp.mpc(q) - step)) / (2 * step)
    with precision(160):
        eta, at = rational_ball(case.eta_m[0].as_fraction()), flint.acb(q.real, q.imag)
        assert near(delta_rate(eta, at, kernels(case, at)), expected)
        assert near(delta_rate(eta, at, kernels(single, at).contact), expected_alone)
