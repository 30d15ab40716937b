"""The part of a range that an onset needs, and onsets of ranges whose rest stays open."""

from __future__ import annotations

from fractions import Fraction
from typing import Any

import pytest

from mpsolve import Case, Effort, onset
from mpsolve.numbers.balls import arb
from mpsolve.outcome import Reason, Status
from mpsolve.problem.cases import as_problem
from mpsolve.ranges.crossings import Crossing, Crossings
from mpsolve.ranges.first import quarter, up_to_first
from mpsolve.ranges.onset import Kind

CASE = Case(alpha="0.5", eta_b="0.0001", eta_m=(70, 70), positions=(0, "1.5"))
OPEN = Reason("effort", "it is spent", {}, "")


def found(*at: float, high: Any = 2, **more: Any) -> Crossings:
    over = {"v": (Fraction(0), None if high is None else Fraction(high))}
    each = tuple(Crossing(arb(x), arb(1), 2) for x in at)
    return Crossings(as_problem(CASE), over, Status.UNDECIDED, OPEN, crossings=each, **more)  # type: ignore[arg-type]


def test_up_to_a_little_beyond_the_first() -> None:
    ((low, high),) = up_to_first(found(0.5, 1.0)).values()  # type: ignore[union-attr]
    assert low == 0
    assert 0.5 < high < 0.57
    assert 0.5 < up_to_first(found(0.5))["v"][1] < 0.7  # type: ignore[index]


@pytest.mark.parametrize(
    "one", [found(), found(0.5, high=None), found(2.0), found(0.5, counts=(0, 2)), found(0.5, parts=(found(),))]
)
def test_where_there_is_nothing_to_try(one: Crossings) -> None:
    assert up_to_first(one) is None


def test_a_share_of_the_effort() -> None:
    assert quarter(None) is None
    assert quarter(Effort(seconds=8, evaluations=100)) == Effort(seconds=2, evaluations=25)
    assert quarter(Effort(evaluations=1)) == Effort(evaluations=1)


@pytest.mark.slow
def test_an_onset_of_hardly_any_damping() -> None:
    """Faster than its waves the beam is open after any number of boxes, which the onset does not ask."""
    answer = onset(CASE, over={"alpha": (0, 2)}, check=False)
    assert (answer.proved, answer.kind) == (True, Kind.CROSSES), answer.reason
    assert float(answer.value) == pytest.approx(0.670339465413233, rel=1e-14)
    assert "nothing is said of larger values" in answer.note
