"""A question about ranges keeps the user's units, tells what looks wrong, and refuses what has no meaning."""

from __future__ import annotations

from fractions import Fraction

import pytest

from mpsolve import Case, InputError, Problem, tracks, vehicles
from mpsolve.report.ranges_asked import asked

TRACK = tracks.EulerBernoulli(EI="6.4e6", m=60, k="1e6", c=770)
PROBLEM = Problem(TRACK, [vehicles.Mass(9000).at(0), vehicles.Mass(9000).at("3.4")], v=20)
CASE = Case(alpha="0.5", eta_b="0.1", eta_m=10)


def test_ranges_are_exact_and_told_as_they_were_written() -> None:
    question = asked(PROBLEM, "", ["v=0..90 km/h", "gap[0]=3..4"])
    assert question.over == {"v": (0, 25), "gap[0]": (3, 4)}
    assert question.ranges == "v from 0 km/h to 90 km/h, gap[0] from 3 m to 4 m"
    assert question.si


def test_an_own_value_outside_is_a_warning_and_by_default_none() -> None:
    (warning,) = asked(PROBLEM, "", ["v=80..90 km/h"]).warnings
    assert warning.code == "value-outside-range"
    assert "v is 72 km/h" in str(warning)
    chosen = asked(PROBLEM, "", []).by_itself({"v": (Fraction(30), Fraction(40))})
    assert (chosen.warnings, chosen.ranges) == ((), "v from 108 km/h to 144 km/h")


def test_an_answer_may_speak_of_less() -> None:
    question = asked(PROBLEM, "", ["v=0..90 km/h"]).answered({"v": (Fraction(1), Fraction(20))})
    assert question.ranges == "v from 3.6 km/h to 72 km/h"
    assert question.overs[0].unit == "km/h"
    assert question.slower
    assert not asked(PROBLEM, "", ["v=3..90 km/h"]).answered({"v": (Fraction(1), Fraction(20))}).slower
    assert not asked(PROBLEM, "", ["gap[0]=0..4"]).answered({"gap[0]": (Fraction(1), Fraction(4))}).slower


def test_a_range_without_end_is_for_some_questions_only() -> None:
    assert asked(PROBLEM, "", ["scale.mass=0.."], endless=True).over == {"scale.mass": (0, None)}
    with pytest.raises(InputError, match=r"scale\.mass, which has no upper end.*scale\.mass=0\.\.10"):
        asked(PROBLEM, "", ["scale.mass=0.."])


def test_ratios_have_no_units() -> None:
    assert asked(CASE, "", ["v=0..1"]).overs[0].si == ""
    with pytest.raises(InputError, match="the paper's ratios"):
        asked(CASE, "", ["v=0..90 km/h"])
