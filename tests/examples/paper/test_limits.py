"""q_lm against a search over wavenumbers in mpmath, and 0 at α_C."""

from __future__ import annotations

from fractions import Fraction

import mpmath
import pytest

from mpsolve import Case
from mpsolve.numbers.balls import precision, rational_ball
from paper.limits import critical_velocity_ratio, limiting_frequency


@pytest.mark.parametrize(
    ("alpha", "eta_b", "axial"),
    [("0.5", "0.3", "0"), ("0.9", "0.1", "0.3"), ("1.2", "0", "-0.5"), ("0", "0.1", "0.4"), ("0", "0.1", "-0.4")],
)
def test_the_least_of_all_waves(alpha: str, eta_b: str, axial: str) -> None:
    mp = mpmath.MPContext()
    mp.dps = 40
    a, b, N = mp.mpf(alpha), mp.mpf(eta_b), mp.mpf(axial)

    def frequency(p: object) -> object:
        return mp.sqrt(p**4 - 4 * N * p**2 + 4 * (1 - b**2)) / 2 - a * p

    best = min((k for k in range(4000)), key=lambda k: float(frequency(mp.mpf(k) / 1000)))
    p = mp.mpf(best) / 1000
    if best:
        p = mp.findroot(lambda x: mp.diff(frequency, x), p)
    found = limiting_frequency(Case(alpha=alpha, eta_b=eta_b, eta_m=1, eta_n=axial))
    assert abs(mp.mpf(found.mid().str(35, radius=False)) - frequency(p)) < mp.mpf(10) ** -30
    assert found.rad() < 1e-30


def test_the_cuts_join_where_it_is_zero() -> None:
    case = Case(alpha="0.7", eta_b="0.6", eta_m=1, eta_n="0.31")
    with precision(128):
        assert critical_velocity_ratio(case).contains(rational_ball(Fraction(7, 10)))
    assert limiting_frequency(case).contains(0)
