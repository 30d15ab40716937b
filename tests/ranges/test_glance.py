"""Float counts by passivity agree with proved ones."""

import numpy as np
import pytest
from free_cases import BEAM, BOGIE, PAIR, RAIL

from mpsolve import Problem, certify
from mpsolve.problem.reduced import reduce_problem
from mpsolve.ranges.glance import corners_and_more, count_seen


@pytest.mark.parametrize("v", ["0.5", "0.75", "0.9", "1.1"])
def test_of_the_pair(v: str) -> None:
    problem = Problem(BEAM, PAIR, v=v)
    assert count_seen(reduce_problem(problem), 20.0) == certify(problem, region="unstable", check=False).unstable


@pytest.mark.parametrize("v", [100, 350])
def test_of_a_bogie(v: int) -> None:
    problem = Problem(RAIL, BOGIE, v=v)
    assert count_seen(reduce_problem(problem), 20.0) == certify(problem, region="unstable", check=False).unstable


def test_points_lie_in_their_box() -> None:
    points = corners_and_more((np.array([0.0, 1.0]), np.array([1.0, 3.0])))
    assert len(points) == 16
    assert all(0 <= x <= 1 <= y <= 3 for x, y in points)
