"""Where all long trains are proved to grow: the map of a cell is that of finite trains, and nothing is said below."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from itertools import combinations
from typing import Any

import numpy as np
import pytest
from endless_rows import bogies, masses

from mpsolve import Problem, tracks, vehicles
from mpsolve.characteristic.floats import Floats
from mpsolve.endless import long_trains
from mpsolve.endless.axis import closest
from mpsolve.endless.bloch import Bloch
from mpsolve.endless.doubling import growing_in_floats
from mpsolve.endless.infinite_train import reach_of
from mpsolve.endless.long_trains import _ends, cell, holds, prove_long, roots_of
from mpsolve.endless.row import Row, row_of
from mpsolve.numbers.balls import acb, precision
from mpsolve.problem.reduced import reduce_problem


def meets(row: Row) -> float:
    return closest(Bloch(row), reach_of(row))[1]


@pytest.mark.parametrize("make", [masses, bogies])
def test_the_power_of_a_cell_vanishes_with_the_determinant_of_the_train(make: Callable[[str], Row]) -> None:
    """det (T^N)_bb (Δ₁ det u)^N/Δ_N does not depend on σ, Δ of whole trains; and it is the sum over sets of roots."""
    row, ratios = make("0.4"), []
    for sigma in (0.1 + 0.3j, 0.02 + 0.5j, 0.3 + 0.1j):
        with precision(212):
            T = cell(row, acb(sigma.real, sigma.imag))
            z, R, up = roots_of(row, acb(sigma.real, sigma.imag))
            power = np.array([[complex(x) for x in line] for line in (T * T * T).tolist()])
            T1, roots, vectors = (np.array([complex(x) for x in part]) for part in (T.entries(), z, R.entries()))
        n, block = len(roots), power[up:, up:]
        T1, vectors = T1.reshape(n, n), vectors.reshape(n, n)
        assert np.allclose(np.sort(np.abs(roots)), np.abs(Bloch(row).multipliers(sigma))[0], rtol=1e-8)
        total, inverse = 0j, np.linalg.inv(vectors)
        for M in combinations(range(n), n - up):
            own = list(M)
            total += (roots[own] ** 3).prod() * np.linalg.det(vectors[up:, own]) * np.linalg.det(inverse[own, up:])
        assert np.isclose(total, np.linalg.det(block), rtol=1e-6)
        whole, alone = (Floats(reduce_problem(row.train(count))).delta(np.array([sigma]))[0][0] for count in (3, 1))
        ratios.append(np.linalg.det(block) / np.linalg.det(T1[up:, up:]) ** 3 * alone**3 / whole)
    assert np.allclose(ratios, ratios[0], rtol=1e-6)


def test_above_the_limit_long_trains_grow_as_they_are_counted() -> None:
    for v in ("0.44508", "0.47"):
        found = prove_long(masses(v), meets(masses(v)))
        assert found is not None
        assert found.near.real > 0
    short, long = (growing_in_floats(Bloch(masses("0.47")), count, 1.0, 0.5) for count in (30, 60))
    assert 0 < short < long


def test_below_the_limit_nothing_is_claimed() -> None:
    for v in ("0.2", "0.44", "0.445"):
        assert prove_long(masses(v), meets(masses(v))) is None


def test_what_the_theorem_needs_is_asked_for() -> None:
    row = masses("0.46")
    with precision(320):
        one, other = _ends(row, meets(row)) or (None, None)
        assert holds(row, one, other)
        assert not holds(row, one, one + (one - other))  # |x/y| on one side of 1
        assert not holds(row, one - 1e-6, other - 1e-6)  # decays
        assert not holds(row, one, one + acb(0, 1e-2))  # too wide to tell the roots apart


@pytest.mark.parametrize("side", [0, 1])
@pytest.mark.parametrize("middle", [0, 1])
def test_a_term_that_vanishes_proves_nothing(side: int, middle: int, monkeypatch: pytest.MonkeyPatch) -> None:
    """C_M = 0 for one of the two sets that matter: by a column of R that is 0 in one half of its rows."""
    row = masses("0.46")

    def forged(row: Row, sigma: Any) -> tuple[list[Any], Any, int]:
        z, R, up = roots_of(row, sigma)
        for i in range(up) if side else range(up, len(z)):
            R[i, up - 1 + middle] = 0
        return z, R, up

    with precision(320):
        one, other = _ends(row, meets(row)) or (None, None)
        monkeypatch.setattr(long_trains, "roots_of", forged)
        assert not holds(row, one, other)


def test_other_roots_of_the_same_modulus_prove_nothing(monkeypatch: pytest.MonkeyPatch) -> None:
    row = masses("0.46")
    with precision(320):
        one, other = _ends(row, meets(row)) or (None, None)
        for k in (0, 3):  # of two p-roots a side: the least, and the greatest

            def forged(row: Row, sigma: Any, k: int = k) -> tuple[list[Any], Any, int]:
                z, R, up = roots_of(row, sigma)
                z[k] = -z[2 if k > up else 1]
                return z, R, up

            monkeypatch.setattr(long_trains, "roots_of", forged)
            assert not holds(row, one, other)


def test_on_a_rail_on_sleepers() -> None:
    layers = tracks.TwoLayer(
        EI="6.38e6", m="60.2", k_pad="300e6", c_pad="3e4", m_sleeper="250", k_ballast="100e6", c_ballast="8e4"
    )
    row = row_of(Problem(layers, vehicles.Mass(900), v=700), 3)
    assert prove_long(row, meets(row)) is not None
    light = replace(row, problem=Problem(layers, vehicles.Mass(9), v=700))
    assert prove_long(light, meets(light)) is None
