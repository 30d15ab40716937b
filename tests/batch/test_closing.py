"""Pivots of accretive matrices: the sum of their arguments is that of the eigenvalues."""

from __future__ import annotations

import numpy as np

from mpsolve import Problem, tracks, vehicles
from mpsolve.batch.entries import entries_of
from mpsolve.batch.groups import groups_of
from mpsolve.batch.passive import accretive, closing_argument, first_passive

BEAM = tracks.EulerBernoulli(EI="0.25", m=1, k=1, c="0.1")
BOGIE = vehicles.Bogie(wheel=3, frame=5, inertia=4, wheelbase=2, k=3, c=0, k_contact=40, body=9, k2=1, c2="0.1")


def test_pivots_and_eigenvalues_turn_alike() -> None:
    problem = Problem(BEAM, [vehicles.Mass(40).at(-4), BOGIE.at(0)], v="0.5")
    entries = entries_of(problem, {"v": np.linspace(0.3, 1.3, 6), "vehicles[1].wheel": np.geomspace(0.1, 100, 6)})
    ((group,), _) = groups_of(entries, np.arange(6))
    rho = first_passive(group)
    M = accretive(group, np.arange(6), 1j * rho)
    hermitian = np.linalg.eigvalsh(M + M.conj().swapaxes(1, 2))
    assert (hermitian > -1e-9 * np.abs(hermitian).max()).all()
    expected = np.angle(np.linalg.eigvals(M)).sum(1)
    assert np.allclose(closing_argument(group, rho), expected, atol=1e-6)
