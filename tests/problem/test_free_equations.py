from fractions import Fraction

from free_cases import BOGIE, LAYERS, pair_over_velocity

from mpsolve import Problem
from mpsolve.problem.family import family_of
from mpsolve.problem.free_equations import free_equations


def test_they_are_the_problem_s_own_at_every_point() -> None:
    """Track, velocity and pencil of a bogie on two layers, with parameters of each kind free."""
    over = {
        "v": (Fraction(1), Fraction(100)),
        "track.k_ballast": (Fraction(50_000_000), Fraction(150_000_000)),
        "vehicles[0].wheel": (Fraction(1000), Fraction(2000)),
    }
    family = family_of(Problem(LAYERS, BOGIE, v=50), over)
    free = free_equations(family)
    x = (Fraction(70), Fraction(123_000_000), Fraction(1100))
    problem = family.at([value / unit for value, unit in zip(x, family.units, strict=True)])
    assert free.v.at(x) == problem.v == 70
    for row, own in zip(free.matrix, problem.track.waveguide.matrix, strict=True):
        for entry, other in zip(row, own, strict=True):
            assert {key: c.at(x) for key, c in entry.items() if c.at(x)} == other
    for name in "MCKB":
        rows = [[c.at(x) for c in row] for row in free.several(getattr(free.pencil, name))]
        assert rows == [list(row) for row in getattr(problem.pencil, name)]


def test_a_velocity_alone() -> None:
    free = free_equations(pair_over_velocity())
    assert free.ring.names == ("v",)
    assert free.v.at((Fraction(3),)) == 3
