"""Where roots of both sides come together between two points, and how much waves turn on the way."""

from __future__ import annotations

import numpy as np

from mpsolve.batch.waves import felt, moved_between, passes_branch


def test_a_branch_point_between_two_points_is_noticed() -> None:
    """z = ±√x through x = 0 on a fine grid, and far away from it."""
    x = np.array([-0.1, 0.1, 1.0, 1.1]) + 0j
    z = np.stack([-np.sqrt(x), np.sqrt(x)], 1)
    assert passes_branch(z, 1).tolist() == [True, True, False]


def test_how_much_a_wave_is_felt() -> None:
    z = np.array([[-0.1 + 2j, -10 + 1j]])
    weight = felt(z, np.array([1.0]), np.array([20.0]))
    assert np.allclose(weight, [[10 * np.exp(-1), np.exp(-10)]])
    assert moved_between(np.array([[1.0, 5], [1.5, 5]]) + 0j, np.array([[2.0, 2]])).tolist() == [1.0]
