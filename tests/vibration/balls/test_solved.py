import pytest

from mpsolve.errors import PrecisionError
from mpsolve.numbers.balls import acb, arb, precision
from mpsolve.vibration.balls.solved import solved


def test_a_matrix_that_may_be_singular_is_refused():
    zero = arb(0)
    good = [[(acb(2), arb(0.5)), (acb(0), arb(1))], [(acb(0), arb(1)), (acb(2), zero)]]
    with precision(100):
        bounds = solved(good, [arb(1), arb(1)])
        assert all(bound >= 1 for bound in bounds)  # |x| = 1 at A = [[2, −1], [−1, 2]]
        with pytest.raises(PrecisionError, match="singular"):
            solved([[(acb(1), zero), (acb(0), arb(1))], [(acb(0), arb(1)), (acb(1), zero)]], [arb(1), arb(1)])
