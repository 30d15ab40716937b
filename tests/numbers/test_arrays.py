"""The names of arrays stand for what NumPy makes of Python's numbers."""

from __future__ import annotations

from typing import get_args

import numpy as np
import pytest

from mpsolve.numbers.arrays import Complexes, Integers, Reals, Truths


@pytest.mark.parametrize(("name", "number"), [(Reals, 1.5), (Complexes, 1j), (Integers, 2), (Truths, True)])
def test_names_are_what_numpy_makes_of_numbers(name: object, number: complex) -> None:
    (kind,) = get_args(get_args(name)[1])
    assert np.array([number]).dtype == np.dtype(kind)
