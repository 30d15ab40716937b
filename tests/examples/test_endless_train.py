"""The curve q(κ) closes and its points are roots; roots of long finite trains, found otherwise, lie on their set."""

from __future__ import annotations

import numpy as np
from endless_rows import brute_sum, masses

from endless_train import around, gathering, meeting
from mpsolve.characteristic.floats import Floats
from mpsolve.endless.bloch import Bloch
from mpsolve.endless.growing import find_growing
from mpsolve.problem.reduced import reduce_problem


def test_it_closes_and_crosses_the_real_axis() -> None:
    row = masses("0.4")
    seed = find_growing(row, 1.0)
    assert seed is not None
    theta, sigma = around(Bloch(row), seed.theta, 1j * complex(seed.q), 100)
    assert abs(sigma[-1] - sigma[0]) < 1e-12
    assert sigma.real.max() > 0.0018
    assert sigma.real.min() < -0.005
    k = int(np.argmin(np.abs(sigma - (0.0015 + 0.26j))))
    G = complex(row.reduced.guide.g) * brute_sum(row, row.step * 0, np.exp(1j * theta[k]), sigma[k], 600)
    assert abs(1 + 40 * sigma[k] ** 2 * G) < 1e-4


def test_the_threshold_is_where_one_root_touches_the_axis() -> None:
    """By another way: q(κ) followed round the circle at the ends of the ball comes to the real axis from above."""
    least = []
    for v in ("0.19014", "0.19015"):
        _, sigma = around(Bloch(masses(v)), 2.0502, 0.24948j)  # next to where it is lowest
        least.append(float(np.nanmin((-1j * sigma).imag)))
    assert least[0] > 0 > least[1]
    crossing = 0.19014 + 1e-5 * least[0] / (least[0] - least[1])
    assert abs(crossing - 0.190146901) < 1e-8


def test_the_middle_roots_meet_at_its_end() -> None:
    end = meeting(masses("0.4"), -0.0007 + 0.305j)
    assert end is not None
    a, b = Bloch(masses("0.4")).middle(np.array([end.sigma]))
    assert abs(a - b)[0] < 1e-5
    assert abs(end.sigma - (-0.00073634626876 + 0.30480439040984j)) < 1e-10


def test_roots_of_a_train_lie_along_it() -> None:
    """Newton's method for Δ̂ of 24 masses, from points of the set: it moves by less than their distances."""
    row, count = masses("0.4"), 24
    end = meeting(row, -0.0007 + 0.305j)
    assert end is not None
    angles = np.linspace(0, 2 * np.pi * 5 / count, 51)[1:]
    curve = gathering(row, end, angles)
    a, b = Bloch(row).middle(curve)
    assert np.allclose(np.abs(a), np.abs(b), rtol=1e-9)
    assert np.allclose(np.abs(np.angle(b / a)), angles, atol=1e-6)
    function = Floats(reduce_problem(row.train(count)))
    for j in range(2, 6):
        start = sigma = curve[10 * j - 1 :][:1]
        for _ in range(30):
            value, slope = function.delta(sigma)
            sigma = sigma - value / slope
        apart = abs(curve[10 * j - 1] - curve[10 * j - 11])
        assert abs(sigma - start)[0] < apart
        assert np.abs(curve - sigma).min() < 0.1 * abs(sigma[0] - end.sigma) + 1e-4
