"""The roots z from one cell are zeros of Δ̂(z, σ), and finite trains are made of them."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
import pytest
from endless_rows import bogies, masses

from mpsolve.characteristic.floats import Floats
from mpsolve.characteristic.proved import Proved
from mpsolve.endless.bloch import Bloch, scattered
from mpsolve.endless.row import Row
from mpsolve.numbers.balls import Balls, acb, precision
from mpsolve.numbers.float64 import Float64
from mpsolve.problem.reduced import reduce_problem

SIGMA = np.array([0.3 + 0.2j, 0.05 + 0.6j, 0.28j, 0.9j])


@pytest.mark.parametrize("make", [masses, bogies])
def test_the_multipliers_are_roots(make: Callable[[str], Row]) -> None:
    bloch = Bloch(make("0.4"))
    z = bloch.multipliers(SIGMA)
    assert (np.diff(np.abs(z), axis=1) >= 0).all()
    for k in range(bloch.upper - 1, bloch.upper + 1):
        value, off = bloch.delta(SIGMA, z[:, k])[0], bloch.delta(SIGMA, z[:, k] * 1.01)[0]
        assert (np.abs(value) < 1e-8 * np.abs(off)).all()


def test_where_re_sigma_is_large_the_circle_parts_them() -> None:
    for make in (masses, bogies):
        bloch = Bloch(make("0.4"))
        inside = (np.abs(bloch.multipliers(np.array([3.0 + 0j, 2 + 2j]))) < 1).sum(1)
        assert (inside == bloch.upper).all()


def test_forces_in_a_long_train_fall_by_the_multipliers() -> None:
    """The solution of 40 masses, shaken in the middle, decays on either side by the middle roots."""
    row, sigma = masses("0.4"), np.array([0.02 + 0.2j])
    A = Floats(reduce_problem(row.train(40))).matrices(sigma)[0][0]
    force = np.linalg.solve(A, np.eye(40)[:, 20])
    back, ahead = Bloch(row).middle(sigma)[1], Bloch(row).middle(sigma)[0]
    assert abs(force[27] / force[26] - ahead[0]) < 2e-2 * abs(ahead[0])
    assert abs(force[13] / force[14] - 1 / back[0]) < 2e-2 * abs(1 / back[0])


def test_the_slope_is_the_derivative() -> None:
    bloch, h = Bloch(bogies("0.4")), 1e-5
    z = np.exp(1j * np.array([0.4, 1.0, 2.0, 3.0]))
    slope = bloch.delta(SIGMA, z)[1]
    difference = (bloch.delta(SIGMA + h, z)[0] - bloch.delta(SIGMA - h, z)[0]) / (2 * h)
    assert np.allclose(slope, difference, rtol=1e-6)


def test_balls_hold_the_floats() -> None:
    row, sigma = bogies("0.4"), 0.1 + 0.3j
    floats = Bloch(row).scatterer(np.array([sigma]))[0]
    with precision(128):
        proved = Proved(row.reduced, eliminate=False)
        split = proved.splitting(acb(sigma.real, sigma.imag))
        waves = list(zip(split.roots, split.weights, strict=True))
        A = proved.matrices(split.sigma, slope=False)[0]
        S = scattered(Balls(), row, A, waves, proved.upper, lambda x: x.exp())
        assert np.allclose(np.array([[complex(x) for x in line] for line in S]), floats, rtol=1e-9, atol=1e-12)


def test_a_vehicle_that_weighs_nothing_lets_waves_pass() -> None:
    row, sigma = bogies("0.4"), np.array([0.1 + 0.3j])
    bloch = Bloch(row)
    P = np.stack([term.z for term in bloch.terms(sigma)], -1)[0]
    ahead = np.arange(len(P)) < bloch.upper
    stiff = np.eye(row.reduced.bodies + row.reduced.contacts, dtype=complex)[None] * 1e30  # λ is all but 0
    waves = [(term.z, term.w) for term in bloch.terms(sigma)]
    K = Float64()
    S = K.matrix(scattered(K, row, stiff, waves, bloch.upper, np.exp))[0]
    assert np.allclose(S, np.diag(np.exp(np.where(ahead, P, -P) * float(row.step))), atol=1e-20)
