import pytest

from mpsolve import Problem, tracks, vehicles
from mpsolve.errors import EffortError
from mpsolve.numbers.balls import acb, arb, precision
from mpsolve.proof.effort import Effort
from mpsolve.vibration.balls.work import leftmost, prove_strip
from mpsolve.vibration.path import Path

BEAM = tracks.EulerBernoulli(EI="0.25", m=1, k=1, c="0.1")

ONE = Problem(BEAM, vehicles.Mass(20), v="0.5")


def test_the_path_leaves_the_line_where_they_meet():
    path = Path(-0.25, 2.0, 0.5)
    assert path.lifted(acb(2)) == path.line(acb(4))
    assert complex(path.lifted(acb(3))) == pytest.approx(-0.75 + 9j)
    assert leftmost(path, 9.0) <= -0.75


def test_the_strip_of_one_mass_is_proved(balls):
    image = balls(ONE)
    with precision(image.bits):
        assert prove_strip(image, Path(-0.02, 2.0, 1.0), 100.0, Effort()) > 10
        with pytest.raises(EffortError):
            prove_strip(image, Path(-0.02, 2.0, 1.0), 100.0, Effort(evaluations=3))


def test_the_left_end_is_a_bound_at_every_height() -> None:
    """Below the corner the path is the line itself; above it no float is rounded to the wrong side."""
    for alpha, start, delta in ((0.1, 1.1, 0.3), (1e6, 0.7, 1e-3)):
        path = Path(alpha, start, delta)
        assert leftmost(path, start**2 / 2) <= alpha
        for omega in (1.3, 7.7, 123.4):
            left = leftmost(path, omega)
            with precision(200):
                truth = path.lifted(acb(arb(omega).sqrt())).real
                assert arb(left) <= truth
            assert left > float(truth) - 1e-14 * (1 + abs(alpha))
