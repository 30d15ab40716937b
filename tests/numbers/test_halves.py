"""det A and tr A⁻¹A′ by halves against numpy and against FLINT on the whole matrix."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

from mpsolve.numbers.balls import acb_mat, precision
from mpsolve.numbers.halves import det_and_trace


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
