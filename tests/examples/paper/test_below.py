"""One unstable root followed: against certified roots on the way, and not where it comes to the axis."""

from fractions import Fraction

import pytest

from mpsolve import Case, certify
from mpsolve.problem.cases import as_problem
from mpsolve.proof.effort import Effort
from paper.below import stays_below


def unstable(case: Case) -> list[object]:
    return [root.q for root in certify(case, digits=15, check=False).roots if root.q.imag < 0 < root.q.real]


def case(alpha: str, eta_b: str) -> Case:
    return Case(alpha=alpha, eta_b=eta_b, eta_m=(10, 10), positions=(0, "4.5"))


@pytest.mark.parametrize("eta_b", ["0", "0.01"])
def test_a_root_next_to_the_axis_is_followed(eta_b: str) -> None:
    start = case("1.2", eta_b)
    (q,) = unstable(start)
    assert stays_below(as_problem(start), {"v": (Fraction("1.2"), Fraction("1.4"))}, q)
    for alpha in ("1.25", "1.4"):
        assert unstable(case(alpha, eta_b))


def test_a_root_that_crosses_the_axis_is_not() -> None:
    start = Case(alpha="0.8", eta_b="0.05", eta_m=(50, 50), positions=(0, "1.5"))
    (q,) = unstable(start)  # it leaves at 0.886
    assert stays_below(as_problem(start), {"v": (Fraction("0.8"), Fraction("0.885"))}, q)
    assert not stays_below(as_problem(start), {"v": (Fraction("0.8"), Fraction("0.89"))}, q)


def test_little_effort_proves_nothing() -> None:
    start = case("1.2", "0")
    (q,) = unstable(start)
    over = {"v": (Fraction("1.2"), Fraction("1.4"))}
    assert not stays_below(as_problem(start), over, q, Effort(evaluations=20))
