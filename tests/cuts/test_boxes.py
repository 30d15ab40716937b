"""Models of the matrix along the cut hold what balls say at points of their boxes."""

import numpy as np
import pytest
from cut_cases import family

from mpsolve.characteristic.boxes import Boxes
from mpsolve.cuts import boxes
from mpsolve.cuts.balls import EdgeBalls
from mpsolve.cuts.boxes import EdgeMatrix, _quotient
from mpsolve.errors import PrecisionError
from mpsolve.numbers.balls import arb, precision


@pytest.mark.parametrize("side", [-1, 1])
def test_models_hold_the_balls(side: int, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(boxes, "_scale", lambda _: 1.0)  # the factors of rows and columns
    rng = np.random.default_rng(2)
    n = 150
    middle = np.stack([rng.uniform(-6, 6, n), rng.uniform(0.5, 1.3, n)])
    half = 2.0 ** -rng.integers(3, 13, (2, n))
    matrix, balls = EdgeMatrix(family(), side), EdgeBalls(family(), side)
    A, found = matrix(Boxes(middle, half, 0.0, 1.0))
    assert found.good.mean() > 0.8
    with precision(80):
        for k in np.flatnonzero(found.good):
            u = rng.uniform(-1, 1, 2)
            p, x = middle[:, k] + half[:, k] * u
            try:
                truth = balls.matrices(arb(p), arb(x))[0]
            except PrecisionError:
                continue
            powers = np.array([1, u[0], u[1], u[0] ** 2, u[0] * u[1], u[1] ** 2])
            model = np.einsum("k,kij->ij", powers, A.k[:, k])
            exact = np.array([[complex(truth[i, j]) for j in range(5)] for i in range(5)])
            assert (np.abs(model - exact) <= A.e[k] + 1e-13 * np.abs(exact)).all()


def test_the_quotient_has_its_slopes() -> None:
    w = np.array([0.0, 1e-9, 0.999, 1.001j, -3 + 2j])
    E, E1, E2 = _quotient(w)
    t = (np.arange(20000) + 0.5) / 20000
    for k, found in enumerate((E, E1, E2)):
        assert np.allclose(found, (t**k * np.exp(np.outer(w, t))).mean(1), atol=1e-8)
