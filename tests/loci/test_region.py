"""The region of all values: heights below every cut of the range, and its edges."""

from fractions import Fraction

import pytest
from free_cases import BEAM, LAYERS, PAIR

from mpsolve import Problem
from mpsolve.errors import InputError
from mpsolve.loci.region import region_of
from mpsolve.ranges.enclosed import REAL_AXIS
from mpsolve.ranges.scope import scope_of
from mpsolve.tracks.at_rest import lowest_cut

PROBLEM = Problem(BEAM, PAIR, v="0.9")


def test_the_height_is_below_the_cuts_of_all_values() -> None:
    """The beam's cuts lie at c/2: the least c of the range decides."""
    scope = scope_of(PROBLEM, {"track.c": (Fraction("0.06"), Fraction("0.2"))})
    height = region_of(scope).height * scope.family.frequency_unit
    assert Fraction("0.02") < height < Fraction("0.03")
    with pytest.raises(InputError, match="cuts"):
        region_of(scope, ("below", "0.031"))
    assert region_of(scope, ("below", "0.0299")).height


def test_boxes_stand_on_the_height_itself() -> None:
    """They are floats: a height that is none would be that of another line."""
    scope = scope_of(PROBLEM, {"v": (Fraction("0.5"), Fraction("0.6"))})
    for asked in ("0.04", "0.03", "1/30"):
        region = region_of(scope, ("below", asked))
        top, right = region.sides
        assert -Fraction(top.edge.origin.real) == region.height == -Fraction(right.low)
        assert 0 <= Fraction(asked) - region.height * scope.family.frequency_unit < Fraction(1, 10**17)
        assert region.answered.height == region.height * scope.family.frequency_unit


def test_a_track_that_stays_has_the_height_of_certify() -> None:
    scope = scope_of(PROBLEM, {"v": (Fraction("0.5"), Fraction("0.6"))})
    height = region_of(scope).height * scope.family.frequency_unit
    assert height == pytest.approx(float(lowest_cut(BEAM)[0]) * 15 / 16, rel=1e-6)


def test_edges_go_round_the_region() -> None:
    scope = scope_of(Problem(LAYERS, PAIR, v=300), {"v": (Fraction(200), Fraction(300))})
    region = region_of(scope)
    top, right = region.sides
    assert top.edge.im == region.height
    assert top.edge.mirrored
    assert (right.low, right.high) == (-float(region.height), 0.0)
    assert right.edge.re == region.reach >= Fraction(scope.X)
    (axis,) = region_of(scope, "unstable").sides
    assert axis.edge == REAL_AXIS
    assert (right.low, right.high) == (-float(region.height), 0.0)
