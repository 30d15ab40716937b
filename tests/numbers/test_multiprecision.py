"""mpmath in a context of its own."""

from __future__ import annotations

from fractions import Fraction

import mpmath
import pytest
from flint import arb
from multiprecision import Multiprecision

from mpsolve.numbers.multiprecision import Rule, middle


def test_digits_do_not_leak() -> None:
    before = mpmath.mp.dps
    K = Multiprecision(60)
    assert abs(K.number(Fraction(1, 3)) * 3 - 1) < K.mp.mpf(10) ** -59
    assert abs(K.exp(K.matrix([[K.number(Fraction(1))]]))[0, 0] - K.mp.e) < K.mp.mpf(10) ** -58
    assert mpmath.mp.dps == before


def test_the_middle_of_a_ball_is_exact() -> None:
    ball = arb((-(3**80), -200))
    assert middle(MP, ball) == -(MP.mpf(3) ** 80) / MP.mpf(2) ** 200
    assert middle(MP, arb(0)) == 0


MP = mpmath.MPContext()
MP.dps = 50
RULE = Rule(MP, 40)


def test_the_rule_integrates_polynomials() -> None:
    for power in (0, 8, 78):
        found = MP.fdot(RULE.weights, [x**power for x in RULE.nodes])
        assert abs(found - MP.mpf(2) / (power + 1)) < 1e-46


@pytest.mark.parametrize("z", [0, "0.01", 3, "38.5", "41.5", 900])
def test_moments_are_spherical_bessel_functions(z: object) -> None:
    x = MP.mpf(str(z))
    found = RULE.moments(x)
    for k in (0, 1, 20, 39):
        truth = (
            2
            * MP.mpc(0, 1) ** k
            * (MP.sqrt(MP.pi / (2 * x)) * MP.besselj(k + MP.mpf(1) / 2, x) if x else int(k == 0))
        )
        assert abs(found[k] - truth) < 1e-42


def test_a_series_reproduces_its_function() -> None:
    values = [MP.exp(x / 3) for x in RULE.nodes]
    total = MP.fdot(RULE.series(values), [MP.legendre(k, MP.mpf("0.3")) for k in range(40)])
    assert abs(total - MP.exp(MP.mpf("0.1"))) < 1e-45
