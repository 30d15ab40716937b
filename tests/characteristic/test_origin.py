"""The receptance round q = 0 on floating ice, against residue sums in mpmath; nothing where there is no such disc."""

from __future__ import annotations

from fractions import Fraction

import mpmath
import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from mpsolve import Problem, tracks, vehicles
from mpsolve.characteristic.disc_matrix import Arrays
from mpsolve.characteristic.discs import split
from mpsolve.characteristic.origin import origin, waves_meet_at_zero
from mpsolve.characteristic.table import Table
from mpsolve.problem.reduced import Guide, Reduced, reduce_problem

ICE = tracks.FloatingIce(B="5e7", h="0.6", rho_ice=917, rho_water=1025, depth="6.8", g="9.8", c=100, eta="0.1")
SPEEDS = ["2", "7.9", "9", "30"]  # √(g·depth) is 8.16 m/s
RADIUS = 1e-3


def reduced(v: str) -> Reduced:
    return reduce_problem(Problem(ICE, [vehicles.Mass(1000).at(0), vehicles.Mass(1000).at(10)], v=v))


def truth(guide: Guide, sigma: complex, x: Fraction) -> complex:
    """Σ N e^{Px}/D_P over the roots with Re P < 0, or minus those with Re P > 0, at Re σ > 0 and 60 digits."""
    with mpmath.workdps(60):
        s = mpmath.mpc(sigma)
        D, N = ({i: mpmath.mpc(0) for i in range(guide.degree + 1)} for _ in range(2))
        for table, polynomial in ((D, guide.D), (N, guide.N)):
            for (i, j), c in polynomial.items():
                table[i] += mpmath.mpf(c.numerator) / c.denominator * s**j
        roots = mpmath.polyroots([D[i] for i in sorted(D, reverse=True)], maxsteps=500, extraprec=800)
        place, total = mpmath.mpf(x.numerator) / x.denominator, mpmath.mpc(0)
        for P in roots:
            if (P.real < 0) == (x >= 0):
                slope = sum(i * c * P ** (i - 1) for i, c in D.items() if i)
                total += sum(c * P**i for i, c in N.items()) * mpmath.exp(P * place) / slope
        return complex(total if x >= 0 else -total)


@settings(max_examples=15)
@given(st.sampled_from(SPEEDS), st.floats(0.01, 1), st.floats(-1.5, 1.5))
def test_the_receptance_is_that_of_residues(v: str, share: float, angle: float) -> None:
    problem = reduced(v)
    found = origin(problem.guide)
    assert found is not None
    distances = np.array([-1.5, 0.0, 2.0])
    G = found(RADIUS, distances)
    assert G.good[0]
    sigma = share * RADIUS * complex(np.cos(angle), np.sin(angle))
    for k, x in enumerate(distances):
        linear = G.jet.a[0, k] + G.jet.b[0, k] * sigma
        assert abs(truth(problem.guide, sigma, Fraction(x)) - linear) <= G.jet.e[0, k]
    assert G.jet.e.max() < 0.1 * np.abs(G.jet.a).max()


@pytest.mark.parametrize("v", SPEEDS)
def test_it_joins_on_to_splittings_with_the_same_sides_alone(v: str) -> None:
    problem = reduced(v)
    found = origin(problem.guide)
    assert found is not None
    up, at = sum(found.up), np.array([RADIUS * 0.9 + 0j])
    thin = split(Table.of(problem.guide.D), at, np.zeros(1), up)
    assert found.links(thin, complex(at[0]))
    swapped = thin.z.copy()
    swapped[:, [up - 1, up]] = swapped[:, [up, up - 1]]
    other = split(Table.of(problem.guide.D), at, np.zeros(1), up, swapped)
    assert not found.links(other, complex(at[0]))
    assert not found.links(split(Table.of(problem.guide.D), at, np.zeros(1), up - 1), complex(at[0]))


def test_a_disc_that_is_too_large_is_not_good() -> None:
    found = origin(reduced("7.9").guide)
    assert found is not None
    assert not found(1.0, Arrays(reduced("7.9")).distances[0]).good[0]


def test_where_waves_do_not_meet_or_nothing_bounds_the_receptance() -> None:
    beam = reduce_problem(Problem(tracks.EulerBernoulli(EI=1, m=1, k=1, c=1), vehicles.Mass(1), v="0.5"))
    assert not waves_meet_at_zero(beam.guide)
    free = reduce_problem(Problem(tracks.String(T=1, m=1), vehicles.Mass(1), v="0.5"))
    assert waves_meet_at_zero(free.guide)
    assert origin(free.guide) is None  # a constant force takes a free string away
