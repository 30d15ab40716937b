"""One crossing for each value of the second parameter: on models whose zeros are known."""

from __future__ import annotations

import numpy as np

from mpsolve.numbers.quadratic import Quadratic
from mpsolve.ranges.ridge import one_for_each


def model(k: list[complex], e: float) -> Quadratic:
    """Coefficients of 1, u₀, u₁, u₂, u₀², u₀u₁, u₀u₂, u₁², u₁u₂, u₂²."""
    return Quadratic(np.array(k, complex)[:, None], np.array([e]), 3)


def test_a_linear_model_has_one() -> None:
    assert one_for_each(model([0.1, 1, 1j, 5, 0, 0, 0, 0, 0, 40], 0.01))[0]  # whatever it does along u₂


def test_parallel_slopes_may_have_many() -> None:
    assert not one_for_each(model([0, 1, 2, 1, 0, 0, 0, 0, 0, 0], 0))[0]


def test_two_zeros_are_not_called_one() -> None:
    """u₀² − 0.01 + i u₁ has the zeros u₀ = ±0.1 at u₁ = 0; as slopes at the middle vanish nothing is proved."""
    assert not one_for_each(model([-0.01, 0.001, 1j, 0, 1, 0, 0, 0, 0, 0], 0))[0]


def test_a_wide_remainder_proves_nothing() -> None:
    assert not one_for_each(model([0.1, 1, 1j, 0, 0, 0, 0, 0, 0, 0], 0.5))[0]
    assert not one_for_each(model([0.1, 1, 1j, 0, 0, 0, 0, 0, 0, 0], np.inf))[0]
