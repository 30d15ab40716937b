"""Loads and places in balls: exact numbers, irrational places on their side of each contact."""

import cmath
from fractions import Fraction

import pytest

from mpsolve import Exact, Load, Problem, tracks, vehicles
from mpsolve.errors import PrecisionError
from mpsolve.numbers.balls import arb, precision
from mpsolve.vehicles.loads import exact_forces
from mpsolve.vibration.balls.equations import Equations
from mpsolve.vibration.image import Image

ONE = Problem(tracks.EulerBernoulli(EI="0.25", m=1, k=1, c="0.1"), vehicles.Mass(20), v="0.5")
LOADS = [Load(1, 2, "-0.5", "0.25")]


def test_an_irrational_place_is_where_it_is_and_not_where_floats_have_it() -> None:
    root = Exact.sqrt(2)
    image = Image(ONE, (Fraction(float(root)),))
    own = Equations(image, exact_forces(ONE.pencil, LOADS), 30, (root,))
    with precision(own.bits):
        away = own.away[own.seen[0]] * arb(2) ** image.guide.length
        assert away.overlaps(arb(2).sqrt())
        assert 0 < away.rad() < 1e-15
    near = Exact.root4(Fraction(2, 10**800))
    with pytest.raises(PrecisionError, match="too close to a contact"):
        Equations(Image(ONE, (Fraction(0),)), exact_forces(ONE.pencil, LOADS), 30, (near,))


def test_loads_are_their_tones_and_bounded_far_out() -> None:
    own = Equations(Image(ONE, ()), exact_forces(ONE.pencil, LOADS), 30)
    rates = [float(rate.real) * own.image.rate for rate, _ in own.tones()]
    assert rates == pytest.approx([0, 0.5])
    with precision(own.bits):
        (ball,) = own.far_forces(arb(100))
        sigma = 150j  # σ û of c + a sin(ωt + φ), ω = −0.5
        omega = -0.5 / own.image.rate
        wave = 2 * sigma * (omega * cmath.cos(0.25) + sigma * cmath.sin(0.25)) / (sigma**2 + omega**2)
        assert abs(complex(ball.mid()) - (1 + wave)) <= float(ball.rad()) * 1.5
        with pytest.raises(PrecisionError, match="high frequency"):
            own.far_forces(arb("0.1") * -omega)
