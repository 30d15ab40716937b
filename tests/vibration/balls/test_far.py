import pytest

from mpsolve import Problem, tracks, vehicles
from mpsolve.errors import PrecisionError
from mpsolve.numbers.balls import acb, arb, precision
from mpsolve.vibration.balls.far import far_field, solved
from mpsolve.vibration.balls.path import Path

BEAM = tracks.EulerBernoulli(EI="0.25", m=1, k=1, c="0.1")


def test_the_bound_holds_further_out_between_line_and_path(balls):
    image = balls(Problem(BEAM, vehicles.Mass(20), v="0.5"))
    path = Path(-0.02, 3.0, 1.0)
    with precision(image.bits):
        radius, bounds = far_field(image, path, 9.0)
        for factor in (1.0, 2.0, 50.0):
            values = image.values(image.start(path.line(arb(radius * factor))))
            assert all(abs(value) < bound for value, bound in zip(values, bounds, strict=True))


def test_a_matrix_that_may_be_singular_is_refused():
    zero = arb(0)
    good = [[(acb(2), arb(0.5)), (acb(0), arb(1))], [(acb(0), arb(1)), (acb(2), zero)]]
    with precision(100):
        bounds = solved(good, [arb(1), arb(1)])
        assert all(bound >= 1 for bound in bounds)  # |x| = 1 at A = [[2, −1], [−1, 2]]
        with pytest.raises(PrecisionError, match="singular"):
            solved([[(acb(1), zero), (acb(0), arb(1))], [(acb(0), arb(1)), (acb(1), zero)]], [arb(1), arb(1)])


def test_masses_over_a_distance_want_a_flat_path(balls):
    image = balls(Problem(BEAM, [vehicles.Mass(20).at(0), vehicles.Mass(20).at(3)], v="0.5"))
    with precision(image.bits), pytest.raises(PrecisionError):
        far_field(image, Path(-0.02, 3.0, 1.0), 9.0)
