"""Crossings of lines Im q = h: the certified number of roots below changes there, for lines on both sides of 0."""

from __future__ import annotations

from fractions import Fraction

import pytest
from ranges_of_a_pair import PAIR, over_velocity

from mpsolve import certify
from mpsolve.progress import silent
from mpsolve.proof.effort import Effort
from mpsolve.ranges.line import cross_line
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
