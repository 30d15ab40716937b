"""A vehicle given by the matrices of another is that other."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from scipy.sparse import csc_array, csr_matrix
from vehicle_models import TYPICAL

from mpsolve.vehicles import Vehicle


@pytest.mark.parametrize("name", ["mass", "oscillator", "bogie", "coach"])
def test_the_matrices_of_a_vehicle_are_the_vehicle(name: str) -> None:
    pencil = TYPICAL[name].pencil
    spring = None if not pencil.h[0] else 1 / pencil.h[0]
    own = Vehicle(pencil.M, pencil.C, pencil.K, pencil.B, pencil.places, k_contact=spring, names=pencil.names)
    assert own.pencil == pencil
    unnamed = Vehicle(pencil.M, pencil.C, pencil.K, pencil.B, pencil.places, k_contact=spring)
    assert unnamed.pencil == replace(pencil, names=tuple(f"coordinate {i + 1}" for i in range(pencil.size)))


def test_matrices_of_other_programs() -> None:
    """numpy's, and scipy's sparse ones, which have no rows of their own."""
    rows = [[2, -1], [-1, 3]]
    plain = Vehicle(M=rows, C=rows, K=rows, B=[[1], [0]], places=[0])
    for made in (np.array, csr_matrix, csc_array):
        given = made(np.array(rows, float))
        assert Vehicle(M=given, C=given, K=given, B=made([[1], [0]]), places=[0]).pencil == plain.pencil
