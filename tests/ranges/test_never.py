"""Each theorem tells in its own ranges, and none elsewhere."""

from __future__ import annotations

from fractions import Fraction

import pytest
from free_cases import PAIR

from mpsolve import Problem, tracks
from mpsolve.problem.problem import Problem as Exact
from mpsolve.ranges import on_string, undamped
from mpsolve.ranges.never import never_unstable

BEAM = Problem(tracks.EulerBernoulli(EI="1/4", m=1, k=1), PAIR, v="0.5")
WIRE = Problem(tracks.String(T=27000, m="1.07", k=500, c=2), PAIR[:1], v=100)


@pytest.mark.parametrize(
    ("problem", "high", "why"),
    [(BEAM, 1, undamped.NOTE), (BEAM, 2, None), (WIRE, 150, on_string.SLOWER), (WIRE, 170, None)],
)
def test_which_theorem_tells(problem: Exact, high: int, why: str | None) -> None:
    assert never_unstable(problem, {"v": (Fraction(0), Fraction(high))}) == why
