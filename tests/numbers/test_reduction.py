"""Determinants of balls: exact values inside, tight where plain elimination is not, also where they vanish."""

from __future__ import annotations

from fractions import Fraction
from typing import Any

import numpy as np
import pytest

from mpsolve.errors import PrecisionError
from mpsolve.numbers.balls import acb, acb_mat, arb, exact_ball, precision, square
from mpsolve.numbers.reduction import Reduction, det_and_trace


def balls(a: Any, half: float = 0.0) -> Any:
    n = len(a)
    spread = square(half) if half else acb(0)
    return acb_mat(n, n, [exact_ball(complex(x)) + spread for x in np.asarray(a).ravel()])


def exact_det(a: Any) -> complex:
    """By elimination in fractions, of a matrix of real floats."""
    rows = [[Fraction(float(x)) for x in row] for row in a]
    value = Fraction(1)
    for k in range(len(rows)):
        pivot = next(i for i in range(k, len(rows)) if rows[i][k])
        if pivot != k:
            rows[k], rows[pivot], value = rows[pivot], rows[k], -value
        value *= rows[k][k]
        for i in range(k + 1, len(rows)):
            factor = rows[i][k] / rows[k][k]
            rows[i] = [x - factor * y for x, y in zip(rows[i], rows[k], strict=True)]
    return complex(value)


@pytest.mark.parametrize("n", [1, 2, 3, 5, 8, 20])
def test_the_exact_determinant_is_held(n: int) -> None:
    draw = np.random.default_rng(n)
    for _ in range(4):
        a, slope = draw.normal(size=(n, n)), draw.normal(size=(n, n))
        with precision(120):
            A, A_slope = balls(a), balls(slope)
            value, rate = Reduction.of(A).determinant(A, A_slope)
        exact = exact_det(a)
        turn = exact * np.trace(np.linalg.solve(a, slope))
        assert abs(complex(value) / exact - 1) < 1e-15
        assert abs(complex(rate) - turn) < 1e-8 * (abs(turn) + abs(exact))
        assert float(value.rad()) < 1e-28 * abs(exact)


def test_wide_entries_of_twenty_contacts() -> None:
    """The width is that of the first-order change, where plain elimination has lost all."""
    n, half = 20, 1e-7
    a = np.random.default_rng(1).normal(size=(n, n)) + 3 * np.eye(n)
    with precision(64):
        A = balls(a, half)
        value, _ = Reduction.of(A).determinant(A, A)
        first_order = half * abs(exact_det(a)) * np.abs(np.linalg.inv(a)).sum()
        assert value.contains(acb(exact_det(a)))
        assert float(value.rad()) < 6 * first_order


def singular(n: int) -> Any:
    """Small integers, so that the last column is exactly the sum of the others."""
    a = np.random.default_rng(n).integers(-9, 10, size=(n, n)).astype(float)
    a[:, -1] = a[:, :-1].sum(axis=1)
    return a


@pytest.mark.parametrize("n", [2, 3, 6])
def test_the_scalar_of_a_singular_matrix(n: int) -> None:
    a = singular(n)
    slope = np.random.default_rng(0).normal(size=(n, n))
    with precision(100):
        A, A_slope = balls(a), balls(slope)
        reduction = Reduction.of(A)
        assert reduction.scalar(A).contains(0)
        assert float(reduction.scalar(A).abs_upper()) < 1e-14
        value, rate = reduction.determinant(A, A_slope)
        assert value.contains(0)
        step = 1e-6
        change = (np.linalg.det(a + step * slope) - np.linalg.det(a - step * slope)) / (2 * step)
        assert abs(complex(rate) - change) < 1e-6 * abs(change)
        kernel = reduction.kernel(A)
        exact = [-1 / float(n > 0)] * (n - 1) + [1.0]
        ratio = [complex(x / kernel[-1]) for x in kernel]
        assert np.allclose(ratio, exact, rtol=0, atol=1e-12)


def test_the_slope_of_the_scalar() -> None:
    a, slope = singular(4), np.random.default_rng(5).normal(size=(4, 4))
    with precision(200):
        A, A_slope, step = balls(a), balls(slope), arb((1, -60))
        reduction = Reduction.of(A)
        ends = [reduction.scalar(A + A_slope * acb(x)) for x in (step, -step)]
        rate = (ends[0] - ends[1]) / (2 * step)
        assert float(abs(reduction.scalar_slope(A, A_slope) - rate)) < 1e-20


def test_what_it_refuses() -> None:
    with precision(64):
        with pytest.raises(PrecisionError, match="more than one dimension"):
            Reduction.of(balls(np.diag([1.0, 0, 0])))
        with pytest.raises(PrecisionError, match="float64"):
            Reduction.of(balls([[1.0, 0], [0, np.inf]]))
        wide = balls(np.eye(3), 2.0)
        with pytest.raises(PrecisionError, match="too wide"):
            Reduction.of(wide).scalar(wide)


def _balls(a: Any) -> Any:
    return acb_mat([[complex(x) for x in row] for row in a])


def _random(n: int, seed: int) -> Any:
    draw = np.random.default_rng(seed)
    return draw.normal(size=(n, n)) + 1j * draw.normal(size=(n, n))


@pytest.mark.parametrize("n", [1, 5, 6, 7, 16])
def test_both_are_those_of_floats_and_overlap_those_of_the_whole_matrix(n: int) -> None:
    a, d = _random(n, n), _random(n, 100 + n)
    with precision(80):
        A, D = _balls(a), _balls(d)
        value, trace = det_and_trace(A, D)
        assert value.overlaps(A.det())
        assert trace.overlaps(A.solve(D).trace())
        assert value.rel_accuracy_bits() > 45
        assert trace.rel_accuracy_bits() > 45
    assert complex(value) == pytest.approx(np.linalg.det(a), rel=1e-11)
    assert complex(trace) == pytest.approx(np.trace(np.linalg.solve(a, d)), rel=1e-9)


def test_a_regular_matrix_with_a_singular_half_and_a_singular_matrix() -> None:
    back = np.eye(8)[::-1]
    value, trace = det_and_trace(_balls(back), _balls(np.diag(np.arange(8.0)) @ back))
    assert complex(value) == pytest.approx(1)
    assert complex(trace) == pytest.approx(28)
    value, trace = det_and_trace(_balls(np.ones((8, 8))), _balls(np.eye(8)))
    assert not trace.is_finite()
