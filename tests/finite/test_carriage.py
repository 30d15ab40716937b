"""Coordinates without mass go without a trace; the weights are those of the bodies."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

from mpsolve import (
    InputError,
    Irregularity,
    Load,
    Problem,
    finite_track,
    out_of_round,
    rail_roughness,
    response,
    tracks,
    vehicles,
)
from mpsolve.finite.carriage import carriage, rough_rates, vehicle_tables
from mpsolve.vehicles.loads import outer_forces
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


def test_a_step_of_a_damped_oscillator_is_that_of_many_small_ones() -> None:
    pencil = vehicles.Oscillator(wheel=3, body=5, k=7, c=2).pencil
    h, f0, f1 = 0.9, 1.3, -0.4
    table = vehicle_tables(carriage(pencil), outer_forces(pencil, [Load(2, 1, "1.5", "0.3")]), h)
    X = table.start.copy()
    X[:4] = [0.1, -0.2, 0.3 * h, 0.05 * h]
    f = np.array([[f0], [f1]])
    M, C, K = (np.array(rows, float) for rows in (pencil.M, pencil.C, pencil.K))

    def slope(theta: float, y: np.ndarray) -> np.ndarray:
        pull = 2 + np.sin(1.5 * theta * h + 0.3) - (f0 + f1 * (2 * theta - 1))
        rate = np.linalg.solve(M, np.array([pull, 0]) - C @ y[2:4] - K @ y[:2])
        return h * np.array([*y[2:4], *rate, y[2], y[2] * (2 * theta - 1)])

    y, count = np.array([0.1, -0.2, 0.3, 0.05, 0, 0]), 400
    for step in range(count):
        t, d = step / count, 1 / count
        a = slope(t, y)
        b = slope(t + d / 2, y + d / 2 * a)
        c = slope(t + d / 2, y + d / 2 * b)
        y = y + d / 6 * (a + 2 * b + 2 * c + slope(t + d, y + d * c))
    after = table.advance @ X + np.einsum("nlj,lj->n", table.entry, f)
    assert after[:4] == pytest.approx([*y[:2], *(h * y[2:4])], rel=1e-9)
    moved = table.history[:, 0] @ X + np.einsum("al,l->a", table.gain[0, :, :, 0], f[:, 0])
    assert moved == pytest.approx(y[4:], rel=1e-9)


BEAM = tracks.EulerBernoulli(EI="6.4e6", m=60, k="1e7", c="2e5")


def test_rates_are_tested_as_quadrature_has_them():
    one = Irregularity(2.0, 3.0, 0.4)
    found = rough_rates((one,), 1, 0.5, 4)
    nodes, weights = np.polynomial.legendre.leggauss(12)
    for step in range(4):
        theta = (nodes + 1) / 2
        rate = 0.5 * 2.0 * 3.0 * np.cos(3.0 * 0.5 * (step + theta) + 0.4)
        assert found[step, 0] == pytest.approx([(weights / 2) @ rate, (weights / 2) @ (rate * nodes)], abs=1e-13)


def test_none_is_nothing():
    assert not rough_rates((), 2, 0.1, 3).any()


@pytest.mark.parametrize("kind", ["rail", "wheel"])
@pytest.mark.parametrize("tight", [True, False])
def test_the_endless_track_agrees_to_the_sum_of_both_errors(kind: str, tight: bool) -> None:
    """Two wheels on a damped beam; the two ways share the irregularity's definition alone."""
    wheel = (
        vehicles.Mass(400) if tight else vehicles.Oscillator(wheel=400, body=2000, k="1e6", c="2e4", k_contact="1e8")
    )
    problem = Problem(BEAM, [wheel.at(0), wheel.at(2)], v=40)
    rough = rail_roughness(problem, "1e-4", 3, 0.3) if kind == "rail" else out_of_round(problem, "1e-4", "0.46", 1, 2)
    loads, times = [Load(0), Load(0)], np.linspace(0.01, 0.25, 7)
    one = response(problem, loads, times=times, irregularities=rough)
    other = finite_track(problem, loads, length=60, modes=400, times=times, irregularities=rough, tolerance=1e-4)
    assert np.abs(one.rail).max() > 1e-6
    assert np.abs(one.rail - other.rail).max() < one.error.rail + other.error.total
    for name, row in one.vehicle.items():
        assert np.abs(row - other.vehicle[name]).max() < one.error.vehicle[name] + other.error.vehicle
    assert np.abs(one.contact_force - other.contact_force).max() < one.error.contact_force + other.error.force


def test_one_for_each_contact_is_wanted():
    problem = Problem(BEAM, vehicles.Mass(400), v=40)
    with pytest.raises(InputError, match="irregularities"):
        finite_track(problem, length=60, modes=40, times=[0.1], irregularities=[Irregularity(1, 1)] * 2)
