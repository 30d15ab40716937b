"""Coordinates without mass go without a trace; the weights are those of the bodies."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

from mpsolve import vehicles
from mpsolve.finite.carriage import carriage
from mpsolve.vehicles.vehicle import Pencil

HELD = [[5, -2, 0], [-2, 7, -3], [0, -3, 3]]


def _compliance(pencil: Pencil, s: complex) -> np.ndarray:
    """Of the contacts: h + Bᵀ(M s² + C s + K)⁻¹B."""
    M, C, K, B = (np.array(rows, float) for rows in (pencil.M, pencil.C, pencil.K, pencil.B))
    return np.diag(np.array(pencil.h, float)) + B.T @ np.linalg.solve(M * s * s + C * s + K, B)


@pytest.mark.parametrize(
    ("M", "C", "K", "second"),
    [
        ([[9, 0, 0], [0, 4, 0], [0, 0, 1]], [[1, 0, 0], [0, 0, 0], [0, 0, 0]], HELD, 3),
        ([[9, 0, 0], [0, 0, 0], [0, 0, 0]], [[1, 0, 0], [0, 0, 0], [0, 0, 2]], HELD, 1),
        ([[4, 4, 0], [4, 4, 0], [0, 0, 0]], [[0, 0, 0], [0, 0, 0], [0, 0, 0]], HELD, 1),
        ([[4, 4, 0], [4, 4, 0], [0, 0, 0]], [[2, -2, 0], [-2, 2, 0], [0, 0, 0]], HELD, 1),
    ],
)  # fmt: skip
def test_the_reduced_vehicle_has_the_same_compliance(M: Any, C: Any, K: Any, second: int) -> None:
    pencil = vehicles.Vehicle(M=M, C=C, K=K, B=[[0, 1], [0, 1], [1, 0]], places=[0, 1], k_contact=8).pencil
    found = carriage(pencil)
    assert found.second == second
    assert np.linalg.matrix_rank(found.M[:second, :second]) == second
    assert not found.M[second:].any()
    for s in (0.3 + 1j, 2.0 + 0j):
        inner = np.linalg.solve(found.M * s * s + found.C * s + found.K, found.B)
        assert found.H + found.B.T @ inner == pytest.approx(_compliance(pencil, s), rel=1e-12)
        y = np.linalg.solve(
            sum(np.array(a, float) * s**k for k, a in enumerate((K, C, M))), np.array(pencil.B, float)
        )
        assert found.motion @ inner + found.give == pytest.approx(y, rel=1e-12, abs=1e-14)
