from __future__ import annotations

from fractions import Fraction
from typing import Any

import mpmath
import numpy as np
import pytest
from track_models import DAMPED

from mpsolve import Load, Problem, tracks, vehicles
from mpsolve.errors import PrecisionError
from mpsolve.numbers.balls import acb, arb, precision
from mpsolve.vehicles.loads import exact_forces, outer_forces
from mpsolve.vibration.balls.image import PreciseImage
from mpsolve.vibration.forcing import tones, transform
from mpsolve.vibration.image import Image

BEAM = tracks.EulerBernoulli(EI="0.25", m=1, k=1, c="0.1")

PAIR = Problem(BEAM, [vehicles.Mass(20).at(0), vehicles.Mass(20).at(1)], v="0.5")


def test_a_cell_holds_what_float64_has_at_its_corners(balls):
    image = balls(PAIR)
    acting = tones(image.image, outer_forces(image.image.pencil, None), ())
    with precision(image.bits):
        values = image.values(image.cell(acb(arb(0, 0.01), arb(2, 0.02)), acb(0.005, 2)))
    for sigma in (0.009 + 1.985j, -0.009 + 2.015j):
        at = np.array([sigma])
        known = image.image.solve(at, transform(acting, at, image.image.size + image.image.contacts))[0]
        for ball, value in zip(values, known, strict=True):
            assert ball.contains(acb(value.real, value.imag)) or abs(complex(ball.mid()) - value) < float(ball.rad())


def test_names_are_kept_across_a_cut(balls):
    image = balls(PAIR)
    with precision(image.bits):
        cell = image.start(acb(-0.02, 9))
        for k in range(12):
            left = -0.02 - 0.05 * k
            ball = acb(arb(left).union(arb(left - 0.05)), 9)
            cell = image.beside(ball, acb(left, 9), cell)
        beyond = image.within(cell, acb(-0.6, 9))
        assert any(z.real > 0 for z in beyond.roots(acb(-0.6, 9)))  # a wave that would grow ahead


def test_a_pole_in_the_cell_is_refused(balls):
    image = balls(PAIR)
    with precision(image.bits), pytest.raises(PrecisionError):
        image.values(image.cell(acb(arb(0, 0.1), arb(0, 0.1)), acb(0.05, 0)))


def test_next_to_the_axis_the_sides_are_told_by_all_digits(balls):
    """Without damping the p-roots of waves come as close to the imaginary axis as σ̂ does."""
    image = balls(Problem(tracks.EulerBernoulli(EI="0.25", m=1, k=1), vehicles.Mass(20), v="0.5"))
    with precision(image.bits):
        cell = image.start(acb(arb(10) ** -25, 3))
        assert len(cell.upper) == len(cell.lower) == 2
        assert max(float(z.at(cell.ball).real.upper()) for z in cell.upper) < 0


@pytest.mark.parametrize("loads", [None, [Load(2, 1, 3)], {"wheel": Load(0, 1, 3, 1)}])
def test_the_image_is_that_of_the_floats(loads: Any) -> None:
    """The columns of forces and the channels, at one point."""
    problem = Problem(DAMPED["two-layer"], vehicles.Mass(900), v=30)
    image, mp = Image(problem, (Fraction(2),)), mpmath.MPContext()
    mp.dps = 40
    precise = PreciseImage(mp, image, exact_forces(image.pencil, loads), 30)
    sigma = 0.02 + 0.1j
    acting = tones(image, outer_forces(image.pencil, loads), ())
    row = image.solve(np.array([sigma]), transform(acting, np.array([sigma]), 2))[0]
    known = np.array([complex(x) for x in precise(mp.mpc(sigma))])
    assert row == pytest.approx(known, rel=1e-9)
