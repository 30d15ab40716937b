import numpy as np
import pytest

from mpsolve.errors import PrecisionError
from mpsolve.numbers.balls import acb, arb, precision
from mpsolve.vibration.balls.solved import entries, solved


def test_a_matrix_that_may_be_singular_is_refused():
    zero = arb(0)
    good = [[(acb(2), arb(0.5)), (acb(0), arb(1))], [(acb(0), arb(1)), (acb(2), zero)]]
    with precision(100):
        bounds = solved(good, [arb(1), arb(1)])
        assert all(bound >= 1 for bound in bounds)  # |x| = 1 at A = [[2, −1], [−1, 2]]
        with pytest.raises(PrecisionError, match="singular"):
            solved([[(acb(1), zero), (acb(0), arb(1))], [(acb(0), arb(1)), (acb(1), zero)]], [arb(1), arb(1)])


RNG = np.random.default_rng(3)


def scattering(alpha, beta, grown):
    """N_ij = α_i p_i/p_j ahead, β_i r_j/r_i behind: p, r the waves, which grow together by `grown` over each gap."""
    n = len(alpha)
    turn = np.exp(2j * np.pi * RNG.random((2, n - 1)))
    steps = [np.sqrt(grown) * one for one in turn]
    N = np.zeros((n, n), complex)
    for i in range(n):
        for j in range(n):
            low, high = sorted((i, j))
            N[i, j] = (alpha[i] * np.prod(steps[0][low:high])) if i > j else beta[i] * np.prod(steps[1][low:high])
    return N - np.diag(np.diag(N)) + np.eye(n)


@pytest.mark.parametrize("n", [2, 3, 4, 6])
def test_every_entry_is_below_the_bound(n):
    alpha, beta = np.full(n, (1 - 1j) / 2), np.full(n, (1.02 - 0.97j) / 2)
    grown = 1.01
    with precision(80):
        balls = [[acb(complex(x)) for x in row] for row in (alpha, beta)]
        largest = arb(0.72 * grown ** (n / 2))
        bound = float(entries(*balls, [arb(grown)] * (n - 1), largest).upper())
    worst = max(np.abs(np.linalg.inv(scattering(alpha, beta, grown))).max() for _ in range(4000))
    assert worst < bound < 1e4 * worst


def test_waves_that_grow_too_far_are_refused():
    with precision(80), pytest.raises(PrecisionError, match="reflect"):
        entries([acb(0.5, 0.5)] * 3, [acb(0.5, 0.5)] * 3, [arb(2)] * 2, arb(1))
