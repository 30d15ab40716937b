"""The tables of the vehicle against small steps of its equations."""

from __future__ import annotations

import numpy as np
import pytest

from mpsolve import vehicles
from mpsolve.finite.carriage import carriage
from mpsolve.finite.coupling import vehicle_tables
from mpsolve.vehicles.load import Load
from mpsolve.vehicles.loads import outer_forces


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
