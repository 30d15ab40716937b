"""Passings of a border: each is a root on it, and the number that is counted changes there as they say."""

from fractions import Fraction

import pytest
from free_cases import BEAM, LAYERS, PAIR

from mpsolve import Problem, certify, vehicles
from mpsolve.loci.border import Border, border_of
from mpsolve.loci.region import Region, region_of
from mpsolve.numbers.balls import rational_ball
from mpsolve.progress import silent
from mpsolve.proof.effort import Effort
from mpsolve.ranges.scope import scope_of

PROBLEM = Problem(BEAM, PAIR, v="0.9")


@pytest.fixture(scope="module")
def region() -> Region:
    scope = scope_of(PROBLEM, {"v": (Fraction("0.8"), Fraction("1.3"))})
    return region_of(scope, ("below", "0.04"))


@pytest.fixture(scope="module")
def border(region: Region) -> Border:
    return border_of(region.scope, region.sides, 15, Effort(), silent)


def test_counts_change_at_passings(region: Region, border: Border) -> None:
    assert border.reason is None
    assert len(border.passings) > 0
    unit = region.scope.family.units[0]
    for one in border.passings:
        assert one.q.imag.overlaps(rational_ball(region.height))
        before, after = (
            certify(PROBLEM.changed("v", Fraction(x) * unit), region=("below", "0.04"), check=False).count
            for x in (one.ends[0] - 1e-4, one.ends[1] + 1e-4)
        )
        assert before is not None
        assert after is not None
        assert after - before == one.gained


def test_discs_hold_the_balls(border: Border) -> None:
    for one in border.passings:
        middle, radius = one.disc
        assert abs(complex(one.q) - middle) <= radius < 1e-12
        assert one.ends[0] <= float(one.x.mid()) <= one.ends[1]


def test_a_spent_effort_is_a_reason(region: Region) -> None:
    found = border_of(region.scope, region.sides, 15, Effort(evaluations=50), silent)
    assert found.reason is not None
    assert found.reason.code == "effort"


def test_boxes_of_fast_waves_are_halved_along_the_velocity() -> None:
    """Far out waves turn fast with the velocity and hardly with the height: few boxes cover the side of a region."""
    layered = Problem(LAYERS, [vehicles.Mass(900).at(0), vehicles.Mass(900).at("2.5")], v=300)
    region = region_of(scope_of(layered, {"v": (Fraction(100), Fraction(600))}))
    found = border_of(region.scope, region.sides[1:], 15, Effort(evaluations=4000), silent)
    assert found.reason is None
    assert found.passings == ()


def test_a_root_that_comes_in_at_the_side_is_met() -> None:
    """With a reach so short that a root passes it, between two velocities at which it is counted."""
    scope = scope_of(PROBLEM, {"v": (Fraction("0.8"), Fraction("0.9"))})
    short = Region(scope, Fraction("0.04"), Fraction("0.125"))
    found = border_of(scope, short.sides[1:], 15, Effort(), silent)
    assert found.reason is None
    (one,) = found.passings
    assert 0.012 < float(one.q.imag.mid()) < 0.021
    inside = [
        sum(0 < complex(root.q).real < 0.125 for root in certify(PROBLEM.changed("v", v), check=False).roots)
        for v in ("0.8", "0.9")
    ]
    assert inside == [0, 1]
    (cover,) = found.covers
    assert not cover.tree.low[-1].any()  # nothing along a slope, which would reach above the region
    assert 0.8 < float(one.x.mid()) * float(scope.family.units[0]) < 0.9
