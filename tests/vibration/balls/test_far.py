import numpy as np
import pytest

from mpsolve import Problem, tracks, vehicles
from mpsolve.errors import PrecisionError
from mpsolve.numbers.balls import acb, arb, precision
from mpsolve.vibration.balls.far import far_field
from mpsolve.vibration.balls.polygon import far_roots
from mpsolve.vibration.path import Path

BEAM = tracks.EulerBernoulli(EI="0.25", m=1, k=1, c="0.1")


def test_the_bound_holds_further_out_between_line_and_path(balls):
    image = balls(Problem(BEAM, vehicles.Mass(20), v="0.5"))
    path = Path(-0.02, 3.0, 1.0)
    with precision(image.bits):
        radius, bounds = far_field(image, path, 9.0)
        for factor in (1.0, 2.0, 50.0):
            values = image.values(image.start(path.line(acb(radius * factor))))
            assert all(abs(value) < bound.size for value, bound in zip(values, bounds, strict=True))


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
            assert all(abs(value) < bound.size for value, bound in zip(values, bounds, strict=True))


def test_the_bound_at_places_that_waves_reach_late_holds_on_the_path(balls):
    """û by float64, whose two p-roots are followed to the left by their leading terms."""
    problem = Problem(tracks.String(T=2, m=1, k=1, c="0.2"), vehicles.Mass(3), v="0.5")
    image, path = balls(problem, ["1", "-2"]), Path(0.3, 3.0, 0.5)
    guide, (x, y) = image.image.guide, image.seen
    with precision(image.bits):
        radius, bounds = far_field(image, path, 9.0)
        starts = [complex(root.z0).real for root in far_roots(guide.D, guide.N, guide.v, arb(radius))]
    assert [float(bound.delay) > 0.5 for bound in bounds] == [False, False, True, True]
    for r in radius**0.5 * np.array([1.01, 1.4, 2.5]):
        sigma, rows = complex(path.lifted(r)), np.zeros((3, 2), complex)
        for k, polynomial in enumerate((guide.D, guide.N)):
            for (i, j), c in polynomial.items():
                rows[i, k] += float(c) * sigma**j
        roots = np.roots(rows[::-1, 0])
        ahead, behind = (roots[np.argmin(abs(roots - z0 * sigma))] for z0 in sorted(starts))
        G = [
            float(guide.g) * sign * rows[0, 1] / np.polyval(np.polyder(rows[::-1, 0]), P) * np.exp(P * float(xi))
            for sign, P, xi in ((1, ahead, 0), (1, ahead, x), (-1, behind, y))
        ]
        push = 3 * 9.80665 / sigma
        force = push / (1 + 3 * (sigma * image.image.rate) ** 2 * G[0])
        values = [G[0] * force, force, G[1] * force, G[2] * force]
        limits = [float(one.size) * np.exp(float(one.delay) * path.delta * (r - path.start)) for one in bounds]
        assert all(abs(value) <= limit for value, limit in zip(values, limits, strict=True))
        assert abs(values[3]) > 1e-3 * limits[3]
