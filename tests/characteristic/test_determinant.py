"""R·Δ̂ without a division: R·Δ̂ where that can be formed, and finite where an upper p-root meets a lower one."""

from __future__ import annotations

from fractions import Fraction
from itertools import pairwise
from typing import Any

import pytest
from evans import delta, evans, split_digits
from multiprecision import Multiprecision
from residue import TRACKS, Residues, holds, random_track

from mpsolve.characteristic.bordering import Bordering
from mpsolve.characteristic.floats import Floats
from mpsolve.characteristic.proved import Proved
from mpsolve.characteristic.splitting import Splitting, monic
from mpsolve.characteristic.symbol import Symbols
from mpsolve.numbers.balls import Balls, acb, arb, precision
from mpsolve.problem.problem import Problem
from mpsolve.problem.reduced import Reduced, reduce_problem
from mpsolve.tracks import EulerBernoulli
from mpsolve.vehicles import Bogie, Mass

BEAM = EulerBernoulli(EI="1/4", m=1, k=1, c="0.1", N="0.1")
BIG = Bogie(wheel=1813, frame=2615, inertia=1476, wheelbase="2.5", k="2.4e6", c="3e4", k_contact="1.5e9")
BOGIE = Bogie(wheel=18, frame=26, inertia=14, wheelbase="1.5", k=2, c="0.3", k_contact=15)


def split(reduced: Reduced, sigma: Any, digits: int) -> tuple[Multiprecision, Splitting, Residues]:
    """By mpmath's roots and the sign of their real parts."""
    K, truth = Multiprecision(digits), Residues(reduced.guide, digits)
    roots = sorted(truth.roots(sigma), key=lambda z: z.real)
    upper = sum(1 for z in roots if z.real < 0)
    D = truth.coefficients(reduced.guide.D, sigma)
    return K, Splitting(D[-1], monic(roots[:upper]), monic(roots[upper:])), truth


def both(reduced: Reduced, sigma: Any, digits: int) -> tuple[Any, Any, Any]:
    """R·Δ̂ by the bordered form, R, and Δ̂ from residues."""
    K, split_, truth = split(reduced, sigma, digits)
    border = Bordering.of(reduced, eliminate=False)
    G = [truth(x, sigma) for x in border.distances]
    delta = K.det(border.at(K, K.mp.mpmathify(sigma), G))
    product, R = evans(K, reduced, Symbols.of(reduced.guide), split_, K.mp.mpmathify(sigma))
    return product, R, delta


@pytest.mark.parametrize(
    ("track", "v"),
    [
        (BEAM, Fraction(0)),
        (BEAM, Fraction(3)),
        (TRACKS["kelvin-voigt"], Fraction(100)),
        (TRACKS["two-layer"], Fraction(600)),
        (TRACKS["string"], Fraction(100)),
        (TRACKS["string"], Fraction(300)),
        (random_track(2, 1), Fraction(1, 2)),
        (random_track(3, 2), Fraction(0)),
    ],
)
def test_it_is_r_times_delta(track: Any, v: Fraction) -> None:
    reduced = reduce_problem(Problem(track, [BOGIE.at(1), Mass(3).at(-1)], v))
    for sigma in (0.5 + 0.25j, 0.125 - 1.5j):
        product, R, delta = both(reduced, sigma, 40)
        assert abs(product / (R * delta) - 1) < 1e-25


def test_one_function_in_three_arithmetics() -> None:
    """Δ̂ and its slope in mpmath, in balls, and in float64 by residues and by companions, are the same."""
    reduced = reduce_problem(Problem(TRACKS["two-layer"], [BIG.at(1), Mass(900).at(-3)], 300))
    symbols, border, proved = Symbols.of(reduced.guide), Bordering.of(reduced), Proved(reduced)
    for s in (0.5 + 0.25j, 0.125 - 1.5j):
        K = Multiprecision(60)
        digits = delta(
            K, border, symbols, split_digits(K, symbols, K.mp.mpmathify(s), proved.upper), K.mp.mpmathify(s)
        )
        with precision(150):
            point = acb(s.real, s.imag)
            balls = proved.delta(point)
            companions = delta(Balls(), border, symbols, proved.splitting(point).splitting, point)
        floats = Floats(reduced).delta([s])
        for exact, ball, other, value in zip(digits, balls, companions, floats, strict=True):
            assert holds(ball, exact)
            assert holds(other, exact)
            assert max(float(ball.rad()), float(other.rad())) < 1e-25 * abs(exact)
            assert abs(value[0] / complex(exact) - 1) < 1e-12


def branch_point(reduced: Reduced, digits: int) -> Any:
    """σ where an upper and a lower root meet: D = D_P = 0 on the imaginary P-axis, at Re σ = −c/2m."""
    truth = Residues(reduced.guide, digits)
    mp = truth.mp

    def equations(P: Any, sigma: Any) -> list[Any]:
        D = truth.coefficients(reduced.guide.D, sigma)
        slope = [i * c for i, c in enumerate(D)][1:]
        return [mp.polyval(D[::-1], P), mp.polyval(slope[::-1], P)]

    time, length = 2.0**reduced.guide.time, 2.0**reduced.guide.length
    alpha, start = 0.6, None
    for k in range(-4000, 4000):  # the branch point is the least of ω(p) = αp + √(p⁴/4 − N p² + 1 − c²/4)
        p = k / 1000
        omega = alpha * p + (p**4 / 4 - 0.1 * p * p + 1 - 0.0025) ** 0.5
        start = min(start, (omega, p)) if start else (omega, p)
    assert start is not None
    P, sigma = mp.findroot(equations, [mp.mpc(0, start[1] * length), mp.mpc(-0.05 * time, start[0] * time)])
    return mp, P, sigma


def test_an_upper_root_meets_a_lower_one() -> None:
    """R goes to 0 and Δ̂ to infinity as √h; their product goes to a limit, in the same steps."""
    reduced = reduce_problem(Problem(BEAM, [Mass(70).at(0), Mass(70).at(1), Mass(30).at("1.8")], "0.6"))
    mp, _, meeting = branch_point(reduced, 80)
    values, factors = [], []
    for power in (4, 8, 12, 16, 20):
        product, R, delta = both(reduced, meeting + mp.mpf(10) ** -power, 80)
        assert abs(product / (R * delta) - 1) < mp.mpf(10) ** -40
        values.append(product)
        factors.append(abs(R))
    assert all(0.5e-2 < b / a < 2e-2 for a, b in pairwise(factors))
    steps = [abs(b - a) for a, b in pairwise(values)]
    assert all(0.5e-2 < b / a < 2e-2 for a, b in pairwise(steps))
    assert abs(values[-1]) > 1e3 * steps[-1]


def test_in_balls_next_to_the_branch_point() -> None:
    reduced = reduce_problem(Problem(BEAM, [Mass(70).at(0), Mass(70).at(1)], "0.6"))
    mp, _, meeting = branch_point(reduced, 80)
    near = meeting + mp.mpf(2) ** -40
    product = both(reduced, near, 80)[0]
    with precision(250):
        text = [mp.nstr(x, 70) for x in (near.real, near.imag)]
        sigma = acb(arb(text[0]).mid(), arb(text[1]).mid())
        proved = Proved(reduced)
        split_ = proved.splitting(sigma).splitting
        found, R = evans(Balls(), reduced, proved.symbols, split_, sigma)
        assert float(abs(found).rad()) < 1e-40
    assert abs(complex(found) / complex(product) - 1) < 1e-13
    assert abs(complex(R)) < 1e-4
