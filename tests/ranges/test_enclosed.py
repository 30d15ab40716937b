"""A crossing in a ball: as sharp as asked, alone, and in the direction in which the certified count changes."""

from __future__ import annotations

from fractions import Fraction

import numpy as np
import pytest
from free_cases import BOGIE, RAIL
from ranges_of_a_pair import PAIR, over_velocity

from mpsolve import Problem, certify
from mpsolve.errors import PrecisionError
from mpsolve.numbers.balls import arb, precision
from mpsolve.progress import silent
from mpsolve.proof.effort import Effort
from mpsolve.ranges.enclosed import REAL_AXIS, Crossing, Edge, enclose
from mpsolve.ranges.scope import scope_of
from mpsolve.ranges.search import Search

SEED, SIZE = (0.2, 0.35), (1e-4, 1e-4)


@pytest.fixture(scope="module")
def seed() -> tuple[float, float]:
    """Near the crossing: by halving with certified counts, and the real part of the root there."""
    scope = over_velocity()
    low, high = 150.0, 230.0
    for _ in range(20):
        v = (low + high) / 2
        unstable = certify(PAIR.changed("v", v), region="unstable", digits=15, check=False).unstable
        low, high = (low, v) if unstable else (v, high)
    roots = certify(PAIR.changed("v", high), region="unstable", check=False).roots
    q = abs(float(roots[0].q.real)) / float(scope.family.frequency_unit)
    return q, high / float(scope.family.units[0])


def found(seed: tuple[float, float], digits: int) -> Crossing:
    return enclose(over_velocity().proved, seed, SIZE, digits)


def test_more_digits_lie_inside_fewer(seed: tuple[float, float]) -> None:
    short, long = found(seed, 15), found(seed, 60)
    with precision(300):
        assert long.x.rad() < abs(long.x) * arb(10) ** -60
        assert short.x.contains(long.x)
        assert short.q.contains(long.q)
    assert abs(float(long.x) - seed[1]) < 1e-4


def test_the_direction_is_that_of_the_counts(seed: tuple[float, float]) -> None:
    one = found(seed, 15)
    v = float(one.x) * float(over_velocity().family.units[0])
    counts = [certify(PAIR.changed("v", v + d), region="unstable", check=False).unstable for d in (-1e-3, 1e-3)]
    assert counts == [0, one.gained]


def test_where_no_root_crosses_none_is_enclosed(seed: tuple[float, float]) -> None:
    q, x = seed
    with pytest.raises(PrecisionError):
        enclose(over_velocity().proved, (2 * q, x), SIZE, 15)


def test_points_are_the_same_in_floats_and_balls() -> None:
    for edge in (REAL_AXIS, Edge(im=Fraction(1, 4)), Edge(re=Fraction(2), down=True)):
        for y in (0.0, -0.25, 1.5):
            q = complex(float(edge.re), float(edge.im)) + (-1j * y if edge.down else y)
            assert complex(edge.sigma(arb(y))) == edge.origin + edge.way * y == 1j * q
    assert REAL_AXIS.mirrored
    assert not Edge(re=Fraction(2), down=True).mirrored


def test_an_imaginary_root_is_found_where_it_crosses_an_edge() -> None:
    """A bogie with an overdamped suspension: one imaginary root comes down to Im q = 6 near c2 = 517,000."""
    problem = Problem(RAIL, [BOGIE.at(0)], v=100)
    path = "vehicles[0].c2"
    scope = scope_of(problem, {path: (Fraction(500_000), Fraction(530_000))})
    edge = Edge(im=Fraction(6) / scope.family.frequency_unit)
    low, high = np.array([0.0, scope.low[0]]), np.array([0.5, scope.high[0]])
    search = Search(scope, 15, (edge, low, high))
    cover = search.cover(Effort(), silent)
    assert cover.reason is None
    (one,) = search.found
    assert one.q == 0
    assert one.gained == 1
    value = float(one.x) * float(scope.family.units[0])
    for share, count in ((0.999, 0), (1.001, 1)):
        roots = certify(problem.changed(path, Fraction(value * share)), region=("below", 6), check=False).roots
        assert sum(bool(root.q.real.is_zero()) for root in roots) == count
