"""Onsets of a line against those of single questions and against certified counts; false guesses are no onsets."""

from __future__ import annotations

from fractions import Fraction
from typing import Any

import numpy as np
import pytest
from ranges_of_a_pair import PAIR

from mpsolve import Case, certify, onset
from mpsolve.problem.cases import as_problem
from mpsolve.ranges import onset_line
from mpsolve.ranges.onset_line import onsets_along

TWO = as_problem(Case(alpha="0.5", eta_b="0.05", eta_m=(70, 70), positions=(0, 2)))
OVER = {"v": (Fraction(0), Fraction(2))}
MASSES = [Fraction(n) for n in (76, 67)]
"""Between 67 and 76 another crossing becomes the first."""


def test_they_are_those_of_single_questions() -> None:
    found = onsets_along(TWO, OVER, "eta_m", MASSES, 20)
    for mass, one in zip(MASSES, found, strict=True):
        assert one is not None
        alone = onset(TWO.changed("eta_m", mass), over=OVER, digits=20, check=False)
        assert one.value.overlaps(alone.value)
        assert one.q.overlaps(alone.q)
        assert float(one.value.rad()) < 1e-19
    values = [float(one.value) for one in found if one is not None]
    assert values[0] < 0.6
    assert values[1] > 1


def test_certified_counts_on_both_sides() -> None:
    found = onsets_along(
        PAIR, {"v": (Fraction(100), Fraction(260))}, "scale.mass", [Fraction(1), Fraction("1.4")], 15
    )
    for scale, one in zip((Fraction(1), Fraction("1.4")), found, strict=True):
        assert one is not None
        problem, value = PAIR.changed("scale.mass", scale), Fraction(float(one.value))
        beside = [problem.changed("v", value * x) for x in (Fraction("0.99"), Fraction("1.01"))]
        assert [certify(one, region="unstable", check=False).unstable for one in beside] == [0, 2]


@pytest.mark.parametrize(
    ("number", "at"),
    [(2, (0.1226, 1.0386)), (2, (0.5, 0.3)), (0, (0.3, 0.9))],
    ids=["the second one", "none", "none, too"],
)
def test_what_floats_see_decides_nothing(number: int, at: Any, monkeypatch: pytest.MonkeyPatch) -> None:
    """A crossing that is not the first one is not told; what else is told is true."""
    seen, masses = onset_line.each_seen, [Fraction(n) for n in (60, 67, 76)]
    truth = [1.04746, 1.04267, 0.49538]

    def false(family: Any, values: Any) -> Any:
        out = seen(family, values)
        out[:, number] = np.array([at[0] / float(family.frequency_unit), at[1] / float(family.units[0])])
        return out

    monkeypatch.setattr(onset_line, "each_seen", false)
    found = onsets_along(TWO, OVER, "eta_m", masses, 15)
    assert sum(one is not None for one in found) >= 2
    for n, one in enumerate(found):
        assert one is None or float(one.value) == pytest.approx(truth[n], abs=1e-4)


@pytest.mark.parametrize(("number", "at"), [(0, (0.5924, 0.7196)), (1, (0.02241, 0.87166)), (1, (0.849, 0.4286))])
def test_a_crossing_beyond_what_is_covered_is_no_onset(number: int, at: Any, monkeypatch: pytest.MonkeyPatch) -> None:
    """From these points Newton's method leads to crossings past the end of the family, behind the first ones."""
    masses = [Fraction(60), Fraction(67)]

    def false(family: Any, values: Any) -> Any:
        out = np.full((2, len(values)), np.nan)
        out[:, number] = np.array([at[0] / float(family.frequency_unit), at[1] / float(family.units[0])])
        return out

    monkeypatch.setattr(onset_line, "each_seen", false)
    assert onsets_along(TWO, OVER, "eta_m", masses, 15) == [None, None]


def test_where_roots_grow_from_the_start_nothing_is_told() -> None:
    found = onsets_along(TWO, {"v": (Fraction("1.1"), Fraction(2))}, "eta_m", MASSES, 15)
    assert found == [None] * 2


def test_what_is_no_line() -> None:
    assert onsets_along(TWO, OVER, "eta_m", MASSES[:1], 15) == [None]
    assert onsets_along(TWO, OVER, "gap[0]", [Fraction(-1), Fraction(1)], 15) == [None, None]


def test_a_factor_over_masses_that_are_given() -> None:
    """Over a factor of the masses, along the masses: their product is the limiting mass at each value."""
    case = as_problem(Case(alpha="0.9", eta_b="0.05", eta_m=(1, 1), positions=(0, "1.5")))
    found = onsets_along(
        case, {"scale.mass": (Fraction(1, 2), Fraction(4))}, "eta_m", [Fraction(20), Fraction(30)], 15
    )
    products = [mass * float(one.value) for mass, one in zip((20, 30), found, strict=True) if one is not None]
    assert products == pytest.approx([52.871940796831055] * 2, rel=1e-12)
    grown = onsets_along(
        case, {"scale.mass": (Fraction(1, 2), Fraction(4))}, "eta_m", [Fraction(20), Fraction(120)], 15
    )
    assert grown == [None, None]  # 120 is unstable from the start of the range on
