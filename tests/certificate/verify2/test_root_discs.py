"""Roots in discs: each where the claim says, apart from the others, on one side of the axis."""

from __future__ import annotations

import pytest
from flint import acb_mat, arb_mat, fmpq
from forging import as_file, stored

from mpsolve.certificate import verify2 as v2


def reason(value):
    return v2.verify_bytes(as_file(value)).reason


def root(x, y, r=-20, pair=False, multiplicity=1):
    """The ball round (x + iy)/64 with the radius 2^r."""
    return {"re": hex(x), "im": hex(y), "exponent": -6, "radius": [1, r], "multiplicity": multiplicity, "pair": pair}


def region(kind, **numbers):
    return v2.read_region({"kind": kind, **numbers})


UNSTABLE, STRIP = region("unstable"), region("below", height="1/4", reach="2")
DISC, BOX = region("disc", radius="2"), region("rectangle", re=["-1", "2"], im=["-1", "1"])
SHEET = region("sheet")
OUTSIDE = {
    "above the axis": (UNSTABLE, [root(0, 1)], "root 0 is not inside"),
    "on the axis": (UNSTABLE, [root(0, 0)], "root 0 is not inside"),
    "across the axis": (UNSTABLE, [root(0, -1, -5)], "root 0 is not inside"),
    "the second one": (UNSTABLE, [root(0, -9), root(64, 1, pair=True)], "root 1 is not inside"),
    "above the strip": (STRIP, [root(64, 17, pair=True)], "root 0 is not inside"),
    "beside the strip": (STRIP, [root(129, 1, pair=True)], "root 0 is not inside"),
    "beyond the disc": (DISC, [root(91, -91, pair=True)], "root 0 is not inside"),
    "across the circle": (DISC, [root(0, -127, -5)], "root 0 is not inside"),
    "over the circle's middle": (DISC, [root(0, -127, 2)], "root 0 is not inside"),
    "left of the rectangle": (BOX, [root(-65, 0)], "root 0 is not inside"),
    "above the rectangle": (BOX, [root(0, 65)], "root 0 is not inside"),
    "a mirror left of the rectangle": (BOX, [root(65, 0, pair=True)], "root 0 is no pair inside"),
    "a pair across the imaginary axis": (UNSTABLE, [root(1, -9, -5, pair=True)], "root 0 is no pair"),
    "a pair on the left": (UNSTABLE, [root(-9, -9, pair=True)], "root 0 is no pair"),
    "half a pair": (SHEET, [root(9, 9)], "root 0 is neither"),
    "one twice": (SHEET, [root(9, 9, pair=True), root(9, 9, pair=True)], "overlap"),
    "two that touch": (SHEET, [root(0, 0, -4), root(0, 8, -4)], "overlap"),
    "one in the mirror of another": (BOX, [root(9, 9, pair=True), root(-9, 9)], "overlap"),
}


@pytest.mark.parametrize("name", OUTSIDE)
def test_balls_that_are_not_where_they_should_be_are_refused(monkeypatch, name):
    """Whatever they hold."""
    where, values, why = OUTSIDE[name]
    monkeypatch.setattr(v2, "check_root", lambda *_: None)
    assert v2.check_roots([root(0, -9), root(9, -9, pair=True)], where, None, None, None)[1].number == 2
    with pytest.raises(v2.Refused, match=why):
        v2.check_roots(values, where, None, None, None)


def test_balls_inside_their_region(monkeypatch):
    monkeypatch.setattr(v2, "check_root", lambda *_: None)
    for where in (UNSTABLE, STRIP, DISC, BOX, SHEET):
        fine = [root(0, -9, -5), root(31, -31, -5, pair=True), root(0, -40, multiplicity=2)]
        assert sum(one.number for one in v2.check_roots(fine, where, None, None, None)) == 5
    assert v2.check_roots([root(127, 15, pair=True)], STRIP, None, None, None)
    assert v2.check_roots([root(-63, 0), root(127, 63)], BOX, None, None, None)


def test_a_pair_is_true_or_false():
    for pair in (1, 0, None, "true"):
        with pytest.raises(v2.Refused, match="not true or false"):
            v2.read_root(root(9, 9, pair=pair))


# --- the claim ------------------------------------------------------------------------------------------------


def _beside_the_axis(c):
    """Its ball holds a real root, and is not its own mirror."""
    one = c["roots"][0]
    one["im"], one["radius"][1] = "0x1", one["radius"][1] + 4


def _double(c):
    c["roots"][0]["multiplicity"] = 2
    c["roots"].pop()


def _below(c):
    c["claim"]["unstable"] = 2


def _a_root_less(c):
    c["roots"].pop()


def _more(c):
    c["claim"]["count"] += 1


def _from_the_axis(c):
    c["start"] = [0, 0]


def _from_above(c):
    c["start"] = [-1, -9]


FORGERIES = {
    "a ball across the axis": ("undamped_subcritical", _beside_the_axis, "either side of the real axis"),
    "fewer balls than roots": ("undamped_subcritical", _a_root_less, "names 2 of 4"),
    "more roots than there are": ("undamped_subcritical", _more, "the number of roots is 4"),
    "some below that are not": ("undamped_subcritical", _below, "0 roots have Im q < 0"),
    "a start on the axis": ("rectangle", _from_the_axis, "start is not below"),
    "a start above the axis": ("rectangle", _from_above, "start is not below"),
}


@pytest.mark.parametrize("name", FORGERIES)
def test_a_forgery_is_refused(name):
    file, change, why = FORGERIES[name]
    value = stored(file)
    change(value)
    assert why in reason(value)


def test_a_real_root_of_a_damped_vehicle_is_not_told_from_a_ball(monkeypatch):
    """Without damping q and q̄ are roots together, so that one alone in a ball round a real number is real."""
    value = stored("undamped_subcritical")
    assert reason(value) == ""
    monkeypatch.setattr(v2, "count_sheet", lambda *_: 4)
    monkeypatch.setattr(v2, "check_root", lambda *_: None)
    value["equations"]["vehicle"]["C"][0][0] = "1"
    assert "either side" in reason(value)
    value = stored("undamped_subcritical")
    _double(value)
    assert "either side" in reason(value)


# --- proofs of one disc -----------------------------------------------------------------------------------------


def test_as_many_zeros_as_claimed_or_none():
    nothing = arb_mat([[0, 0], [0, 0]])
    one = [acb_mat([[1, 0], [0, 0]]), acb_mat([[0, 0], [0, "0.1"]])]  # det = u/10
    v2.check_zeros((one, nothing), 1)
    for forms, m in ((one, 2), ([acb_mat([[1, 0], [0, 2]]), one[1]], 1), ([one[0], acb_mat(2, 2)], 1)):
        with v2.precision(64), pytest.raises(v2.Refused, match=r"as many roots|kernel|singular"):
            v2.check_zeros((forms, nothing), m)
    with pytest.raises(v2.Refused, match="without its kernel"):
        v2.block((one, arb_mat([[2, 0], [0, 2]])), 1)


def test_discs_that_only_just_do_not_meet():
    def apart(*discs):
        v2.require_apart([((fmpq(x), fmpq(y)), fmpq(r)) for x, y, r in discs], "meet")

    apart((0, 0, 2), (3, 4, "29/10"), (-5, 0, "29/10"))
    for wrong in ([(0, 0, 2), (3, 4, 3)], [(0, 0, 2), (9, 9, 1), (0, 1, "1/2")], [(1, 0, 1), (-1, 0, 1)]):
        with pytest.raises(v2.Refused, match="meet"):
            apart(*wrong)
