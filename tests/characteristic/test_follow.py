"""Roots that are followed are those of each polynomial, also where two meet or the path is coarse."""

from __future__ import annotations

import numpy as np
import pytest

from mpsolve.characteristic.follow import eigenvalues, followed


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
