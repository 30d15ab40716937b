"""The theorems: their identities hold, and what they say holds at random points by the paper's own formulas."""

from __future__ import annotations

import itertools
import random

import numpy as np
import pytest
import sympy as sp
from oracle import Truth

from mpsolve import Case, crossings
from paper import theory

RANDOM = random.Random(5)


@pytest.mark.parametrize(
    "proof", [theory.undamped_roots_are_real, theory.lines_in_the_gap, theory.one_damped_mass_is_stable]
)
def test_every_identity_is_confirmed(proof) -> None:
    found = proof()
    assert found.holds
    assert len(found.steps) >= 4


def test_both_symmetries_are_confirmed() -> None:
    assert theory.symmetries() == {"pair": True, "four": True}


def test_a_wrong_identity_is_not() -> None:
    x = sp.Symbol("x", positive=True)
    assert not theory._zero((x + 1) ** 2 - x**2 - 1)
    assert not theory._positive_terms(x**2 - 2 * x + 3, x)


@pytest.mark.parametrize("_", range(8))
def test_the_kernel_of_one_damped_mass_never_turns_real(_: int) -> None:
    """Im K(0, q) < 0 for real q > 0 and α ≤ 1."""
    alpha, eta_b, q = RANDOM.uniform(0, 1), RANDOM.uniform(0.01, 2), RANDOM.uniform(0.01, 3)
    case = Case(alpha=round(alpha, 6), eta_b=round(eta_b, 6), eta_m=1)
    assert Truth(case, 25).kernel(0, q).imag < 0


def test_and_beyond_the_critical_velocity_it_does() -> None:
    """The bound α ≤ 1 is not idle."""
    signs = {
        Truth(Case(alpha="1.3", eta_b="0.05", eta_m=1), 25).kernel(0, q).imag > 0 for q in (0.05, 0.1, 0.2, 1, 2)
    }
    assert signs == {True, False}


def test_no_crossing_mass_for_one_mass_at_the_critical_velocity() -> None:
    one = Case(alpha="1", eta_b="0.3", eta_m=1)
    found = crossings(one, over={"eta_m": ("0.001", "1e6")}, check=False)
    assert (found.proved, found.crossings, found.counts) == (True, (), (0,))


@pytest.mark.parametrize("_", range(6))
def test_q2_times_the_kernel_grows_in_the_gap(_: int) -> None:
    """Both eigenvalues of q² [K(x_i − x_j)] grow with q, and |K(d)| < K(0)."""
    alpha, d = round(RANDOM.uniform(0.05, 0.9), 4), RANDOM.uniform(0.3, 5)
    truth = Truth(Case(alpha=alpha, eta_b=0, eta_m=1), 25)
    p = np.linspace(0, 3, 4000)
    limit = float(np.min(np.sqrt(p**4 + 4) / 2 - alpha * p))
    values = []
    for q in np.linspace(0.05, 0.95, 7) * limit:
        own, other = truth.kernel(0, q), truth.kernel(d, q)
        assert abs(own.imag) < 1e-15
        assert abs(other) < own.real
        values.append((q * q * (own.real - abs(other)), q * q * (own.real + abs(other))))
    for low, high in itertools.pairwise(values):
        assert low[0] < high[0]
        assert low[1] < high[1]
