from fractions import Fraction

import numpy as np
import pytest

from mpsolve import tracks
from mpsolve.errors import PrecisionError
from mpsolve.numbers.balls import acb, arb, precision
from mpsolve.problem.reduced import track_guide
from mpsolve.vibration.balls.polygon import far_roots

TRACKS = [
    (tracks.EulerBernoulli(EI="0.25", m=1, k=1, c="0.1"), "1.2", 3000),
    (
        tracks.TwoLayer(EI="6.4e6", m=60, m_sleeper=150, k_pad="1e8", c_pad="5e4", k_ballast="5e7", c_ballast="1e5"),
        60,
        3000,
    ),
    (tracks.String(T=2, m=1, k=1, c="0.2"), "0.5", 100),
]


@pytest.mark.parametrize(("track", "v", "radius"), TRACKS)
def test_every_root_lies_in_a_ball_of_its_own_and_no_other(track, v, radius):
    guide = track_guide(track, Fraction(v))
    with precision(120):
        far = far_roots(guide.D, guide.N, guide.v, arb(radius))
        for size in (1.0, 3.7, 100.0):
            sigma = complex(-0.2, 1.0) * radius * size
            rows = np.zeros(guide.degree + 1, complex)
            for (i, j), c in guide.D.items():
                rows[i] += float(c) * sigma**j
            known = np.roots(rows[::-1])
            balls = [root.at(acb(sigma.real, sigma.imag)) for root in far]
            held = [
                [abs(complex(ball.mid()) - z) <= float(ball.rad()) * 1.5 + 1e-3 * abs(z) for z in known]
                for ball in balls
            ]
            assert len(far) == guide.degree
            assert np.any(held, 1).all()
            assert np.any(held, 0).all()


def test_a_radius_that_is_too_small_is_refused():
    guide = track_guide(TRACKS[0][0], Fraction("1.2"))
    with precision(120), pytest.raises(PrecisionError, match="told apart"):
        far_roots(guide.D, guide.N, guide.v, arb(2))


def test_waves_of_a_beam_neither_grow_nor_decay_to_leading_order():
    guide = track_guide(TRACKS[0][0], Fraction("1.2"))
    with precision(120):
        far = far_roots(guide.D, guide.N, guide.v, arb(3000))
    assert [root.neutral for root in far].count(True) == 2
    assert {root.gamma for root in far} == {Fraction(3, 2)}
