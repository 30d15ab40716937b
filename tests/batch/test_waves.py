"""p-roots of many polynomials against numpy's, one by one; sides; where roots of both sides come together."""

from __future__ import annotations

import numpy as np
import pytest

from mpsolve.batch.waves import by_companions, felt, first_roots, from_near, moved_between, passes_branch, upper_first


def random(n: int, degree: int, seed: int = 0) -> np.ndarray:
    rng = np.random.default_rng(seed)
    return rng.normal(size=(n, degree + 1)) + 1j * rng.normal(size=(n, degree + 1))


@pytest.mark.parametrize("degree", [1, 2, 4, 7])
def test_roots_from_nothing_and_from_a_neighbour(degree: int) -> None:
    D = random(50, degree)
    plain = np.array([np.sort_complex(np.roots(row[::-1])) for row in D])
    assert np.allclose(np.sort_complex(by_companions(D)), plain)
    moved = D * (1 + 0.01 * random(50, degree, 1))
    expected = np.array([np.sort_complex(np.roots(row[::-1])) for row in moved])
    assert np.allclose(np.sort_complex(from_near(moved, by_companions(D))), expected)


def test_small_roots_beside_large_ones_are_as_exact() -> None:
    z = np.array([[1e-3 + 2e-3j, -2e-3 + 1e-3j, 5e3 + 1j]])
    D = np.array([np.poly(z[0])[::-1]])
    found = np.sort_complex(from_near(D, z * 1.01))
    assert np.allclose(found, np.sort_complex(z), rtol=1e-11, atol=0)


def test_upper_roots_stand_first_and_waves_on_the_axis_by_their_drift() -> None:
    z = np.array([[3.0, -1 + 1j, 2j, -2, -3j]])
    side = upper_first(z, 3, lambda _, at: np.where(at == 2j, 1.0, -1.0) + 0j)
    assert set(side[0, :3].tolist()) == {-2, -1 + 1j, -3j}
    assert set(upper_first(z, 2, lambda *_: 0j)[0, :2].tolist()) == {-2, -1 + 1j}


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


def test_first_roots_of_quartics_with_known_roots() -> None:
    rng = np.random.default_rng(3)
    z = rng.normal(size=(200, 4)) + 1j * rng.normal(size=(200, 4))
    z[:50, 3] = -z[:50, :3].sum(1)  # no cubic term
    z[50:80, 2:] = -z[50:80, :2]  # even
    D = np.array([np.poly(row)[::-1] for row in z]) * 3.0
    found = first_roots(D)
    distance = np.abs(found[:, :, None] - z[:, None, :])
    assert distance.min(1).max() < 1e-4
    assert distance.min(2).max() < 1e-4
