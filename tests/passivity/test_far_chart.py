"""What levels of blocks take, against integrals by sums; blocks of a function with two plateaus."""

from __future__ import annotations

import numpy as np
import pytest

from mpsolve.passivity.far_chart import best_blocks, layered


@pytest.mark.parametrize("sieve", [0.0, 1.5, 4.0])
def test_what_levels_take_is_less_than_the_integral(sieve: float) -> None:
    """Two contacts whose least distance is 2π/sieve: the least eigenvalue of ∫ f u u* dp, by Riemann sums."""
    rng = np.random.default_rng(3)
    p = np.sort(rng.uniform(-20, 20, 90))
    least = np.exp(-((p[1:] - 2) ** 2) / 40) * rng.uniform(0.7, 1, 89)
    fine = np.linspace(p[0], p[-1], 400_001)
    f = least[np.clip(np.searchsorted(p, fine, side="right") - 1, 0, 88)]
    step, gap = fine[1] - fine[0], 2 * np.pi / sieve if sieve else 1.0
    a, b = f.sum() * step, (f * np.exp(-1j * fine * gap)).sum() * step
    truth = a if not sieve else a - abs(b)
    taken = layered(p, least, sieve)
    assert 0.4 * truth < taken <= truth * (1 + 1e-4)


def test_runs_that_are_shorter_than_the_loss_take_nothing() -> None:
    p = np.array([0.0, 1.0, 2.0, 5.0])
    assert layered(p, np.array([1.0, 0.0, 1.0]), 3.0) == 0.0
    assert 0.99 < layered(p, np.array([0.0, 0.5, 0.5]), 2.0) / (0.5 * 2.0) <= 1.0
    assert layered(p, np.zeros(3), 1.0) == 0.0


def blocks(sieve: float) -> list[tuple[float, float, float]]:
    z = np.linspace(-4, 4, 81)
    height = lambda x: np.where((x > -3) & (x < -1), 1.0, np.where((x > 2) & (x < 2.4), 3.0, 0.0))  # noqa: E731
    return list(best_blocks(z, height((z[1:] + z[:-1]) / 2), 10.0, sieve))


def test_both_plateaus_are_taken_where_nothing_is_lost() -> None:
    assert np.allclose(blocks(0.0), [(-3, -1, 1), (2, 2.4, 3)])


def test_a_block_shorter_than_the_loss_is_left() -> None:
    assert np.allclose(blocks(6.0), [(-3, -1, 1)])
    assert blocks(30.0) == []
    assert best_blocks(np.linspace(0, 1, 5), np.zeros(4), 10.0, 0.0) == ()
