"""Crossings of lines Im q = h: the certified number of roots below changes there, for lines on both sides of 0."""

from __future__ import annotations

from dataclasses import replace
from fractions import Fraction
from types import SimpleNamespace

import pytest
from followed_root import HEIGHT, LOWEST, ROOT, plain_scope
from ranges_of_a_pair import PAIR, over_velocity

from mpsolve import certify
from mpsolve.numbers.balls import acb, arb
from mpsolve.progress import silent
from mpsolve.proof.effort import Effort
from mpsolve.ranges.curves import RootCurve
from mpsolve.ranges.enclosed import Crossing
from mpsolve.ranges.line import cross_line, follow, stretch
from mpsolve.ranges.stationary import lowest_near
from mpsolve.spectrum.regions import Below


def below(v: float, height: float) -> int:
    """Certified roots with Im q < h, among those with |Re q| < reach where h > 0."""
    region = "unstable" if height <= 0 else Below(Fraction(height))
    roots = certify(PAIR.changed("v", v), region=region, check=False).roots
    return sum(root.multiplicity for root in roots if float(root.q.imag) < height)


@pytest.mark.parametrize(("height", "reach"), [("-0.1", None), ("0", None), ("0.04", 2.0)])
def test_the_count_changes_at_each_crossing(height: str, reach: float | None) -> None:
    scope = over_velocity()
    family = scope.family
    h = float(height)
    scaled = Fraction(height) / family.frequency_unit
    line = cross_line(family, scaled, reach, [], Effort(), silent)
    assert line.reason is None
    assert line.crossings
    for one in line.crossings:
        v = float(one.x.mid()) * float(family.units[0])
        assert below(v + 1e-3, h) - below(v - 1e-3, h) == one.gained
    total = sum(one.gained or 0 for one in line.crossings)
    assert below(230, h) - below(150, h) == total


BOX = SimpleNamespace(family=SimpleNamespace(box=((Fraction(1), Fraction(5)),)))


@pytest.mark.parametrize(
    ("gained", "ends"),
    [
        ((2, -2), (2, 4)),
        ((2,), (2, 5)),
        ((-2,), (1, 2)),
        ((), (1, 5)),
        ((2, 2), None),
        ((-2, 2), None),
        ((None,), None),
    ],
)
def test_where_a_root_is_below_the_line(gained: tuple[int | None, ...], ends: tuple[int, int] | None) -> None:
    crossings = tuple(Crossing(arb(1), arb(x), one) for x, one in zip((2, 4), gained, strict=False))
    found = stretch(SimpleNamespace(crossings=crossings, scope=BOX), 2)  # type: ignore[arg-type]
    assert (found is None) if ends is None else [float(x) for x in found] == list(ends)  # type: ignore[union-attr]


def test_the_lowest_root_is_followed_between_its_crossings() -> None:
    """A root that crosses elsewhere is not the one that is followed."""
    scope = plain_scope()
    line = cross_line(scope.family, Fraction(-HEIGHT), None, [], Effort(), silent)
    ends = stretch(line, 2)
    assert ends is not None
    assert ends[0] < LOWEST < ends[1]
    whole = tuple(arb(float(x)) for x in scope.family.box[0])
    found = lowest_near(RootCurve(scope.proved), (acb(ROOT),), LOWEST, whole, 0.01)
    assert found.where == "inside"
    tube = follow(line, found, ends)
    assert tube is not None
    assert all(tube.holds(one.q, one.x) for one in line.crossings)
    other = replace(line, crossings=tuple(replace(one, q=one.q * 1.1) for one in line.crossings))
    assert follow(other, found, ends) is None
