"""Each theorem tells in its own ranges, and none elsewhere."""

from __future__ import annotations

from fractions import Fraction

import pytest
from free_cases import PAIR

from mpsolve import InputError, Problem, onset, prove_stable, tracks
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


@pytest.mark.parametrize(
    ("problem", "path", "ends"),
    [
        (WIRE, "track.k", (-5000, 500)), (WIRE, "scale.mass", (-1, 2)), (WIRE, "v", (-50, 50)),
        (BEAM, "vehicles[0].M", (-5, 50)), (BEAM, "gap[0]", (-1, 1)), (BEAM, "v", (-0.5, 0.5)),
    ],
)  # fmt: skip
def test_no_theorem_tells_of_values_that_cannot_be(problem: Exact, path: str, ends: tuple[float, float]) -> None:
    """A foundation with a negative stiffness buckles, whatever runs there."""
    with pytest.raises(InputError) as caught:
        prove_stable(problem, over={path: ends})
    assert caught.value.key == path


@pytest.mark.parametrize("problem", [BEAM, WIRE])
def test_velocities_without_an_end_are_refused(problem: Exact) -> None:
    with pytest.raises(InputError):
        onset(problem, over={"v": (0, None)})
