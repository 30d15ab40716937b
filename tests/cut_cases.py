"""The family that tests of cut points share."""

from mpsolve import Case
from mpsolve.problem.cases import as_problem
from mpsolve.problem.family import Family, family_of
from mpsolve.ranges.scope import checked_over

CASE = Case(alpha="0.9", eta_b="0.05", eta_m=(70, 40), positions=(0, "1.5"))


def family(case: Case = CASE, low: str = "0.5", high: str = "1.3") -> Family:
    """Over the velocity ratio; its scales are 1."""
    problem = as_problem(case)
    return family_of(problem, checked_over(problem, {"v": (low, high)}))
