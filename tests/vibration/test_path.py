"""One path: the same points and slopes in floats, mpmath and balls, and where it is put."""

from __future__ import annotations

import math
from itertools import pairwise

import mpmath
import numpy as np
import pytest

from mpsolve.numbers.balls import acb, precision
from mpsolve.vibration.path import Path, above_growth, below_axis, bent, reach_of_waves
from mpsolve.vibration.poles import Poles
from mpsolve.vibration.residues import Pole

PATH = Path(0.1, 1.5, 0.3)


@pytest.mark.parametrize(("name", "x"), [("line", 0.7), ("lifted", 2.3), ("slope", 2.3)])
def test_every_arithmetic_has_the_same_point(name: str, x: float) -> None:
    """The numbers of the path are exact in all of them."""
    mp = mpmath.MPContext()
    mp.dps = 60
    known = getattr(PATH, name)(mp.mpf(x))
    assert getattr(PATH, name)(np.array([x]))[0] == pytest.approx(complex(known), rel=1e-15)
    with precision(250):
        ball = getattr(PATH, name)(acb(x))
    for part, other in ((ball.real, known.real), (ball.imag, known.imag)):
        assert abs(mp.mpf(part.mid().str(65, radius=False)) - other) < mp.mpf(10) ** -55


def test_its_legs_meet_and_their_slopes_are_their_derivatives() -> None:
    upward, leaving = PATH.legs(4.0)
    assert upward.place(upward.last) == pytest.approx(leaving.place(leaving.first), rel=1e-15)
    for leg in (upward, leaving):
        x = leg.first + 0.6 * (leg.last - leg.first)
        change = (leg.place(x + 1e-6) - leg.place(x - 1e-6)) / 2e-6
        assert leg.slope(x) == pytest.approx(change, rel=1e-8)


def test_it_runs_between_cuts_and_axis_away_from_roots_or_above_all_growth() -> None:
    poles = Poles((Pole(-0.05 + 1j), Pole(0.2 + 2j)), -0.09, -0.1, 0, True)
    path = below_axis(poles)
    assert path is not None
    assert path.below
    assert -0.09 < path.alpha < 0
    assert abs(path.alpha + 0.05) > 0.01
    assert path.parted(poles.poles) == ([poles.poles[1]], [poles.poles[0]]) or path.alpha < -0.05
    assert below_axis(Poles(poles.poles, -0.09, -0.1, 0, False)) is None  # a root may be missing
    assert below_axis(Poles(poles.poles, 0.001, 0.0, 0, True)) is None
    above = above_growth(poles.growth, 10.0)
    assert not above.below
    assert above.alpha > 0.2
    assert above.parted(poles.poles) == ([], list(poles.poles))


def test_it_leaves_the_line_above_the_fastest_frequency_and_lower_for_far_contacts() -> None:
    line = Path(0.1)
    assert line.start == math.inf
    tries, far = list(bent(line, 8.0, 0.0)), next(bent(line, 8.0, 5.0))
    assert all(one.start**2 >= 8.0 and one.alpha == 0.1 for one in tries)
    assert all(b.delta < a.delta and b.start > a.start for a, b in pairwise(tries))
    assert far.delta == pytest.approx(0.05)


FIRST = 40.0


def reach(wave, size, time):
    """Next to a large channel at the contact one that is FIRST away."""

    def image(sigma):
        return np.stack([1 / sigma, size / sigma], 1)

    return reach_of_waves(image, wave, [[0.0], [FIRST]], Path(0.0), np.array([time]), 1e-9)


def bending(sigma):
    """P = 2√(iσ), so that d = 40/√ω."""
    return np.stack([-2 * np.sqrt(1j * sigma), -2 * np.sqrt(sigma / 1j)], 1)


def test_short_waves_that_run_ahead_are_followed_as_far_as_they_are_felt():
    early, late = reach(bending, 1.0, 4.0), reach(bending, 1.0, 8.0)
    assert early == pytest.approx(4 * late, rel=0.5)  # ω = (40/t)²
    assert early > 2 * (FIRST / 4.0) ** 2
    assert reach(bending, 1e-12, 4.0) == 0


def test_waves_of_one_velocity_have_a_front_and_need_no_more():
    assert reach(lambda sigma: np.stack([-sigma / 8, sigma / 8], 1), 1.0, 5.0) == 0
