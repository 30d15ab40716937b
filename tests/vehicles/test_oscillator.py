"""A quarter of a car: two natural frequencies that are known in closed form."""

from __future__ import annotations

import numpy as np
import pytest

from mpsolve.vehicles import Oscillator


def test_free_it_moves_as_one_or_against_each_other() -> None:
    """ω² = 0, and k (1/wheel + 1/body)."""
    pencil = Oscillator(wheel=900, body=5000, k="1e6", c="2e4").pencil
    squared = np.linalg.eigvals(np.linalg.solve(np.array(pencil.M, float), np.array(pencil.K, float)))
    assert sorted(squared) == pytest.approx([0, 1e6 * (1 / 900 + 1 / 5000)], abs=1e-9)
    assert np.array(pencil.C, float) == pytest.approx(0.02 * np.array(pencil.K, float))
