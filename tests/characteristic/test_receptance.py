"""Divided differences by companion matrices: sums of residues, limits of them, and slopes."""

from __future__ import annotations

from fractions import Fraction
from typing import Any

import numpy as np
import pytest
from multiprecision import Multiprecision
from residue import Residues, random_track

from mpsolve.characteristic.receptance import by_companions, companion, residues
from mpsolve.characteristic.splitting import Splitting, monic
from mpsolve.characteristic.symbol import Symbols
from mpsolve.numbers.balls import Balls, acb, precision
from mpsolve.numbers.float64 import Float64
from mpsolve.problem.reduced import track_guide

A, B, F = [-1 + 2j, -0.5 - 1j, -0.3 + 0j], [2 + 0j, 1 - 1j], [1 + 0j, 0.5, 2j]


def simple(xi: float) -> complex:
    return sum(
        np.exp(z * xi)
        * (F[0] + F[1] * z + F[2] * z * z)
        / np.prod([z - x for x in A if x != z])
        / np.prod(z - np.array(B))
        for z in A
    )


def entry(K: Any, xi: float) -> complex:
    coefficients = [list(monic(roots)) for roots in (A, B)]
    if isinstance(K, Balls):
        with precision(100):
            U, L, G = ([acb(complex(c)) for c in part] for part in (*coefficients, F))
            return complex(residues(K, [U], [L], [G], [acb(xi)])[0][0])
    (found,) = residues(K, *([part] for part in (*coefficients, F)), [xi])[0]
    return complex(np.asarray(found).reshape(-1)[0]) if isinstance(K, Float64) else complex(found)


@pytest.mark.parametrize("xi", [0, 0.5, 3.0])
def test_the_same_sum_in_all_arithmetics(xi: float) -> None:
    for K in (Float64(), Multiprecision(30), Balls()):
        assert abs(entry(K, xi) - simple(xi)) < 1e-13


def test_the_companion_matrix_has_the_roots() -> None:
    assert np.allclose(np.sort_complex(np.linalg.eigvals(companion(Float64(), [list(monic(A))]))), np.sort_complex(A))


def test_no_root_gives_nothing() -> None:
    assert residues(Float64(), [[]], [list(monic(B))], [F], [0, 1]) == [(0,), (0,)]


@pytest.mark.parametrize("size", [1, 2])
def test_values_and_slopes_against_residues(size: int) -> None:
    """At 50 digits, in mpmath: companions, single terms, and residues by themselves agree."""
    guide = track_guide(random_track(size, 4), Fraction(1, 3))
    K, truth, symbols = Multiprecision(50), Residues(guide, 100), Symbols.of(guide)
    s = K.mp.mpc(0.5, 0.25)
    roots = sorted((K.mp.mpmathify(z) for z in truth.roots(s)), key=lambda z: z.real)
    upper = sum(1 for z in roots if z.real < 0)
    D = symbols.D.at(K, s)
    xi = [Fraction(-3, 2), Fraction(0), Fraction(2)]
    split = Splitting(D[-1], monic(roots[:upper]), monic(roots[upper:]))
    local = symbols.at(K, s)
    G, G_sigma = by_companions(K, local, split, [K.number(x) for x in xi], [x >= 0 for x in xi], True)
    for x, value, slope in zip(xi, G, G_sigma, strict=True):
        side, sign = (roots[:upper], 1) if x >= 0 else (roots[upper:], -1)
        terms, number = [local.terms(z) for z in side], K.number(x)
        waves = [sign * K.mp.exp(t.z * number) for t in terms]
        assert abs(value - truth(x, s)) < 1e-40
        assert abs(slope - truth.slope(x, s)) < 1e-40
        assert abs(value - sum(t.w * e for t, e in zip(terms, waves, strict=True))) < 1e-40
        assert abs(slope - sum((t.a + t.b * number) * e for t, e in zip(terms, waves, strict=True))) < 1e-40
