"""Roots of long finite trains, found otherwise, lie on the set where the middle roots have one modulus."""

from __future__ import annotations

import numpy as np
from endless_rows import masses

from mpsolve.characteristic.floats import Floats
from mpsolve.endless.bloch import Bloch
from mpsolve.endless.limit import gathering, meeting
from mpsolve.problem.reduced import reduce_problem


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
