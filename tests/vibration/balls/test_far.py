import pytest

from mpsolve import Problem, tracks, vehicles
from mpsolve.errors import PrecisionError
from mpsolve.numbers.balls import acb, precision
from mpsolve.vibration.balls.far import far_field
from mpsolve.vibration.path import Path

BEAM = tracks.EulerBernoulli(EI="0.25", m=1, k=1, c="0.1")


def test_the_bound_holds_further_out_between_line_and_path(balls):
    image = balls(Problem(BEAM, vehicles.Mass(20), v="0.5"))
    path = Path(-0.02, 3.0, 1.0)
    with precision(image.bits):
        radius, bounds = far_field(image, path, 9.0)
        for factor in (1.0, 2.0, 50.0):
            values = image.values(image.start(path.line(acb(radius * factor))))
            assert all(abs(value) < bound for value, bound in zip(values, bounds, strict=True))


def test_masses_over_a_distance_want_a_flat_path(balls):
    image = balls(Problem(BEAM, [vehicles.Mass(20).at(0), vehicles.Mass(20).at(3)], v="0.5"))
    with precision(image.bits), pytest.raises(PrecisionError):
        far_field(image, Path(-0.02, 3.0, 1.0), 9.0)


@pytest.mark.parametrize(
    ("places", "delta"), [((0, "0.5", "1.25"), 0.1), ((0, 2, "2.75"), 0.05), ((0, 1, 2, 3), 0.02)]
)
@pytest.mark.parametrize("v", ["0", "0.9", "1.3"])
def test_the_bound_holds_for_rows_of_masses(balls, places, delta, v):
    """On the line, where û is known without a path, and on it further out."""
    masses = [vehicles.Mass(m).at(x) for m, x in zip((40, 10, 40, 7), places, strict=False)]
    image = balls(Problem(BEAM, masses, v=v))
    path = Path(-0.02, 3.0, delta)
    with precision(image.bits):
        radius, bounds = far_field(image, path, 9.0)
        for factor in (1.0, 1.1, 1.3, 20.0):
            values = image.values(image.start(path.line(acb(radius * factor))))
            assert all(abs(value) < bound for value, bound in zip(values, bounds, strict=True))
