"""Sums of waves against each pair by itself: equal gaps, contacts at one place, waves that leave float64's range."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

from mpsolve.batch.wave_sums import felt, moved_between, passes_branch, wave_sums

UP = 2


def waves(points: int = 7, scale: float = 1.0) -> tuple[Any, Any]:
    rng = np.random.default_rng(3)
    z = scale * (rng.normal(size=(points, 5)) + 1j * rng.normal(size=(points, 5)))
    z.real = np.abs(z.real) * np.where(np.arange(5) < UP, -1, 1)  # e^{zξ} decays on its own side
    weights = tuple(rng.normal(size=z.shape) + 1j * rng.normal(size=z.shape) for _ in range(3))
    return z, weights


@pytest.mark.parametrize("scale", [1.0, 900.0])
@pytest.mark.parametrize("places", [[0, 1, 2, 3], [0, 0.3, 2, 2.5], [0, 0, 1, 1], [0, 1, 1, 1], [0]])
def test_each_pair_by_itself(places: list[float], scale: float) -> None:
    z, (w, a, b) = waves(scale=scale)
    x = np.tile(np.array(places, float), (len(z), 1))
    with np.errstate(all="ignore"):
        G, slope = wave_sums(z, (w, a, b), x, UP)
        assert wave_sums(z, (w, None, None), x, UP)[1] is None
    for i, here in enumerate(places):
        for j, there in enumerate(places):
            side, sign = (slice(0, UP), 1) if here >= there else (slice(UP, None), -1)
            e = sign * np.exp(z[:, side] * (here - there))
            assert np.allclose(G[:, i, j], (w[:, side] * e).sum(1), rtol=1e-9, atol=1e-12)
            assert np.allclose(slope[:, i, j], ((a + b * (here - there))[:, side] * e).sum(1), rtol=1e-9, atol=1e-12)


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
