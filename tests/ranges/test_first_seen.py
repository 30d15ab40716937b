"""The first crossing as floats see it, against the onsets of certified answers."""

from __future__ import annotations

from fractions import Fraction
from typing import Any

import pytest

from mpsolve import Case
from mpsolve.problem.cases import as_problem
from mpsolve.problem.family import family_of
from mpsolve.ranges.first_seen import first_seen


@pytest.mark.parametrize(
    ("masses", "places", "q", "v"),
    [((70, 70), (0, "1.5"), 0.15620777798806, 0.66691895728455),
     ((50,), (0,), 0.16433862942823, 1.09029890169583),
     ((3, 3), (0, 2), 0.87360051044724, 1.39803362800436)],
)  # fmt: skip
def test_the_least_value(masses: Any, places: Any, q: float, v: float) -> None:
    problem = as_problem(Case(alpha="0.5", eta_b="0.05", eta_m=masses, positions=places))
    family = family_of(problem, {"v": (Fraction(0), Fraction(2))})
    seen = first_seen(family)
    assert seen is not None
    assert seen[0] * float(family.frequency_unit) == pytest.approx(q, rel=1e-4)
    assert seen[1] * float(family.units[0]) == pytest.approx(v, rel=1e-4)


def test_nothing_where_nothing_crosses() -> None:
    problem = as_problem(Case(alpha="0.5", eta_b="0.05", eta_m=70))
    assert first_seen(family_of(problem, {"v": (Fraction(0), Fraction("0.9"))})) is None
