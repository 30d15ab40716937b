"""The matrix at rest against that from residues, its derivative, and what it says at the branch points themselves."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

from mpsolve import Case
from mpsolve.characteristic.disc_matrix import Arrays
from mpsolve.characteristic.resting import Resting
from mpsolve.problem.cases import as_problem
from mpsolve.problem.line import on_line
from mpsolve.problem.reduced import reduce_problem

CASES = [
    {"eta_m": ("2", "3", "5"), "positions": ("0", "1", "1.7"), "eta_n": "0.3"},
    {"eta_m": ("2", "3"), "positions": ("0", "1.5"), "eta_n": "-0.4"},
    {"eta_m": ("7",), "positions": ("0",)},
]
S = np.array([1.0, 0.5, 0.3 + 0.2j, 0.6 + 0.1j, 0.7 + 0.1j])


def resting(given: dict[str, Any], eta_b: str = "0.2") -> Resting:
    line = on_line(reduce_problem(as_problem(Case(alpha=0, eta_b=eta_b, **given))))
    assert line is not None
    return Resting(line.lower)


def product(half: Resting, s: Any) -> tuple[Any, Any, Any]:
    """π, z and the factor between the determinant and Δ̂."""
    EI, A, k, m = map(float, half.beam)
    pi = (s * s + A) / 2
    return pi, np.sqrt((k - EI * pi**2) / m), 2 * EI * pi * s * (1 if half.single else -2 * EI * s)


@pytest.mark.parametrize("given", CASES)
def test_the_determinant_is_that_of_residues(given: dict[str, Any]) -> None:
    half = resting(given)
    s = S if "-" not in given.get("eta_n", "") else S + 1.0  # U has Re P < 0
    _, z, factor = product(half, s)
    arrays = Arrays(half.reduced)
    _, G, good = arrays.evaluate(1j * z, np.zeros(len(s)), 2)
    expected = np.linalg.det(arrays.matrix(G, 1j * z).a) * factor
    assert good.all()
    assert np.linalg.det(half.over(s, np.zeros(len(s))).a) == pytest.approx(expected, rel=1e-9)


@pytest.mark.parametrize("given", CASES)
def test_the_forms_hold_the_function_and_not_much_more(given: dict[str, Any]) -> None:
    half, r = resting(given), 1e-3
    over = half.over(S, np.full(len(S), r))
    for h in r * 0.999 * np.exp([0.3j, 2j, 4j]):
        there = half.over(S + h, np.zeros(len(S)))
        off = np.abs(there.a - over.a - over.b * h)
        assert (off <= over.e + there.e).all()
    assert over.e.max() < 1e-3 * np.abs(over.a).max()  # of second order
    assert (np.abs(over.b) > 0).any()


def test_at_a_branch_point_two_close_masses_leave_the_square_of_their_distance() -> None:
    """s = 0: rows (1/Mτ² and 0; p = 1, q = x) and columns (1, −x): the determinant is −(x_2 − x_1)² times M₁M₂τ⁴."""
    half = resting({"eta_m": ("2", "3"), "positions": ("0", "0.001")}, "0")
    at = half.over(np.zeros(1), np.zeros(1))
    M = [float(half.reduced.S[2][j][j]) for j in range(2)]
    gap = float(half.reduced.places[1] - half.reduced.places[0])
    tau = float(half.beam[2] / half.beam[3])  # |τ|² at π = 0
    assert abs(np.linalg.det(at.a)[0]) == pytest.approx(gap**2 * M[0] * M[1] * tau**2, rel=1e-9)


def test_places_too_far_apart_are_not_bounded() -> None:
    half = resting({"eta_m": ("2", "3"), "positions": ("0", "200")})
    assert not np.isfinite(half.over(np.ones(1), np.zeros(1)).e).all()
