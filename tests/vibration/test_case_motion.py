from __future__ import annotations

import numpy as np
import pytest

from mpsolve import Case, InputError, PhysicalCase, certify, response
from mpsolve.numbers.exact import Exact
from mpsolve.vehicles.load import Load
from mpsolve.vibration.case_balls import balls_of_case
from mpsolve.vibration.case_motion import Scale, modulus, rounded, units_of


def test_the_modulus_bounds_the_sum_of_waves():
    tau = np.linspace(0, 50, 501)
    pairs = [(0.3 + 0.01j, np.array([1 - 2j])), (0.5 + 0j, np.array([0.5j]))]
    wave = sum((a[0] * np.exp(1j * q * tau)).real for q, a in pairs)
    assert np.all(np.abs(wave) <= modulus(pairs, tau)[0] + 1e-12)
    assert modulus(pairs[1:], tau)[0] == pytest.approx(0.5)


RAIL = PhysicalCase(EI="6.4e6", m=60, k="1e6", c=800, v=100, masses=[(900, 0)])


def test_a_physical_case_is_done_in_si_and_told_in_ratios() -> None:
    """The ratios in float64 are a problem of their own: another one, to the rounding of float64."""
    tau, xi = (5, 20), (0, -1.5)
    ratios = Case(
        alpha=float(RAIL.dimensionless.alpha),
        eta_b=float(RAIL.dimensionless.eta_b),
        eta_m=float(RAIL.dimensionless.eta_m[0]),
    )
    weight = 900 * 9.80665
    found, other = response(RAIL, xi=xi, tau=tau), response(ratios, [Load(weight)], xi=xi, tau=tau)
    for part in ("w", "steady", "harmonic", "velocity", "acceleration", "contact_forces"):
        assert getattr(found, part) == pytest.approx(getattr(other, part), rel=1e-7)
    assert found.harmonic_pairs[0].q == pytest.approx(other.harmonic_pairs[0].q, rel=1e-9)
    known = response(RAIL, xi=xi, tau=tau, spectrum=certify(RAIL, check=False))  # its roots are in rad/s
    assert known.w == pytest.approx(found.w, rel=1e-8)


def test_irrational_ratios_and_places_are_in_the_balls() -> None:
    assert not RAIL.dimensionless.alpha.is_rational
    balls = balls_of_case(RAIL, xi=(0, "-1.5"), tau=(5,), digits=3)
    found = response(RAIL, xi=(0, -1.5), tau=(5,))
    assert max(float(x.rad()) for x in np.ravel(balls.w)) < 1
    for ball, value in zip(np.ravel(balls.w), np.ravel(found.w), strict=True):
        assert abs(float(ball.mid()) - value) < 1e-8 * np.abs(found.w).max() + float(ball.rad())


def test_what_is_irrational_without_units_is_rounded_or_refused() -> None:
    lost = Case(alpha=Exact.root4(2), eta_b="0.1", eta_m=5)
    assert float(units_of(lost).problem.v) == float(Exact.root4(2))
    assert rounded(Exact("0.3")) * 10 == 3
    with pytest.raises(InputError, match="irrational"):
        units_of(lost, exact=True)


def test_units_of_a_physical_case():
    scale = Scale.of(PhysicalCase(EI="6.4e6", m=60, k="1e6", c=0, kp=0, N=0, v=50, masses=[(1000, 0)]))
    assert scale.physical
    assert scale.time == pytest.approx((60 / 1e6) ** 0.5)
    assert scale.force == 1e-3
    assert not Scale().physical
    assert "w_st" in Scale().said
