"""The critical distance against certified spectra beside it, finite differences, and values found another way."""

from __future__ import annotations

from fractions import Fraction

import flint
import mpmath
import numpy as np
import pytest
from oracle import Truth

from mpsolve import Case, InputError
from mpsolve.certificate.sheet import certify_sheet as certify
from mpsolve.fields import ball_arithmetic
from mpsolve.model.branch import track
from mpsolve.stability.curvature import convex_branch, motion_with_distance
from mpsolve.stability.distance import critical_distance
from mpsolve.stability.family import Family
from mpsolve.stability.limiting import limiting_mass


def least_imaginary_part(eta_b: str, d: Fraction) -> float:
    spectrum = certify(Case(alpha="0.99", eta_b=eta_b, eta_m=(70, 70), positions=(0, d)), digits=15)
    assert spectrum.proved
    return min(float(root.q.imag.mid()) for root in spectrum.roots)


@pytest.mark.parametrize(
    ("eta_b", "distance", "least"),
    [
        ("0.5", "1.12328854764", "-0.0378415422527"),
        # α = 0.99, η_M = 70: the paper's "from 1.25 to 1.05" over its range of damping is 1.2453 to 1.0431
        pytest.param("0.04", "1.24525185012", "-0.00492265460905", marks=pytest.mark.slow),
        pytest.param("0.1", "1.21927931299", "-0.0148636000425", marks=pytest.mark.slow),
        pytest.param("0.99", "1.0431090128", "-0.0484667250189", marks=pytest.mark.slow),
    ],
)
def test_the_paper_s_critical_distances(eta_b: str, distance: str, least: str) -> None:
    """Section 4.3; the digits were found by minimisation over root-followed frequencies in mpmath."""
    found = critical_distance("0.99", eta_b, 70, d=("0.5", 2), digits=20)
    assert found.proved, found.reason
    assert abs(float(found.d.mid()) - float(distance)) < 2e-11
    assert abs(float(found.q.imag.mid()) - float(least)) < 2e-13
    assert found.d.rad() < 1e-19
    middle = Fraction(float(found.d.mid())).limit_denominator(10**9)
    here = least_imaginary_part(eta_b, middle)
    assert abs(here - float(least)) < 1e-12
    for step in (Fraction(1, 50), Fraction(-1, 50), Fraction(2, 5), Fraction(-2, 5)):
        assert least_imaginary_part(eta_b, middle + step) > here
    assert found.ranges is not None
    assert [interval.roots for interval in found.ranges] == [2]


def test_bad_input_and_open_cases() -> None:
    with pytest.raises(InputError, match="distance above 0"):
        critical_distance("0.99", "0.1", 70, d=(0, 2))
    with pytest.raises(InputError, match="one mass"):
        critical_distance("0.99", "0.1", (70,), d=(1, 2))
    undamped = critical_distance("0.5", 0, 70, d=(1, 2))
    assert not undamped.proved
    assert "damping" in undamped.reason


def test_a_minimum_at_an_end_of_the_range_is_not_called_one() -> None:
    """On [1.3, 1.6] the least Im q grows with d (η_b = 0.5): its smallest value is at 1.3, no critical point."""
    found = critical_distance("0.99", "0.5", 70, d=("1.3", "1.6"), digits=15)
    assert not found.proved
    assert found.d is None
    assert "towards the end d = 1.3 of the range" in found.reason


def test_first_and_second_derivatives_along_the_distance() -> None:
    d, seed = mpmath.mpf("1.1"), 0.1718 - 0.0378j

    def root_at(x: mpmath.mpf) -> mpmath.mpc:
        place = Fraction(str(x))
        case = Case(alpha="0.99", eta_b="0.5", eta_m=(70, 40), positions=(0, place))
        return Truth(case, 60).root(seed)

    h = mpmath.mpf("1e-12")
    with mpmath.workdps(60):
        low, middle, high = (mpmath.mpmathify(root_at(x)) for x in (d - h, d, d + h))
        first, second = (high - low) / (2 * h), (high - 2 * middle + low) / h**2
    with ball_arithmetic(150) as field:
        model = track(Case(alpha="0.99", eta_b="0.5", eta_m=(70, 40), positions=(0, "1.1")), field)
        q = flint.acb(str(middle.real), str(middle.imag)).mid()
        found = motion_with_distance(model, q, flint.arb("1.1").mid())
        assert abs(complex(found[0].mid()) - complex(first)) < 1e-15
        assert abs(complex(found[1].mid()) - complex(second)) < 1e-9


def test_a_branch_is_not_proved_where_another_root_is_followed() -> None:
    family = Family(Case(alpha="0.99", eta_b="0.5", eta_m=(70, 70), positions=(0, 1)), "distance")
    edges = np.linspace(1.1, 1.12, 33)
    q = 0.17172107734869773467 - 0.037841542252689335739j  # the root at 1.1232885…
    assert not convex_branch(family, edges, np.full(len(edges), q + 0.05))


def test_limiting_mass_is_the_first_crossing() -> None:
    """21.9 of Section 4.3 belongs to d = 1.1; at the critical distance the limiting mass is smaller."""
    found = limiting_mass("0.99", "0.1", (0, "1.1"), digits=15)
    assert found.proved
    assert found.eta.str(15, radius=False) == "21.8853725139908"
    assert 20.7 < float(limiting_mass("0.99", "0.1", (0, "1.219279")).eta.mid()) < 20.8
    stable = limiting_mass("0.9", "0.1", (0,))
    assert stable.proved
    assert stable.eta is None
