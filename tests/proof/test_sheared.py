"""Parallelograms hold what they replace."""

import numpy as np

from mpsolve.proof.sheared import rounded, sheared, upright


def _boxes(rng: np.random.Generator, n: int = 40) -> tuple[np.ndarray, np.ndarray]:
    low = np.stack([rng.uniform(-1, 2, n), rng.uniform(-1, 1, n), rng.integers(-8, 8, n) / 4.0])
    high = low + np.stack([rng.uniform(0.01, 1, n), rng.uniform(0.01, 1, n), np.zeros(n)])
    return low, high


def test_all_points_of_a_box_lie_in_the_one_with_another_slope() -> None:
    rng = np.random.default_rng(1)
    low, high = _boxes(rng)
    slope = rng.integers(-16, 16, 40) / 8.0
    a, b = sheared(low, high, slope)
    assert (a[2] == slope).all()
    assert (b[2] == slope).all()
    for u in [*np.array([[0, 0], [0, 1], [1, 0], [1, 1]]), *rng.uniform(size=(50, 2))]:
        t, x = (low[k] + u[k] * (high[k] - low[k]) for k in (0, 1))
        there = t + (low[2] - slope) * x
        assert ((there >= a[0]) & (there <= b[0]) & (x >= a[1]) & (x <= b[1])).all()
    assert (b[0] - a[0] <= high[0] - low[0] + np.abs(slope - low[2]) * (high[1] - low[1]) + 1e-13).all()  # no larger


def test_upright_ones_stay_as_they_are() -> None:
    low, high = _boxes(np.random.default_rng(2))
    low[2, :20] = high[2, :20] = 0
    a, b = upright(low, high)
    assert (a[:, :20] == low[:2, :20]).all()
    assert (b[:, :20] == high[:2, :20]).all()
    q = np.stack([low[0] + low[2] * x for x in (low[1], high[1])])
    assert (a[0] <= q.min(0) + 1e-13).all()


def test_slopes_get_few_digits_and_stay_near() -> None:
    rng = np.random.default_rng(3)
    low, high = _boxes(rng)
    slope = rng.uniform(-3, 3, 40)
    near = rounded(slope, low, high)
    assert (np.abs(near - slope) * (high[1] - low[1]) <= (high[0] - low[0]) / 64).all()
    assert (near * 2**20 == np.round(near * 2**20)).all()
