"""The first fall of functions whose zeros are known, however they are sampled."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

from mpsolve.vibration.fall import first_fall, last_above

NOISE = 1e-9


def found(f: Any, grid: Any, above: float | None = None) -> Any:
    return first_fall(f, grid, f(grid), NOISE, above)


@pytest.mark.parametrize("count", [4, 5, 50, 5001])
def test_a_zero_does_not_hang_on_the_samples(count: int) -> None:
    fall = found(np.cos, np.linspace(0, 3, count))
    assert fall.time == pytest.approx(np.pi / 2, abs=1e-12)
    assert NOISE < fall.off < 2e-7


@pytest.mark.parametrize("depth", [1e-3, 1e-6, 1e-8])
@pytest.mark.parametrize("count", [12, 13, 100, 101, 4001])
def test_a_dip_between_samples_and_one_that_hardly_crosses(depth: float, count: int) -> None:
    """1 − (1 + d) sin t = 0 at sin t = 1/(1 + d): samples within the noise on the way do not hide it."""
    fall = found(lambda t: 1 - (1 + depth) * np.sin(t), np.linspace(0, 3, count))
    assert abs(fall.time - np.arcsin(1 / (1 + depth))) < fall.off
    assert fall.off < 3 * NOISE / np.sqrt(2 * depth) + 1e-7


@pytest.mark.parametrize("depth", [0.0, -1e-12, -0.1, 1e-10])
def test_what_touches_0_within_its_error_does_not_fall(depth: float) -> None:
    assert found(lambda t: 1 - (1 + depth) * np.sin(t), np.linspace(0, 3, 31)) is None


def test_it_is_known_from_earlier_samples_that_it_was_above() -> None:
    def f(t: Any) -> Any:
        return np.where(t < 1, 1 - t, np.where(t < 2, 0.0, 2 - t))

    grid = np.linspace(1.05, 3, 30)
    fall = found(f, grid, 0.5)
    assert fall.time == pytest.approx(1)
    assert fall.time + fall.off >= 2
    assert found(f, grid) == found(f, grid, None)
    assert found(f, grid).time == 0
    assert last_above(grid, f(grid), NOISE, 0.5) == 0.5
    assert last_above(np.array([0.2, 0.6]), np.array([1, 0.0]), NOISE, None) == 0.2
