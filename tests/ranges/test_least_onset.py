"""The least onset over a second parameter: a candidate that is not the least one is never called so."""

from __future__ import annotations

from fractions import Fraction
from typing import Any

import pytest

from mpsolve import Case
from mpsolve.problem.cases import as_problem
from mpsolve.progress import silent
from mpsolve.proof.effort import Effort
from mpsolve.ranges import least_onset
from mpsolve.ranges.least_onset import Question
from mpsolve.ranges.scope import OpenError, scope_of


def question(boxes: int = 50_000) -> Question:
    problem = as_problem(Case(alpha="0.99", eta_b="0.5", eta_m=(1, 1), positions=(0, "1.1")))
    over = {"scale.mass": (Fraction(1, 2), Fraction(40)), "gap[0]": (Fraction("1.05"), Fraction("1.2"))}
    return Question(problem, over, scope_of(problem, over), 15, Effort(evaluations=boxes), silent, False)


def test_the_least_one_is_proved() -> None:
    found = question().answer()
    assert found.where == "inside"
    assert found.value is not None
    assert 1.05 < float(found.worst) < 1.2  # type: ignore[arg-type]


def test_a_crossing_that_floats_miss_leaves_it_open(monkeypatch: pytest.MonkeyPatch) -> None:
    """As if no crossing were seen, though there is one."""
    monkeypatch.setattr(Question, "_found", lambda _: None)
    with pytest.raises(OpenError):
        question().answer()


def test_a_higher_crossing_is_not_called_the_least(monkeypatch: pytest.MonkeyPatch) -> None:
    """As if it were sought beside the lowest place only: the tree finds that there are lower ones."""
    lowest = least_onset.lowest_near

    def at_the_start(curve: Any, start: Any, y: float, ends: Any, step: float) -> Any:
        return lowest(curve, start, y, (ends[0], ends[0] + (ends[1] - ends[0]) / 1024), step)

    monkeypatch.setattr(least_onset, "lowest_near", at_the_start)
    with pytest.raises(OpenError):
        question(8_000).answer()
