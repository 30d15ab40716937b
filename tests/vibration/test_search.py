"""Zeros are counted in floats where the argument turns fast, or not at all where floats lose it."""

from __future__ import annotations

import numpy as np
import pytest
from track_models import DAMPED

from mpsolve import Problem, vehicles
from mpsolve.errors import PrecisionError
from mpsolve.vibration.image import Image
from mpsolve.vibration.search import count_zeros


def test_zeros_are_counted_also_where_the_argument_turns_fast() -> None:
    """A string and contacts far apart: the argument turns by some thousand radians along the path."""
    problem = Problem(DAMPED["string"], [vehicles.Mass(9), vehicles.Mass(9).at(200)], v=10)
    image = Image(problem, ())
    assert count_zeros(image, 1e-2, 10.0)[0] == 0


def test_a_determinant_that_floats_lose_is_no_count() -> None:
    class Lost:
        def phase(self, sigma: np.ndarray) -> np.ndarray:
            return np.where(np.abs(sigma) > 9, 0, 1 + 0j)

    with pytest.raises(PrecisionError, match="float64 loses"):
        count_zeros(Lost(), -0.1, 10.0)  # type: ignore[arg-type]
