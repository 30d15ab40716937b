"""The argument at which counts close, against eigenvalues: for accretive matrices both sums of arguments are one."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from track_models import DAMPED
from vehicle_models import TYPICAL

from mpsolve import vehicles
from mpsolve.characteristic.disc_matrix import Arrays
from mpsolve.errors import PrecisionError
from mpsolve.problem.problem import Problem
from mpsolve.problem.reduced import Reduced, reduce_problem
from mpsolve.spectrum.closing import closing_argument

BEAM = DAMPED["euler-bernoulli"]
PLACED = {
    "masses": [vehicles.Mass(900), vehicles.Mass(400).at("2.5")],
    "one place": [vehicles.Mass(900), vehicles.Oscillator(wheel=900, body=5000, k="1e6", c=10)],
    "sprung contacts": [TYPICAL["oscillator"], TYPICAL["bogie"].at(9)],
    "on a damper": vehicles.Vehicle(
        M=[[3, 0], [0, 5]], C=[[20, -20], [-20, 20]], K=[[0, 0], [0, 0]], B=[[1], [0]], places=[0]
    ),
}


def corner(reduced: Reduced, rho: float) -> tuple[Any, Any]:
    _, G, good = Arrays(reduced).evaluate(np.array([1j * rho]), np.zeros(1), 2)
    assert good.all()
    V = 1j * rho * G.a[0]
    assert np.linalg.eigvalsh(V + V.conj().T)[0] > 0
    return G.a[0], G.e[0]


def accretive(reduced: Reduced, sigma: complex, G: Any) -> Any:
    """[[S/σ, −B], [Bᵀ, σ(G + h)]], rows of neutral modes undivided."""
    n, c = reduced.bodies, reduced.contacts
    S = np.array([[[float(x) for x in row] for row in rows] for rows in reduced.S])
    S = S[0] / sigma + S[1] + S[2] * sigma
    S[n - reduced.neutral :] *= sigma
    B = np.array([[float(x) for x in row] for row in reduced.B]).reshape(n, c)
    index = np.array(reduced.index)
    low = sigma * (G[np.ix_(index, index)] + np.diag([float(x) for x in reduced.h]))
    return np.block([[S, -B], [B.T, low]])


@pytest.mark.parametrize("name", PLACED)
@pytest.mark.parametrize("rho", [1.5, 3.0])
def test_it_is_the_sum_of_the_arguments_of_eigenvalues(name: str, rho: float) -> None:
    reduced = reduce_problem(Problem(BEAM, PLACED[name], v=40))
    assert reduced.neutral == (name == "on a damper")
    G, e = corner(reduced, rho)
    found = closing_argument(reduced, rho, G, e)
    values = np.linalg.eigvals(accretive(reduced, 1j * rho, G))
    assert float(found.mid()) == pytest.approx(float(np.angle(values).sum()), abs=1e-7)
    assert float(found.rad()) < 1e-6


def test_wider_receptances_give_a_wider_sum_that_holds_the_others() -> None:
    reduced = reduce_problem(Problem(BEAM, PLACED["masses"], v=40))
    G, e = corner(reduced, 1.5)
    wide = closing_argument(reduced, 1.5, G, e + 1e-4)
    rng = np.random.default_rng(1)
    for _ in range(20):
        moved = G + 1e-4 * np.exp(2j * np.pi * rng.uniform(size=G.shape))
        assert wide.contains(closing_argument(reduced, 1.5, moved, e))
    assert float(wide.rad()) < 0.1


def test_what_may_be_singular_is_not_closed() -> None:
    reduced = reduce_problem(Problem(BEAM, PLACED["masses"], v=40))
    G, e = corner(reduced, 1.5)
    with pytest.raises(PrecisionError, match="singular"):
        closing_argument(reduced, 1.5, G, e + 1e9)
    try:
        assert closing_argument(reduced, 1.5, G, e + np.inf).unique_fmpz() is None
    except PrecisionError:
        return
