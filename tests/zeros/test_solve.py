"""Count, find, sort: the boundary is moved only where it must be, and what stays open has a reason with a code."""

from __future__ import annotations

import pytest
from flint import acb, arb

from mpsolve.numbers.rootball import RootBall
from mpsolve.progress import silent
from mpsolve.proof.effort import Effort
from mpsolve.zeros.read import read_function
from mpsolve.zeros.regions import Disc, Polygon, Rectangle, Region
from mpsolve.zeros.solve import Solved, _overlap, solve


def solved(text: str, region: Region, evaluations: int = 50_000) -> Solved:
    return solve(read_function(text, None, False), region, (), 15, Effort(evaluations=evaluations), silent)


def test_zeros_outside_a_disc_but_in_its_polygon_are_left_out() -> None:
    found = solved("(z - 0.997175 - 0.098213*i)*(z - 0.9)*exp(z)", Disc(0, 1))
    assert found.count is not None
    assert [len(found.balls), len(found.inside), found.note] == [2, 1, ""]


def test_balls_that_meet_are_seen_across_a_small_one_between_them() -> None:
    wide, small, beside = (
        RootBall(acb(arb(x, r), y), -20) for x, y, r in ((0, 0, 2.0**-30), (0.5, 1, 2.0**-30), (1, 0, 2))
    )
    assert _overlap([wide, small, beside])
    assert not _overlap([wide, small])


def test_a_zero_on_the_boundary_moves_it() -> None:
    found = solved("z**2 - 1", Rectangle(-1, 1, -1, 1))
    assert len(found.inside) == 2
    assert "larger" in found.note
    assert found.region != Rectangle(-1, 1, -1, 1)
    corner = solved("z - 2", Polygon([0, 2, 1 + 1j]))
    assert len(corner.inside) == 1


def test_a_branch_point_on_the_boundary_moves_it_inwards() -> None:
    found = solved("sqrt(z) - 1/2", Rectangle(0, 1, -1, 1))
    assert found.reason is None
    assert "smaller" in found.note
    assert found.region.polygon[0][0] > 0


@pytest.mark.parametrize(
    ("text", "region", "code"),
    [
        ("sqrt(z) - 1/2", Rectangle(-1, 1, -1, 1), "not-analytic"),
        ("exp(1/z)", Rectangle(-1, 1, -1, 1), "pole"),
        ("sin(z)/z", Rectangle(-1, 1, -1, 1), "common-zero"),
        ("z - 2", Polygon([-1, 4, 4 + 4j, 2 + 1j, -1 + 4j]), None),
        ("exp(500*z) - 1", Rectangle(-1, 1, -1, 1), "effort"),
    ],
)
def test_what_stays_open_has_a_reason(text: str, region: Region, code: str | None) -> None:
    found = solved(text, region, 5000 if code != "effort" else 20)
    if code is None:  # its zero lies on an edge of a polygon that is not convex
        assert found.reason is not None
        assert found.reason.code == "zero-on-boundary"
        return
    assert found.reason is not None
    assert found.reason.code == code
    assert found.reason.remedy
