"""What reaches a cut, in scaled numbers: the known end of the gap, and what an effort that ends early leaves open."""

from __future__ import annotations

from cut_cases import family

from mpsolve import Case, Effort
from mpsolve.cuts.reached import all_reached
from mpsolve.progress import silent

PAIR = Case(alpha="0.5", eta_b=0, eta_m=(40, 40), positions=(0, "0.5"))
END = 0.7404667534244332
"""Section 4.2 of the paper, as another program had it."""


def test_the_end_of_the_gap_is_found_alone() -> None:
    found = all_reached(family(PAIR, "0.5", "0.9"), 15, Effort(evaluations=400_000), silent)
    (one,) = found.points
    assert (found.reason, found.reach) == (None, None)
    assert (one.side, one.appears) == ("gap", False)
    assert abs(one.x - END) < 1e-13
    assert one.drift.imag < 0  # the p-root leaves the sheet


def test_an_effort_that_ends_early_leaves_a_reason() -> None:
    found = all_reached(family(PAIR, "0.5", "0.9"), 15, Effort(evaluations=10), silent)
    assert found.reason is not None
