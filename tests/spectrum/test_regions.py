"""Regions: what a user may give, exact bounds, words."""

from __future__ import annotations

import pickle
from copy import copy, deepcopy
from fractions import Fraction

import pytest

from mpsolve import Case, Problem, certify, frequencies, roots, tracks, vehicles
from mpsolve.errors import InputError
from mpsolve.spectrum.regions import Below, HalfPlane, Rectangle, Sheet, checked_region


def test_bounds_are_exact() -> None:
    box = Rectangle("0.1", "1/3", -1, 0.2)
    assert box.bounds == (Fraction(1, 10), Fraction(1, 3), -1, Fraction(1, 5))
    assert box.as_dict() == {"re_min": "1/10", "re_max": "1/3", "im_min": "-1", "im_max": "1/5"}
    assert box == Rectangle("1/10", "1/3", "-1", "0.2")
    assert len({box, Rectangle("0.10", "1/3", -1, "0.2")}) == 1
    assert pickle.loads(pickle.dumps(box)) == box
    assert str(box) == "0.1 < Re q < 0.333333, -1 < Im q < 0.2"


@pytest.mark.parametrize(
    ("bounds", "key"),
    [
        ((1, 1, 0, 1), "region.re_max"),
        ((0, 1, 2, 1), "region.im_max"),
        (("x", 1, 0, 1), "region.re_min"),
        ((0, "root4(2)", 0, 1), "region.re_max"),
        ((0, 1, float("nan"), 1), "region.im_min"),
    ],
)
def test_no_rectangle(bounds: tuple[object, ...], key: str) -> None:
    with pytest.raises(InputError) as caught:
        Rectangle(*bounds)
    assert caught.value.key == key


def test_what_a_user_gives() -> None:
    box = Rectangle(0, 1, 0, 1)
    assert checked_region("sheet") == "sheet"
    assert checked_region("unstable") == "unstable"
    assert checked_region(("below", "0.5")) == Below(Fraction(1, 2))
    assert checked_region(box) is box
    assert checked_region(Below(Fraction(2))) == Below(Fraction(2))
    assert checked_region(Below(0.5)) == Below(Fraction(1, 2))  # type: ignore[arg-type]
    low = Below(Fraction(-1, 9))
    for wrong in ("lower", ("below",), ("below", 1, 2), ("above", 1), None, 5, ["below", 1], ("below", -1), low):
        with pytest.raises(InputError) as caught:
            checked_region(wrong)
        assert caught.value.key == "region"


def test_words() -> None:
    assert str(Sheet()) == "the whole physical sheet"
    assert (str(HalfPlane()), str(HalfPlane(Fraction(3)))) == ("Im q < 0", "Im q < 0, |q| < 3")
    assert str(Below(Fraction(1, 2), Fraction(8))) == "Im q < 0.5 where |Re q| < 8, or Im q < 0"
    assert str(Below(Fraction(1), Fraction(8), Fraction(8))) == "Im q < 1 where |Re q| < 8, or Im q < 0, |q| < 8"


def test_heights_and_bounds_may_have_units_in_si() -> None:
    """A case of the paper has ratios, whose units would mean nothing; neither have zeros of a function."""
    wire = Problem(tracks.String(T=27000, m="1.07", k=500, c=2), vehicles.Mass("8.5"), v=100)
    case = Case(alpha="0.5", eta_b="0.1", eta_m=[1], positions=[0])
    box = Rectangle("-60 rad/min", "1 rad/s", "-1/2", "30 1/min")
    assert (box, box.has_units) == (Rectangle(-1, 1, "-1/2", "1/2"), True)
    assert pickle.loads(pickle.dumps(copy(box))) == deepcopy(box) == box
    assert "Fraction(1, 2)" in repr(box)
    assert checked_region(("below", "30 1/min"), wire) == Below(Fraction(1, 2))
    assert checked_region(box, wire) is box
    for region, key in ((("below", "30 1/min"), "region"), (box, "region.re_min")):
        with pytest.raises(InputError, match="a Case holds the paper's ratios") as caught:
            certify(case, region=region)
        assert caught.value.key == key
    with pytest.raises(InputError, match="z is a bare number"):
        roots("z^2 - 1", box)
    for wrong in ("50 Hz", "50 m"):
        with pytest.raises(InputError, match=r"^region"):
            checked_region(("below", wrong), wire)
        with pytest.raises(InputError, match=r"^region.re_min"):
            Rectangle(wrong, 60, 0, 1)


def test_the_engine_and_the_arrays_take_them() -> None:
    wire = Problem(tracks.String(T=27000, m="1.07", k=500, c=2), vehicles.Mass("8.5"), v=100)
    assert certify(wire, region=("below", "54 1/min"), check=False).count == 2
    assert certify(wire, region=Rectangle("900 1/min", 16, 0, "54 1/min"), check=False).count == 1
    assert frequencies(wire, {"v": [100]}, ("below", "54 1/min")).count.tolist() == [2]
