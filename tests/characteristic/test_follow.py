"""p-roots of many polynomials against numpy's, one by one, where two meet or the path is coarse too; their sides."""

from __future__ import annotations

import numpy as np
import pytest

from mpsolve.characteristic.follow import cancelled, eigenvalues, first_roots, followed, from_near, upper_first


def _sorted(z: np.ndarray) -> np.ndarray:
    return np.array([np.sort_complex(row) for row in np.round(z, 10)])


@pytest.mark.parametrize("rows", [3, 11, 200])
def test_the_roots_of_every_row(rows: int) -> None:
    t = np.linspace(0, 3, rows)
    true = np.stack([np.exp(1j * t), 3 + t, -2j - 0.2 * t, 0.01 * (1 + t)], 1)
    D = np.array([np.poly(row)[::-1] * (2 + 1j) for row in true])
    assert _sorted(followed(D)) == pytest.approx(_sorted(true), abs=1e-8)
    assert _sorted(eigenvalues(D)) == pytest.approx(_sorted(true), abs=1e-8)


def test_no_root_is_taken_twice() -> None:
    """The rows have nothing to do with each other: where Newton falls into one root twice, eigenvalues take over."""
    rng = np.random.default_rng(5)
    true = rng.normal(size=(100, 5)) + 1j * rng.normal(size=(100, 5))
    D = np.array([np.poly(row)[::-1] for row in true])
    found = followed(D)
    apart = np.abs(found[:, :, None] - true[:, None, :]).min(1)
    assert apart.max() < 1e-7


def random(n: int, degree: int, seed: int = 0) -> np.ndarray:
    rng = np.random.default_rng(seed)
    return rng.normal(size=(n, degree + 1)) + 1j * rng.normal(size=(n, degree + 1))


@pytest.mark.parametrize("degree", [1, 2, 4, 7])
def test_roots_from_nothing_and_from_a_neighbour(degree: int) -> None:
    D = random(50, degree)
    plain = np.array([np.sort_complex(np.roots(row[::-1])) for row in D])
    assert np.allclose(np.sort_complex(eigenvalues(D)), plain)
    moved = D * (1 + 0.01 * random(50, degree, 1))
    expected = np.array([np.sort_complex(np.roots(row[::-1])) for row in moved])
    assert np.allclose(np.sort_complex(from_near(moved, eigenvalues(D))), expected)


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


def test_residues_of_close_roots_of_one_side_cancel() -> None:
    """A pair 1e-4 apart loses (1e4)³ of 2⁻⁵³, wherever its residues are not faint beside another one."""
    z = np.array([[-1, -1.0001, 1], [-1, -2, -1.0001], [-1, -1.2, 1], [-1, -1.0001, 1]]) + 0j
    w = np.array([[1, -1, 1e-4], [1, 1, 1], [5, -5, 1], [1e-6, -1e-6, 1]]) + 0j
    assert cancelled(z, w, 2, False, 1e-5).tolist() == [0]
    assert cancelled(z, w, 2, True, 1e-3).tolist() == [0]
    assert not len(cancelled(z, w, 2, False, 1e-3))
    z[0], z[2, 0], z[3] = 0, np.inf, np.nan  # what float64 does not hold is left as it is
    assert not len(cancelled(z, w, 2, False, 1e-5))
