"""The two monic factors: their derivative, their Newton step, and the proved number of upper roots."""

from __future__ import annotations

from fractions import Fraction

import numpy as np
import pytest
from multiprecision import Multiprecision
from residue import Residues, random_track

from mpsolve.characteristic.splitting import monic, sharpened, sylvester, upper_count
from mpsolve.characteristic.symbol import Symbol, Symbols, product
from mpsolve.errors import PrecisionError
from mpsolve.numbers.float64 import Float64
from mpsolve.problem.reduced import track_guide

UPPER, LOWER = [-1 + 2j, -0.5 - 1j], [2 + 0j, 1 - 1j, 0.25 + 1j]


def test_monic_is_the_product() -> None:
    assert np.allclose([*monic(UPPER), 1][::-1], np.poly(UPPER))
    assert monic([]) == ()


def test_sylvester_is_the_derivative_of_the_product() -> None:
    U, L = list(monic(UPPER)), list(monic(LOWER))
    step = np.array([0.3, -1j, 0.2, 1, 2j]) * 1e-6
    moved = np.array([*U, *L]) + step
    change = np.array(product([*moved[:2], 1], [*moved[2:], 1])) - np.array(product([*U, 1], [*L, 1]))
    assert np.allclose(np.array(sylvester(U, L)) @ step, change[:-1], rtol=0, atol=1e-11)
    assert change[-1] == 0


@pytest.mark.parametrize("K", [Float64(), Multiprecision(30)])
def test_a_newton_step_squares_the_error(K: Float64 | Multiprecision) -> None:
    """Also with an upper root that is double."""
    for upper in (UPPER, [-1 + 0.5j, -1 + 0.5j]):
        U, L = list(monic(upper)), list(monic(LOWER))
        D = [3 * c for c in product([*U, 1], [*L, 1])]
        found = sharpened(K, D, [c + 1e-5 for c in U], [c - 1e-5j for c in L])
        for part, exact in zip(found, (U, L), strict=True):
            assert max(abs(complex(a) - complex(b)) for a, b in zip(part, exact, strict=True)) < 1e-9


@pytest.mark.parametrize("seed", range(6))
def test_upper_roots_are_counted_wherever_growth_is(seed: int) -> None:
    """The number of roots with Re P < 0 is the same at every σ with Re σ > 0."""
    guide = track_guide(random_track(1 + seed % 3, seed), Fraction(seed, 3))
    truth = Residues(guide, 30)
    count = upper_count(Symbols.of(guide).D)
    for s in (1.5, 0.125 + 1j, 0.25 - 2j, 1e-3 + 0.5j):
        assert sum(1 for z in truth.roots(s) if z.real < 0) == count


def test_real_roots_everywhere_are_not_counted() -> None:
    """P² + 1: a wave for every σ."""
    with pytest.raises(PrecisionError, match="told apart"):
        upper_count(Symbol.of({(2, 0): Fraction(1), (0, 0): Fraction(1)}))
