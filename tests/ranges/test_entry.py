"""An entry is the answer to its question, rounded; what is not decided says why."""

from __future__ import annotations

from fractions import Fraction

import pytest

from mpsolve import Case
from mpsolve.problem.cases import as_problem
from mpsolve.problem.over import Over
from mpsolve.ranges.entry import Job, solve

TWO = as_problem(Case(alpha="0.5", eta_b="0.05", eta_m=(70, 70), positions=(0, "1.5")))


@pytest.mark.parametrize(
    ("ends", "seconds", "status", "text"),
    [((0, "0.9"), None, "proved", "0.66691896"), ((0, "0.6"), None, "stable", "stable"),
     (("0.7", "0.8"), None, "unstable", "unstable"), ((0, "0.6"), 1e-9, "undecided", "undecided")],
)  # fmt: skip
def test_each_kind(ends: tuple[str, str], seconds: float | None, status: str, text: str) -> None:
    over = Over("v", Fraction(ends[0]), Fraction(ends[1]), "", "")
    found = solve(Job(TWO, "onset", over, 8, seconds))
    assert (found.status, found.text) == (status, text)
    assert (found.reason is not None) == (status == "undecided")
    assert len(found.balls) == (status == "proved")


def test_digits_to_which_a_number_is_proved() -> None:
    over = Over("v", Fraction(0), Fraction(1), "", "")
    assert [Job(TWO, "onset", over, n, None).proved_digits for n in (1, 10, 30)] == [15, 15, 35]
