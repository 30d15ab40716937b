"""Lines from starts and passings: a ball that no tube holds, and one that is no root, are followed nowhere."""

from __future__ import annotations

from dataclasses import replace
from fractions import Fraction
from functools import cache

import pytest
from free_cases import BEAM, PAIR

from mpsolve import Problem, certify
from mpsolve.loci.grow import Start, strands
from mpsolve.loci.region import Region, region_of
from mpsolve.proof.effort import Effort
from mpsolve.ranges.scope import scope_of

PROBLEM = Problem(BEAM, PAIR, v="0.5")
X = 1.0  # scaled: v = 0.5


@cache
def region() -> Region:
    return region_of(scope_of(PROBLEM, {"v": (Fraction("0.45"), Fraction("0.6"))}), ("below", "0.046"))


def starts() -> list[Start]:
    family = region().scope.family
    found = certify(PROBLEM.changed("v", Fraction(X) * family.units[0]), region=("below", "0.046"), check=False)
    unit = float(family.frequency_unit)
    return [Start(X, complex(root.q) / unit, 1e-13, False) for root in found.roots if root.q.real > 0]


def test_a_start_gives_one_line_over_the_range() -> None:
    found, reason = strands(region().matrix, region().room, X, starts()[:1], (), Effort(), lambda *_: None)
    assert reason is None
    (line,) = found
    assert (line.first, line.last, line.on_axis) == ("range", "range", False)
    assert (line.low[0], line.high[1]) == tuple(float(x) for x in (region().scope.low[0], region().scope.high[0]))
    one = line.tube_at(X)
    assert one is not None
    assert one.holds(starts()[0].q, 1e-12, X).all()


@pytest.mark.parametrize(
    "wrong",
    [lambda start: replace(start, radius=0.2), lambda start: replace(start, q=start.q + 2)],
    ids=["a ball that sticks out of every tube", "no root"],
)
def test_what_no_tube_holds_is_stuck(wrong: object) -> None:
    """A ball of which only the middle lies in the first tube may hold another root."""
    first = wrong(starts()[0])  # type: ignore[operator]
    found, _ = strands(region().matrix, region().room, X, [first], (), Effort(), lambda *_: None)
    assert not any(line.first == "range" or line.last == "range" for line in found)


def test_spent_effort_is_a_reason() -> None:
    found, reason = strands(region().matrix, region().room, X, starts(), (), Effort(evaluations=60), lambda *_: None)
    assert reason is not None
    assert reason.code == "effort"
    assert all("stuck" in (line.first, line.last) for line in found)
