"""The change of an argument over a disc, against determinants at 50 digits."""

from __future__ import annotations

from typing import Any

import mpmath
import numpy as np
import pytest

from mpsolve.numbers.jets import Jet
from mpsolve.proof.turning import THETA, Regular, pivot_arguments, regular, solution

MP = mpmath.MPContext()
MP.dps = 50


def pencils(n: int, count: int, seed: int) -> tuple[Any, Any, Any]:
    """A₀, A₁ and radii: matrices A₀ + A₁ t, some of them nearly singular."""
    rng = np.random.default_rng(seed)
    a, b = (rng.normal(size=(count, n, n)) + 1j * rng.normal(size=(count, n, n)) for _ in range(2))
    return a, b, 10.0 ** rng.uniform(-3, 0, count) / n


def at(a: Any, b: Any, t: Any) -> Jet:
    """Thin jets of A₀ + A₁ t; the rounding of the sum is their error."""
    value = a + b * t[:, None, None]
    return Jet(value, 0 * value, 4e-16 * (np.abs(a) + np.abs(b * t[:, None, None])), np.zeros(len(a)))


def determinant(a: Any, b: Any, t: Any) -> Any:
    rows = [[MP.mpc(x) + MP.mpc(y) * MP.mpc(t) for x, y in zip(p, q, strict=True)] for p, q in zip(a, b, strict=True)]
    return MP.det(MP.matrix(rows))


@pytest.mark.parametrize("n", [1, 2, 5, 8])
def test_the_change_of_the_argument_is_within_its_error(n: int) -> None:
    a, b, r = pencils(n, 60, n)
    piece = regular(Jet(a, b, np.zeros(a.shape), r))
    assert 10 < piece.good.sum() < 60
    rng = np.random.default_rng(n + 50)
    turn = rng.uniform(0, 2 * np.pi, (2, 60))
    ends = [pivot_arguments(piece, at(a, b, r * np.exp(1j * angle))) for angle in turn]
    for k in np.flatnonzero(piece.good):
        assert ends[0][2][k]
        assert ends[1][2][k]
        values = [determinant(a[k], b[k], r[k] * np.exp(1j * angle[k])) for angle in turn]
        off = ends[1][0][k] - ends[0][0][k] - float(MP.arg(values[1] / values[0]))
        whole = 2 * np.pi * round(off / 2 / np.pi)
        error = ends[0][1][k] + ends[1][1][k]
        assert abs(off - whole) <= error + 1e-12
        assert error < 1e-6


def test_followed_along_a_path_no_turn_is_lost() -> None:
    """Between two points of a proved disc the argument runs as in small steps, also where it turns by more than π."""
    n = 6
    a, b, r = pencils(n, 80, 3)
    a[0], b[0], r[0] = np.eye(n), 0.85 * np.eye(n), 1.0
    piece = regular(Jet(a, b, np.zeros(a.shape), r))
    most = 0.0
    for k in np.flatnonzero(piece.good):
        steps = np.linspace(-1j, 1j, 200) * r[k]
        values = np.linalg.det(a[k] + b[k] * steps[:, None, None])
        truth = float(np.angle(values[1:] / values[:-1]).sum())
        one = Regular(piece.R[k : k + 1], piece.x[k : k + 1], piece.theta[k : k + 1], piece.good[k : k + 1])
        start, end = (pivot_arguments(one, at(a[k : k + 1], b[k : k + 1], np.array([t])))[0] for t in steps[[0, -1]])
        assert float((end - start)[0]) == pytest.approx(truth, abs=1e-6)
        most = max(most, abs(truth))
    assert most > 8


def test_pivots_stay_near_1_on_a_proved_disc() -> None:
    a, b, r = pencils(5, 200, 8)
    piece = regular(Jet(a, b, np.zeros(a.shape), r))
    for k in np.flatnonzero(piece.good)[:40]:
        for angle in np.linspace(0, 2 * np.pi, 12):
            lu = piece.R[k] @ (a[k] + b[k] * r[k] * np.exp(1j * angle))
            for i in range(5):
                assert abs(lu[i, i] - 1) <= piece.theta[k] + 1e-12
                lu[i + 1 :, i + 1 :] -= np.outer(lu[i + 1 :, i], lu[i, i + 1 :]) / lu[i, i]


@pytest.mark.parametrize("n", [1, 3, 8])
def test_a_disc_with_a_singular_matrix_is_never_proved(n: int) -> None:
    a, b, r = pencils(n, 400, 20 + n)
    least = np.min(np.abs(np.linalg.eigvals(np.linalg.solve(b, a))), 1)  # det(A₀ + A₁t) = 0 at −these
    piece = regular(Jet(a, b, np.zeros(a.shape), r))
    assert (least <= r).any()
    assert not piece.good[least <= r].any()
    # the remainder is as good as a term in t
    other = regular(Jet(a, 0 * b, np.abs(b) * r[:, None, None], r))
    assert not other.good[least <= r].any()


def test_a_small_disc_is_proved_and_theta_is_of_its_size() -> None:
    a, b, _ = pencils(4, 50, 5)
    r = np.full(50, 1e-6)
    piece = regular(Jet(a, b, np.zeros(a.shape), r))
    assert piece.good.all()
    spectral = np.max(np.abs(np.linalg.eigvals(np.abs(np.linalg.inv(a) @ b))), 1) * 1e-6
    assert (piece.theta >= spectral).all()
    assert np.median(piece.theta / spectral) < 2


def test_at_the_edge_of_theta() -> None:
    """1 + t on |t| ≤ r is proved for r below θ, and not for r above."""
    one = np.ones((2, 1, 1), complex)
    r = np.array([THETA * 0.999, THETA * 1.001])
    assert regular(Jet(one, one, np.zeros((2, 1, 1)), r)).good.tolist() == [True, False]


def test_errors_of_rounding_are_not_below_what_pivots_lose() -> None:
    """R M is perturbed by as much as the radii say: arguments move by no more than the error."""
    rng = np.random.default_rng(1)
    a, b, r = pencils(6, 100, 9)
    piece = regular(Jet(a, b, np.zeros(a.shape), r))
    edge = a + b * r[:, None, None]
    e = np.full(a.shape, 1e-6) * np.abs(rng.normal(size=a.shape))
    total, error, good = pivot_arguments(piece, Jet(edge, 0 * a, e, np.zeros(100)))
    assert good.sum() > 10
    for _ in range(20):
        moved = edge + e * np.exp(2j * np.pi * rng.uniform(size=a.shape))
        other = pivot_arguments(piece, Jet(moved, 0 * a, 0 * e, np.zeros(100)))[0]
        assert (np.abs(other - total)[good] <= error[good]).all()


def test_a_pivot_near_0_turns_ten_times_as_far() -> None:
    piece = regular(Jet(np.ones((1, 1, 1), complex), 0.89 * np.ones((1, 1, 1)), np.zeros((1, 1, 1)), np.ones(1)))
    value, e = np.full((1, 1, 1), 0.11 + 0j), np.full((1, 1, 1), 1e-4)
    total, error, good = pivot_arguments(piece, Jet(value, 0 * value, e, np.zeros(1)))
    assert good.all()
    moved = pivot_arguments(piece, Jet(value + 1e-4j, 0 * value, 0 * e, np.zeros(1)))[0]
    assert 8e-4 < abs(moved - total)[0] <= error[0]


def test_what_is_not_finite_is_not_proved() -> None:
    one, zero = np.ones((1, 2, 2), complex) + np.eye(2), np.zeros((1, 2, 2))
    nan, endless = np.full(one.shape, complex(np.nan)), np.full(one.shape, complex(np.inf))
    for a, b, e in ((nan, one, zero), (one, endless, zero), (one, one, zero + np.inf)):
        assert not regular(Jet(a, b, e, np.array([1e-9]))).good.any()
    assert not regular(Jet(one * 0, 0 * one, zero, np.zeros(1))).good.any()
    piece = regular(Jet(one, 0 * one, zero, np.zeros(1)))
    assert piece.good.all()
    for a, e in ((nan, zero), (one, zero + np.inf), (one, zero + 1)):
        assert not pivot_arguments(piece, Jet(a, 0 * one, e, np.zeros(1)))[2].any()


def test_the_solution_holds_the_true_one_and_is_narrow() -> None:
    rng = np.random.default_rng(3)
    n, r = 5, 1e-3

    def draw(*shape: int) -> np.ndarray:
        return rng.normal(size=shape) + 1j * rng.normal(size=shape)

    a, b, f, g = draw(3, n, n), draw(3, n, n), draw(3, n, 1), draw(3, n, 1)
    radii = np.full(3, r)
    A, F = Jet(a, b, np.full(a.shape, 1e-9), radii), Jet(f, g, np.full(f.shape, 1e-9), radii)
    y, good = solution(A, F)
    assert good.all()
    assert (y.e < 1e-3).all()
    for _ in range(200):
        t = r * np.sqrt(rng.uniform()) * np.exp(2j * np.pi * rng.uniform())
        matrix = a + b * t + 1e-9 * np.exp(2j * np.pi * rng.uniform(size=a.shape))
        right = f + g * t + 1e-9 * np.exp(2j * np.pi * rng.uniform(size=f.shape))
        truth = np.linalg.solve(matrix, right)
        assert (np.abs(truth - y.a - y.b * t) <= y.e).all()


def test_a_singular_matrix_is_not_solved() -> None:
    a = np.array([[[1.0 + 0j, 1], [1, 1 + 1e-4]]])
    zero = np.zeros_like(a)
    A = Jet(a, zero, np.full(a.shape, 1e-3), np.array([1e-3]))
    f = Jet(np.ones((1, 2, 1), complex), np.zeros((1, 2, 1), complex), np.zeros((1, 2, 1)), np.array([1e-3]))
    assert not solution(A, f)[1].any()
