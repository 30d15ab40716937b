"""Float64 arrays against residue sums at 50 digits: random tracks, the tracks of the package, roots that meet."""

from __future__ import annotations

from fractions import Fraction
from typing import Any

import numpy as np
import pytest
from called import calls
from residue import TRACKS, Residues, random_track

from mpsolve.characteristic.floats import Floats, Receptance
from mpsolve.problem.problem import Problem
from mpsolve.problem.reduced import reduce_problem, track_guide
from mpsolve.tracks import EulerBernoulli
from mpsolve.vehicles import Bogie, Mass

XI = [Fraction(-7, 4), Fraction(0), Fraction(1, 2)]
MOVING = [Fraction(0), Fraction(1, 3), Fraction(17, 8)]


def agree(track: Any, v: Fraction, sigma: Any, xi: list[Fraction] = XI, tolerance: float = 1e-12) -> None:
    local = Receptance(track_guide(track, v))
    truth = Residues(local.guide, 40)
    G, G_sigma = local(sigma, xi)
    for k, s in enumerate(sigma.tolist()):
        for i, x in enumerate(xi):
            scale = abs(complex(truth(Fraction(0), s))) + abs(complex(truth(x, s)))
            assert abs(G[i][k] - complex(truth(x, s))) <= tolerance * scale
            slope = complex(truth.slope(x, s))
            assert abs(G_sigma[i][k] - slope) <= 100 * tolerance * (scale + abs(slope))


def points(seed: int, count: int = 4) -> Any:
    draw = np.random.default_rng(seed)
    return draw.uniform(0.1, 1.5, count) + 1j * draw.uniform(-2, 2, count)


@pytest.mark.parametrize("size", [1, 2, 3])
@pytest.mark.parametrize("v", MOVING)
def test_random_tracks(size: int, v: Fraction) -> None:
    """Of degree 4 to 10, where residues cancel up to five digits."""
    for seed in range(3):
        agree(random_track(size, seed), v, points(10 * seed + size, 2), tolerance=1e-11)


@pytest.mark.parametrize("name", TRACKS)
@pytest.mark.parametrize("share", [Fraction(0), Fraction(1, 2), Fraction(3, 2)])
def test_the_tracks_of_the_package(name: str, share: Fraction) -> None:
    """At rest, and at velocities that are 1/2 and 3/2 in scaled units or so."""
    still = track_guide(TRACKS[name], Fraction(0))
    v = share * Fraction(2) ** (still.length - still.time)
    agree(TRACKS[name], v, points(3))


MEET = EulerBernoulli(EI="1/4", m=1, k="0.7", c="0.1", kp=1)
"""At rest and s = 1/2 its D = EI (P² − 2)² has two double roots, P = ±√2."""


def double(xi: float) -> float:
    """(1/2π) ∫ e^{ipξ}/(EI (p² + 2)²) dp, in closed form."""
    a = 2**0.5
    return float(np.exp(-a * abs(xi)) * (1 + a * abs(xi)) / a**3)


@pytest.mark.parametrize("away", [0, 1e-15, 1e-12, 1e-9, 1e-6, 1e-3, 0.03, 0.1, 0.3])
def test_roots_of_one_side_that_meet(away: float) -> None:
    guide = track_guide(MEET, Fraction(0))
    time, length = 2.0**guide.time, 2.0**guide.length
    sigma = np.array([0.5 + away, 0.5 + away * 1j]) * time
    G, G_sigma = Receptance(guide)(sigma, XI)
    if away <= 1e-12:
        for row, x in zip(G, XI, strict=True):
            assert np.abs(float(guide.g) * row - double(float(x) * length)).max() < 1e-11
    if away >= 1e-9:
        truth = Residues(guide, 50)
        for k, s in enumerate(sigma.tolist()):
            for i, x in enumerate(XI):
                assert abs(G[i][k] - complex(truth(x, s))) < 1e-12 * abs(complex(truth(Fraction(0), s)))
                assert abs(G_sigma[i][k] - complex(truth.slope(x, s))) < 1e-9 * abs(complex(truth.slope(x, s)))


def test_conjugation() -> None:
    local = Receptance(track_guide(random_track(3, 5), Fraction(1, 2)))
    sigma = points(1, 20)
    for one, other in zip(local(sigma, XI), local(sigma.conj(), XI), strict=True):
        assert np.allclose(np.array(one), np.array(other).conj(), rtol=1e-12, atol=1e-13)


def test_undamped_waves_run_away_from_the_force() -> None:
    """On the real axis every root is a wave with Re P = 0; the limit from Re σ > 0 says which side it takes."""
    guide = track_guide(EulerBernoulli(EI="1/4", m=1, k=1), Fraction(3, 5))
    sigma = 1j * np.linspace(1.05, 3, 40) * 2.0**guide.time
    axis, right = (np.array(Receptance(guide)(s, XI)[0]) for s in (sigma, sigma + 1e-7))
    assert np.abs(axis - right).max() < 1e-5 * np.abs(axis).max()


def problem(kind: str) -> Problem:
    if kind == "bogie":
        bogie = Bogie(wheel=1813, frame=2615, inertia=1476, wheelbase="2.5", k="2.4e6", c="3e4", k_contact="1.5e9")
        return Problem(TRACKS["two-layer"], [bogie.at(1)], 600)
    beam = EulerBernoulli(EI="1/4", m=1, k=1, c="0.1")
    return Problem(beam, [Mass(70).at(0), Mass(70).at("1.5"), Mass(3).at(4)], "0.8")


@pytest.mark.parametrize("kind", ["bogie", "masses"])
def test_delta_is_the_determinant(kind: str) -> None:
    """Against the bordered determinant, put together here from the unscaled equations, up to one constant."""
    given = problem(kind)
    reduced = reduce_problem(given)
    pencil, guide = given.pencil, reduced.guide
    sigma = points(8, 6)
    found, slope = Floats(reduced).delta(sigma)
    truth = Residues(guide, 40)
    mp, ratios = truth.mp, []
    unit, rate = Fraction(2) ** guide.length, mp.mpf(2) ** -guide.time

    def delta(s: Any) -> Any:
        n, m = pencil.size, pencil.contacts
        number = lambda x: mp.mpf(x.numerator) / x.denominator  # noqa: E731
        t = mp.mpmathify(s) * rate
        A = mp.matrix(n + m, n + m)
        for i in range(n):
            for j in range(n):
                A[i, j] = number(pencil.K[i][j]) + t * number(pencil.C[i][j]) + t * t * number(pencil.M[i][j])
            for j in range(m):
                A[i, n + j], A[n + j, i] = -number(pencil.B[i][j]), number(pencil.B[i][j])
        for i in range(m):
            for j in range(m):
                A[n + i, n + j] = number(guide.g) * truth((pencil.places[i] - pencil.places[j]) / unit, s)
            A[n + i, n + i] += number(pencil.h[i])
        return mp.det(A)

    for k, s in enumerate(sigma.tolist()):
        exact, h = delta(s), mp.mpf(10) ** -12
        rate_of = (delta(s + h) - delta(s - h)) / (2 * h)
        ratios.append(complex(found[k] / exact))
        assert abs(complex(slope[k] / found[k] / (rate_of / exact)) - 1) < 1e-10
    assert max(abs(r / ratios[0] - 1) for r in ratios) < 1e-11


def test_the_slope_at_an_exactly_singular_matrix() -> None:
    """A column of the matrix is 0 there, which a solver refuses."""
    from mpsolve.characteristic.floats import _adjugate

    A = np.array([[[2.0, 3, 1], [4, 6, 5], [1, 1.5, 7]], [[1, 0, 0], [0, 2, 0], [0, 0, 0]]], complex)
    minors = [[np.delete(np.delete(a, i, 0), j, 1) for i in range(3)] for a in A for j in range(3)]
    truth = np.array(
        [[(-1) ** (i + j) * np.linalg.det(m) for i, m in enumerate(row)] for j, row in enumerate(minors)]
    )
    assert np.allclose(np.abs(_adjugate(A)), np.abs(truth.reshape(2, 3, 3)), atol=1e-12)
    assert np.allclose(_adjugate(A)[1], np.diag([0, 0, 2.0]), atol=1e-12)


def test_no_loop_over_points() -> None:
    floats = Floats(reduce_problem(problem("masses")))
    few, many = points(0, 4000), points(0, 12_000)
    floats.delta(few)
    assert calls(lambda: floats.delta(many)) < 1.5 * calls(lambda: floats.delta(few))


def test_newtons_step_leads_to_one_zero_and_then_to_another() -> None:
    """For a pair on a damped beam; at the zeros found Δ̂ is as good as 0 beside what it is around."""
    floats = Floats(reduce_problem(problem("masses")))
    found: list[complex] = []
    for start in (0.1j, 0.3j):
        sigma = np.array([start])
        for _ in range(60):
            sigma = sigma + floats.step(sigma, found)
        around = floats.delta(sigma * (1 + 1e-3 * np.array([1, 1j, -1, -1j])))[0]
        assert np.abs(floats.delta(sigma)[0][0]) < 1e-9 * np.abs(around).min()
        assert all(abs(sigma[0] - other) > 1e-3 for other in found)
        found.append(complex(sigma[0]))


def test_steps_of_large_matrices_are_taken_a_few_at_a_time(monkeypatch: pytest.MonkeyPatch) -> None:
    floats, sigma = Floats(reduce_problem(problem("masses"))), points(5, 40)
    whole = floats.step(sigma, [0.1j])
    monkeypatch.setattr("mpsolve.characteristic.floats._AT_ONCE", 50)
    assert np.allclose(floats.step(sigma, [0.1j]), whole, rtol=1e-9)
    assert floats.step(sigma[:0], []).shape == (0,)
