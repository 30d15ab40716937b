"""A vehicle given by the matrices of another is that other."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

import numpy as np
import pytest
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


class Sparse:
    """As scipy's sparse matrices are: not a sequence, without rows of its own, but `toarray` tells all entries."""

    def __init__(self, entries: Any) -> None:
        self.entries = entries

    def toarray(self) -> Any:
        return self.entries


def test_matrices_of_other_programs() -> None:
    """numpy's, and sparse ones."""
    rows = [[2, -1], [-1, 3]]
    plain = Vehicle(M=rows, C=rows, K=rows, B=[[1], [0]], places=[0])
    for made in (np.array, Sparse):
        given = made(np.array(rows, float))
        assert Vehicle(M=given, C=given, K=given, B=made([[1], [0]]), places=[0]).pencil == plain.pencil
