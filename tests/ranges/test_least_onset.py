"""The least onset over a second parameter: a candidate that is not the least one is never called so."""

from __future__ import annotations

from fractions import Fraction
from typing import Any

import pytest

from mpsolve import Case, Problem, certify, onset, tracks, vehicles
from mpsolve.problem.cases import as_problem
from mpsolve.progress import silent
from mpsolve.proof.effort import Effort
from mpsolve.ranges import least_onset
from mpsolve.ranges.least_onset import LeastOnset
from mpsolve.ranges.scope import OpenError, scope_of


def question(boxes: int = 50_000) -> LeastOnset:
    problem = as_problem(Case(alpha="0.99", eta_b="0.5", eta_m=(1, 1), positions=(0, "1.1")))
    over = {"scale.mass": (Fraction(1, 2), Fraction(40)), "gap[0]": (Fraction("1.05"), Fraction("1.2"))}
    return LeastOnset(problem, over, scope_of(problem, over), 15, Effort(evaluations=boxes), silent, False)


def test_the_least_one_is_proved() -> None:
    found = question().answer()
    assert found.where == "inside"
    assert found.value is not None
    assert 1.05 < float(found.worst) < 1.2  # type: ignore[arg-type]


def test_a_crossing_that_floats_miss_leaves_it_open(monkeypatch: pytest.MonkeyPatch) -> None:
    """As if no crossing were seen, though there is one."""
    monkeypatch.setattr(LeastOnset, "_found", lambda _: None)
    with pytest.raises(OpenError):
        question().answer()


def test_roots_are_counted_below_the_least_one(monkeypatch: pytest.MonkeyPatch) -> None:
    """As if they were counted at the greatest mass."""
    counted = LeastOnset._require_stable

    def at_the_end(self: LeastOnset, found: Any) -> None:
        counted(self, found)
        self.below = self.scope.family.box[0][1]

    monkeypatch.setattr(LeastOnset, "_require_stable", at_the_end)
    with pytest.raises(OpenError, match="counted"):
        question().answer()


def test_a_higher_crossing_is_not_called_the_least(monkeypatch: pytest.MonkeyPatch) -> None:
    """As if it were sought beside the lowest place only: the tree finds that there are lower ones."""
    lowest = least_onset.lowest_near

    def at_the_start(curve: Any, start: Any, y: float, ends: Any, step: float) -> Any:
        return lowest(curve, start, y, (ends[0], ends[0] + (ends[1] - ends[0]) / 1024), step)

    monkeypatch.setattr(least_onset, "lowest_near", at_the_start)
    with pytest.raises(OpenError):
        question(8_000).answer()


def at_100(mass: tuple[str, str], gap: tuple[str, str]) -> LeastOnset:
    """Two masses of 10 t on a rail at 100 m/s: unstable beyond 2.22 times the mass, 4.85 m apart."""
    rail = tracks.EulerBernoulli(EI="6.4e6", m=60, k="1e6", c=770)
    problem = Problem(rail, vehicles.train(vehicles.Mass("10e3"), 2, "3.4"), v=100)
    over = {path: (Fraction(a), Fraction(b)) for path, (a, b) in (("scale.mass", mass), ("gap[0]", gap))}
    return LeastOnset(problem, over, scope_of(problem, over), 15, Effort(evaluations=50_000), silent, False)


@pytest.mark.parametrize("gap", [("1", "5"), ("4", "5"), ("4", "6")])
def test_a_narrow_valley_in_a_wide_range_is_found(gap: tuple[str, str]) -> None:
    """Between two of the first columns; Newton's method from the end of the range jumps to another crossing."""
    found = at_100(("0.1", "100"), gap).answer()
    assert found.where == "inside"
    assert found.value is not None
    assert abs(float(found.value) - 2.22252174133877) < 1e-12
    for beside in ("-1e-4", "1e-4"):  # an onset at a gap beside it is larger
        problem = at_100(("0.1", "100"), gap).problem.changed("gap[0]", str(float(found.worst) + float(beside)))
        alone = onset(problem, over={"scale.mass": ("0.1", 100)}, check=False)
        assert alone.value > found.value


def test_roots_that_grow_from_the_start_on_are_an_answer() -> None:
    """At ten times the mass some distances are unstable at once: one of them is certified and told."""
    question = at_100(("10", "100"), ("1", "5"))
    question.budget = Effort(evaluations=500)
    found = question.answer()
    assert found.value is None
    assert found.worst is not None
    there = question.problem.changed("scale.mass", 10).changed("gap[0]", str(float(found.worst)))
    assert certify(there, region="unstable").unstable == 2
