"""Edges: points of a side of a region as σ̂, in floats and in balls, and zeros that are sought along them."""

from fractions import Fraction

import numpy as np
from free_cases import BOGIE, RAIL

from mpsolve import Problem, certify
from mpsolve.numbers.balls import arb
from mpsolve.progress import silent
from mpsolve.proof.effort import Effort
from mpsolve.ranges.edge import REAL_AXIS, Edge
from mpsolve.ranges.scope import scope_of
from mpsolve.ranges.search import Search


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
