"""Felt, neutral and unfelt motions: of a train they are those of its vehicles."""

from __future__ import annotations

from fractions import Fraction

import numpy as np
import pytest

from mpsolve import vehicles
from mpsolve.problem.problem import Problem
from mpsolve.tracks import String
from mpsolve.vehicles.felt import Parts, split_felt
from mpsolve.vehicles.vehicle import Pencil

TRACK = String(T=1, m=1, k=1, c=1)
BOGIE = vehicles.Bogie(wheel=1, frame=3, inertia=2, wheelbase=2, k=5, c=1)
COACH = vehicles.Coach(body=20, inertia=90, bogie=BOGIE, pivots=10, k2=4, c2=1)
ON_DAMPER = vehicles.Oscillator(wheel=1, body=2, k=0, c=1)


def pencil(*placed: object) -> Pencil:
    return Problem(TRACK, list(placed), v=0).pencil


def determinant(M: object, C: object, K: object, sigma: complex) -> complex:
    parts = [np.array([[float(x) for x in row] for row in rows]) for rows in (K, C, M)]  # type: ignore[attr-defined]
    return complex(np.linalg.det(parts[0] + sigma * parts[1] + sigma * sigma * parts[2]))


def check(whole: Pencil, parts: Parts) -> None:
    """det S of the whole is that of its parts, divided by det Q²; no contact moves what is neutral or unfelt."""
    sigma = 0.3 + 0.7j
    ours = determinant(parts.M, parts.C, parts.K, sigma)
    if parts.unfelt is not None:
        ours *= determinant(*parts.unfelt, sigma)
    square = np.linalg.det([[float(x) for x in row] for row in parts.basis or np.eye(whole.size)]) ** 2
    assert abs(ours / square / determinant(whole.M, whole.C, whole.K, sigma) - 1) < 1e-9
    for row in parts.B[len(parts.B) - parts.neutral :]:
        assert not any(row)


def test_a_train_of_coaches_feels_all() -> None:
    whole = pencil(*vehicles.train(COACH, 3, 25))
    assert split_felt(whole) == Parts(whole.M, whole.C, whole.K, whole.B, 0, None, None)


@pytest.mark.parametrize("count", [1, 2, 3])
def test_neutral_motions_of_a_train_are_those_of_its_vehicles(count: int) -> None:
    """A body on a damper alone: one neutral motion a vehicle, beside a coach that has none."""
    whole = pencil(*vehicles.train(ON_DAMPER, count, 3), COACH.at(50))
    parts = split_felt(whole)
    assert (parts.neutral, parts.unfelt, len(parts.M)) == (count, None, whole.size)
    check(whole, parts)


def test_unfelt_motions_are_put_together() -> None:
    """A tight wheelset under two equal bodies on equal springs: what they do against each other is not felt."""
    twin = vehicles.Vehicle(
        M=[[1, 0, 0], [0, 2, 0], [0, 0, 2]],
        C=[[0, 0, 0], [0, 0, 0], [0, 0, 0]],
        K=[[6, -3, -3], [-3, 3, 0], [-3, 0, 3]],
        B=[[1], [0], [0]],
        places=[0],
    )
    whole = pencil(twin.at(0), vehicles.Mass(4).at(2), twin.at(9))
    parts = split_felt(whole)
    assert parts.unfelt is not None
    assert (len(parts.unfelt[0]), len(parts.M), parts.neutral) == (2, whole.size - 2, 0)
    check(whole, parts)
    for rows in parts.unfelt[0]:
        assert sum(map(bool, rows)) == 1  # the two vehicles' unfelt motions stay apart
    assert all(isinstance(x, Fraction) for row in parts.M for x in row)
