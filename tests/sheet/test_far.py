"""The far field: enclosures for all |w| ≥ W hold the true p-roots, and no root lies beyond ρ."""

from __future__ import annotations

import cmath
import math
import random

import flint
import pytest
from hypothesis import assume, given, settings
from hypothesis import strategies as st
from oracle import Truth, cases, grid, holds

from mpsolve import Case
from mpsolve.errors import PrecisionError
from mpsolve.fields import ball_arithmetic
from mpsolve.model.branch import track
from mpsolve.sheet.far import _next_reflection, _two_mass_product, asymptotics, far_radius, prove_far
from mpsolve.sheet.seek import seek

few = settings(max_examples=25)
sectors = st.builds(cmath.rect, grid(1, 8), grid(0, 1).map(lambda turn: turn * math.pi / 2))


def point_beyond(case: Case, w: complex) -> tuple[Truth, complex]:
    """q with r = w²/2, and the truth there."""
    truth = Truth(case, 40)
    q = w**2 / 2 + 1j * float(truth.eta_b)
    assume((w**2).imag > 1e-3)
    return truth, q


@few
@given(cases(), st.sampled_from([8.0, 32.0, 500.0]), sectors)
def test_the_enclosures_hold_the_p_roots(case: Case, W: float, direction: complex) -> None:
    w = W * direction
    truth, q = point_beyond(case, w)
    with ball_arithmetic(64) as field:
        try:
            at = asymptotics(track(case, field), W)
        except PrecisionError:
            assume(False)
    mp = truth.mp
    q = mp.mpmathify(w) ** 2 / 2 + mp.j * truth.eta_b
    upper, lower = truth.p_roots(q)
    for p in (*upper, *lower):
        k = min(range(4), key=lambda k: abs(p / w - 1j**k))
        residue = 1 / mp.polyval([4, 0, 2 * truth.quartic(q)[2], truth.quartic(q)[3]], p)
        assert holds(at.P[k], p / w)
        assert holds(at.C[k], residue * mp.mpmathify(w) ** 3)
        assert abs(flint.acb(p / w) - flint.acb(1j**k)) < at.spread * (1 + 1e-12)
        assert (p in upper) == (k in (0, 1))
    assert holds(at.X, -2 * q**2 * truth.kernel(0, q) / (mp.pi * w))
    assert holds(at.gain, 4 * q**2 / mp.mpmathify(w) ** 4)


@few
@given(cases(masses=2), sectors)
def test_the_two_mass_bound_holds(case: Case, direction: complex) -> None:
    """|κ²η₁η₂ K(d)K(−d)| against |(1 − κη₁K(0))(1 − κη₂K(0))| beyond ρ, with Δ away from 0."""
    with ball_arithmetic(64) as field:
        model = track(case, field)
        rho = far_radius(model)
        W = math.sqrt(2 * rho)
        bound = _two_mass_product(model, asymptotics(model, W))
    assert bound < 1
    truth, q = point_beyond(case, W * direction)
    kappa, d = 2 * q**2 / truth.mp.pi, truth.x[1]
    diagonal = [1 - kappa * eta * truth.kernel(0, q) for eta in truth.eta_m]
    product = kappa**2 * truth.eta_m[0] * truth.eta_m[1] * truth.kernel(d, q) * truth.kernel(-d, q)
    assert flint.arb(abs(product / (diagonal[0] * diagonal[1]))) < bound
    assert abs(truth.delta(q)) > 0


@pytest.mark.parametrize("alpha", ["0.1", "0.5", "1.4"])
@pytest.mark.parametrize("masses", [1, 2, 3])
def test_no_candidate_lies_beyond_the_radius(alpha: str, masses: int) -> None:
    case = Case(alpha=alpha, eta_b="0.05", eta_m=(70, 10, 30)[:masses], positions=(0, "0.5", 2)[:masses])
    with ball_arithmetic(64) as field:
        rho = far_radius(track(case, field))
    beyond = [c.q for c in seek(case, 4 * rho) if abs(c.q - 0.05j) >= rho]
    assert beyond == []


def test_a_radius_within_the_roots_is_refused() -> None:
    """The roots of this case have |q| = 0.13 and 0.16."""
    case = Case(alpha="0.67", eta_b="0.05", eta_m=(70, 70), positions=(0, "1.5"))
    with ball_arithmetic(64) as field:
        for W in (0.25, 0.5, 1.0):
            with pytest.raises(PrecisionError):
                prove_far(track(case, field), W)


def test_closer_masses_need_a_larger_radius() -> None:
    with ball_arithmetic(64) as field:
        radii = [
            far_radius(track(Case(alpha="0.5", eta_b=0, eta_m=(1, 1), positions=(0, d)), field))
            for d in ("4", "0.5", "0.01")
        ]
    assert radii[0] <= radii[1] < radii[2]


# --- scattering between the masses -------------------------------------------------------------------------


def determinant(rows: list[list[complex]]) -> complex:
    if not rows:
        return 1
    minors = [[row[:k] + row[k + 1 :] for row in rows[1:]] for k in range(len(rows))]
    return sum((-1) ** k * v * determinant(m) for k, (v, m) in enumerate(zip(rows[0], minors, strict=True)))


@pytest.mark.parametrize("n", [2, 3, 4, 5])
@pytest.mark.parametrize("seed", range(10))
def test_the_determinant_is_a_product_of_reflections(n: int, seed: int) -> None:
    """det[δ + g_i e^{iw|x_i − x_k|}] = Π (1 + g_j z_j), z_j the reflection of the masses behind mass j."""
    chance = random.Random(seed)
    g = [complex(chance.uniform(-1, 1), chance.uniform(-1, 1)) for _ in range(n)]
    hop = [cmath.exp(1j * complex(chance.uniform(0, 6), chance.uniform(0, 1))) for _ in range(n - 1)]

    def travelled(i: int, k: int) -> complex:
        return math.prod(hop[min(i, k) : max(i, k)], start=1 + 0j)

    rows = [[1 if i == k else g[i] * travelled(i, k) for k in range(n)] for i in range(n)]
    product, reflection = 1 + 0j, 0j
    for j in reversed(range(n)):
        z = reflection * hop[j] ** 2 if j < n - 1 else 0j
        product *= 1 + g[j] * z
        reflection = (z * (1 - 2 * g[j]) - g[j]) / (1 + g[j] * z)
    assert abs(determinant(rows) - product) < 1e-9 * (1 + abs(product))


@pytest.mark.parametrize("most", [1, 1.01, 1.1, 1.3])
def test_a_passive_obstacle_reflects_little_more_than_it_gets(most: float) -> None:
    """|Γ|² ≤ 1 + (z² − 1)/(√2 − z)² for g = 1/d with Re d, Im d ≥ 1, and the code's bound covers it."""
    with ball_arithmetic(64):
        bound = _next_reflection(flint.arb(most), 1 / flint.arb(2).sqrt(), flint.arb(0), flint.arb(0))
    chance = random.Random(1)
    for _ in range(1000):
        d = complex(1 + chance.expovariate(2), 1 + chance.expovariate(2))
        z = most * cmath.exp(1j * chance.uniform(0, math.tau)) * chance.choice([1, 1, 0.9])
        reflected = abs((z * (d - 2) - 1) / (d + z))
        assert reflected**2 <= 1 + (most**2 - 1) / (math.sqrt(2) - most) ** 2 + 1e-12
        assert bound > reflected * (1 - 1e-12)
