"""Models of the matrix along the cut hold what balls say at points of their boxes."""

import numpy as np
import pytest
from cut_cases import family

from mpsolve.characteristic.bordering import Bordering
from mpsolve.characteristic.boxes import Boxes
from mpsolve.cuts import boxes
from mpsolve.cuts.balls import EdgeBalls, filled
from mpsolve.cuts.boxes import EdgeMatrix
from mpsolve.cuts.entries import of_one, of_two
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
    seen = set()
    with precision(80):
        for k in np.flatnonzero(found.good):
            u = rng.uniform(-1, 1, 2)
            p, x = middle[:, k] + half[:, k] * u
            try:
                parts = balls.parts(arb(p), arb(x))
            except PrecisionError:
                continue
            powers = np.array([1, u[0], u[1], u[0] ** 2, u[0] * u[1], u[1] ** 2])
            model = np.einsum("k,kij->ij", powers, A.k[:, k])
            two = not (model[3, 3] == 1 and not model[3, :3].any())
            seen.add((two, bool(parts.a2.value.real.contains(0))))
            border = Bordering.of(family(), waves=1 + two)
            rows = filled(border, parts.sigma, arb(x), (of_two if two else of_one)(parts))
            exact = np.array([[complex(x.value) for x in row] for row in rows])
            n = len(exact)
            assert (np.abs(model[:n, :n] - exact) <= A.e[k, :n, :n] + 1e-13 * np.abs(exact)).all()
    assert seen == {(False, False), (True, False), (True, True)}  # with waves that do and do not decay
