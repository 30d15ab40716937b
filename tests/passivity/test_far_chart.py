"""What levels of blocks take, against integrals by sums."""

from __future__ import annotations

import numpy as np
import pytest

from mpsolve.passivity.far_chart import layered


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
